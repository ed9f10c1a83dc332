import { CircleGeometry, DirectionalLight, HemisphereLight, Mesh, MeshBasicMaterial, NeutralToneMapping, PerspectiveCamera, Scene, Vector3, WebGLRenderer } from 'three';
import { animatedPng } from '../apng.js';
import { Body, readMesh } from '../creature/body.js';
import { Herd } from '../creature/herd.js';

const slot = 3;
const side = 360;
const frameSeconds = 1 / 18;
const settleSeconds = 2.5;
const longestSeconds = 2.4;

/** A creature's gait as a picture that moves: one cycle, without a beginning or an end, on nothing but its shadow. */
export async function loopPicture(library, text) {
  const scene = new Scene();
  const renderer = new WebGLRenderer({ antialias: true, alpha: true });
  const herd = new Herd(library, scene);
  herd.eye = slot;
  try {
    const facts = JSON.parse(await library.call('GrowText', slot, text, ''));
    await library.call('Place', slot, 0, 0, 0, 0);
    await library.call('Habit', slot, 'march', 0, 0, 1);
    const bytes = await library.call('Mesh', slot);
    const member = herd.put(slot, facts, new Body(readMesh(bytes.buffer, bytes.byteOffset)));
    stage(renderer, scene, facts);
    const camera = eye(facts);
    for (let t = 0; t < settleSeconds; t += 0.05) {
      await herd.step(0.05);
    }
    const cycle = await cycleOf(herd, member);
    const count = Math.max(8, Math.round(cycle / frameSeconds));
    const flat = new OffscreenCanvas(side, side).getContext('2d', { willReadFrequently: true });
    const frames = [];
    const start = member.body.group.position.y;
    for (let n = 0; n < count; n++) {
      member.body.group.position.set(0, facts.medium === 'ground' ? member.body.group.position.y : member.body.group.position.y - start, 0);
      member.body.group.quaternion.identity();
      renderer.render(scene, camera);
      flat.clearRect(0, 0, side, side);
      flat.drawImage(renderer.domElement, 0, 0);
      frames.push(flat.getImageData(0, 0, side, side).data);
      await herd.step(cycle / count);
    }
    return await animatedPng(frames, side, side, (1000 * cycle) / count);
  } finally {
    await herd.remove(slot);
    renderer.dispose();
    renderer.forceContextLoss();
  }
}

function stage(renderer, scene, facts) {
  renderer.setSize(side, side, false);
  renderer.setClearAlpha(0);
  renderer.toneMapping = NeutralToneMapping;
  const sun = new DirectionalLight('#fff3da', 3);
  sun.position.set(0.6, 1, 0.7);
  scene.add(sun, new HemisphereLight('#d8ecf6', '#9aa86a', 2.2));
  if (facts.medium === 'ground') {
    const shadow = new Mesh(new CircleGeometry(0.5, 48).rotateX(-Math.PI / 2).scale(0.7 * facts.length, 1, 1.05 * facts.length), new MeshBasicMaterial({ color: '#1c2a22', transparent: true, opacity: 0.16, depthWrite: false }));
    scene.add(shadow);
  }
}

function eye(facts) {
  const camera = new PerspectiveCamera(26, 1, 0.01, 500);
  const focus = new Vector3(0, (facts.medium === 'ground' ? 0.48 : 0.2) * facts.height, 0);
  const far = 2.6 * Math.max(0.8 * facts.length, facts.height);
  camera.near = far / 50;
  camera.far = far * 10;
  camera.position.set(0.72 * far, focus.y + 0.2 * far, 0.62 * far);
  camera.lookAt(focus);
  camera.updateProjectionMatrix();
  return camera;
}

/** Seconds of one cycle of the gait, from where its phase begins anew; a standing second for what has none. */
async function cycleOf(herd, member) {
  const step = 1 / 60;
  let before = member.phase;
  let begun = null;
  for (let t = 0; t < 2 * longestSeconds; t += step) {
    await herd.step(step);
    if (member.phase < before - 0.5) {
      const passed = 1 - before;
      const at = t + step * (passed / Math.max(passed + member.phase, 1e-6));
      if (begun !== null) {
        return at - begun;
      }
      begun = at;
    }
    before = member.phase;
  }
  return 1;
}
