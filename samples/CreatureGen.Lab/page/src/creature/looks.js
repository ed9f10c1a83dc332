import { Overlay } from './overlays.js';

/** How the creature is shown: as it is, in facets, as wire, with its bones, its capsules, or with its feet and a gait diagram. */
export class Looks {
  #overlay = new Overlay();

  constructor(library, herd, gaits) {
    Object.assign(this, { library, herd, gaits });
    this.look = 'skin';
  }

  /** How many things are drawn over the creature: bones and joints, capsules, or feet. */
  get marks() {
    return this.#overlay.group.children.length;
  }

  take(look) {
    this.look = look;
    this.show();
  }

  /** Shows the creature that stands there now. */
  show() {
    const { look } = this;
    const member = this.herd.members.get(0);
    const { body } = member;
    this.#overlay.clear();
    body.wireframe = look === 'wire';
    body.flat = look === 'flat';
    this.gaits.shown = look === 'feet';
    body.skin.visible = look !== 'capsules';
    body.skin.material.forEach(material => { material.transparent = look === 'bones'; material.opacity = look === 'bones' ? 0.55 : 1; });
    if (look === 'feet') {
      this.#overlay.feet(member);
    } else if (look === 'bones') {
      this.#overlay.bones(body);
    } else if (look === 'capsules') {
      this.library.call('Capsules', 0).then(bytes => this.#overlay.capsules(body, new Float32Array(bytes.buffer, bytes.byteOffset, bytes.byteLength / 4)));
    }
  }

  update() {
    this.#overlay.update();
  }
}
