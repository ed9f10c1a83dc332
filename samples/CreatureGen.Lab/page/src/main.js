import { NeutralToneMapping, PCFShadowMap, WebGLRenderer, Vector3 } from 'three';
import { Library } from './library.js';
import { World } from './world/world.js';
import { Herd } from './creature/herd.js';
import { Orbit } from './view/orbit.js';
import { ofSeed, readAddress, traitText } from './design.js';
const library = new Library();
const canvas = document.querySelector('canvas');
const renderer = new WebGLRenderer({ canvas, antialias: true });
renderer.toneMapping = NeutralToneMapping;
renderer.toneMappingExposure = 1;
renderer.shadowMap.enabled = true;
renderer.shadowMap.type = PCFShadowMap;
const world = new World(renderer);
const herd = new Herd(library, world.scene);
const orbit = new Orbit();
function size() { renderer.setSize(innerWidth, innerHeight, false); orbit.fit(innerWidth, innerHeight, { right: 340, bottom: 0 }); }
size();
const q = new URLSearchParams(location.search);
async function start() {
  await library.ready;
  const facts = JSON.parse(await library.call('Grow', 0, q.get('seed') ?? '42', q.get('kind') ?? 'walking', 0, ''));
  const unit = Math.max(facts.height, 0.45 * facts.length) / 1.15;
  world.show(facts.medium === 'water' ? 'sea' : 'meadow', unit);
  const f = world.heightField();
  await library.call('Ground', new Uint8Array(f.heights.buffer), f.columns, f.cell, f.corner);
  await library.call('Place', 0, 0, 0, 0, 0);
  await herd.settle(0, facts);
  await herd.step(0.016);
  if (q.get('tex')) { const m = await library.call('TexturedMesh', 0); const t = await library.call('Textures', 0, 512); const { readMesh } = await import('./creature/body.js'); herd.members.get(0).body.texture(readMesh(m.buffer, m.byteOffset), t, 512); }
  const p = herd.members.get(0).body.group.position;
  const lift = facts.medium === 'ground' ? 0.5 * facts.height : 0.3*facts.height;
  orbit.frame(new Vector3(p.x, p.y + lift, p.z), facts.length, 2.4 * Math.max(facts.length * 0.8, facts.height) + 1.2*unit);
  orbit.jump();
  window.facts = facts;
  window.shot = async n => { for (let i = 0; i < n; i++) await herd.step(0.033); orbit.update(0.03, world); world.update(0.5, orbit.focus); const t = performance.now(); renderer.render(world.scene, orbit.camera); const gl = renderer.getContext(); gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4)); return performance.now() - t; };
  window.orbit = orbit;
}
window.creatureLab = { ready: start(), glb: (seed, kind) => library.call('GlbOfSeed', String(seed), kind), library };
