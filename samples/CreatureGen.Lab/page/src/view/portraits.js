import { Color, DirectionalLight, HemisphereLight, PerspectiveCamera, Scene, Vector3 } from 'three';
import { h } from '../dom.js';

const pixels = 128;
const quality = 0.85;

/** Small pictures of creatures, for lists and trees. Each is drawn in a corner of the stage's own canvas, right before the stage is drawn over it. */
export class Portraits {
  #wanted = [];
  #scene = new Scene();
  #camera = new PerspectiveCamera(26, 1, 0.01, 100);

  constructor(renderer, herd) {
    Object.assign(this, { renderer, herd });
    const sun = new DirectionalLight('#fff3da', 2.6);
    sun.position.set(0.5, 1, 0.8);
    this.#scene.add(sun, new HemisphereLight('#d8ecf6', '#9aa86a', 2.2));
    this.#scene.background = new Color('#cfe0cd');
  }

  /** A picture of somebody, as an address of data; null if they are gone before it is drawn. */
  take(member) {
    return new Promise(resolve => { this.#wanted.push({ member, resolve }); });
  }

  /** Draws one that is wanted and has its first pose. */
  draw() {
    const n = this.#wanted.findIndex(({ member }) => member.moved || !this.#lives(member));
    if (n < 0) {
      return;
    }
    const [{ member, resolve }] = this.#wanted.splice(n, 1);
    resolve(this.#lives(member) ? this.#picture(member) : null);
  }

  #lives(member) {
    return this.herd.members.get(member.slot) === member;
  }

  #picture({ body, facts: { height, length } }) {
    const { renderer } = this;
    const { group } = body;
    const canvas = renderer.domElement;
    const stage = group.parent;
    const side = pixels / renderer.getPixelRatio();
    this.#frame(body, Math.max(0.72 * length, height));
    this.#scene.add(group);
    renderer.setScissorTest(true);
    renderer.setScissor(0, 0, side, side);
    renderer.setViewport(0, 0, side, side);
    renderer.render(this.#scene, this.#camera);
    stage.add(group);
    renderer.setScissorTest(false);
    renderer.setViewport(0, 0, canvas.width / renderer.getPixelRatio(), canvas.height / renderer.getPixelRatio());
    const square = h('canvas', { width: pixels, height: pixels });
    square.getContext('2d', { alpha: false }).drawImage(canvas, 0, canvas.height - pixels, pixels, pixels, 0, 0, pixels, pixels);
    return square.toDataURL('image/jpeg', quality);
  }

  /** From before it and a little aside, whichever way it looks. */
  #frame(body, size) {
    const far = 2.65 * size;
    const way = new Vector3(0.62, 0.26, 0.74).applyQuaternion(body.group.quaternion).multiplyScalar(far);
    way.y = 0.26 * far;
    const focus = body.middle();
    this.#camera.near = far / 50;
    this.#camera.far = far * 20;
    this.#camera.position.copy(focus).add(way);
    this.#camera.lookAt(focus);
    this.#camera.updateProjectionMatrix();
  }
}
