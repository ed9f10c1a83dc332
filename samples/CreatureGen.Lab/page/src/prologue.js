import { Vector3 } from 'three';
import { Body, readMesh } from './creature/body.js';

/** The baked creature that is seen while the library starts. Returns what stops it. */
export async function showFirst(herd, world, orbit) {
  const answer = await fetch('./first.bin');
  if (!answer.ok) {
    return () => {};
  }
  const buffer = await answer.arrayBuffer();
  const [meshBytes, frames, joints] = new Int32Array(buffer, 0, 4);
  const body = new Body(readMesh(buffer, 16));
  const poses = new Uint16Array(buffer, 16 + meshBytes, frames * joints * 16);
  const matrices = new Float32Array(16 * joints);
  let height = 0;
  let length = 0;
  const p = body.mesh.positions;
  for (let i = 0; i < p.length; i += 3) {
    height = Math.max(height, p[i + 1]);
    length = Math.max(length, 2 * Math.abs(p[i + 2]));
  }
  const unit = Math.max(height, 0.42 * length) / 1.15;
  world.show('meadow', unit);
  const member = herd.put(0, { height, length, medium: 'ground' }, body);
  body.group.position.set(0, world.heightAt(0, 0), 0);
  body.group.rotation.y = 0.12;
  body.group.visible = true;
  orbit.frame(new Vector3(0, body.group.position.y + 0.52 * height, 0), Math.max(length, height), 2.1 * Math.max(0.72 * length, height) + 1.5 * unit);
  orbit.jump();
  const begin = performance.now();
  return () => {
    if (herd.members.get(0) === member) {
      const frame = Math.floor(((performance.now() - begin) / 1000) * 12) % frames;
      for (let i = 0; i < matrices.length; i++) {
        matrices[i] = half(poses[frame * matrices.length + i]);
      }
      body.pose(matrices);
    }
  };
}

function half(bits) {
  const exponent = (bits >> 10) & 31;
  const fraction = bits & 1023;
  const value = exponent === 0 ? fraction / 16777216 : (1 + fraction / 1024) * 2 ** (exponent - 15);
  return bits & 32768 ? -value : value;
}
