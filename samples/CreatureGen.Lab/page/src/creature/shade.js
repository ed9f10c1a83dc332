import { BufferAttribute, CircleGeometry, Mesh, MeshBasicMaterial } from 'three';

const edges = 24;
const darkest = 0.42;
const wide = 0.34;
const lift = 0.015;

let geometry = null;
let material = null;

/** A dark patch that stands for a creature's shadow where shadows are not drawn: darkest in its middle, nothing at its rim. */
export class Shade {
  constructor() {
    geometry ??= soft();
    material ??= new MeshBasicMaterial({ color: '#0d1f10', transparent: true, vertexColors: true, depthWrite: false });
    this.mesh = new Mesh(geometry, material);
    this.mesh.visible = false;
  }

  /** Lies on the land below a member; the higher it is, the smaller. */
  follow(member, world, shown) {
    const { facts, body } = member;
    const { position, quaternion } = body.group;
    this.mesh.visible = shown && body.group.visible && facts.medium !== 'water' && Number.isFinite(world.waterLevel);
    if (this.mesh.visible) {
      const land = world.heightAt(position.x, position.z);
      const nearness = 1 / (1 + Math.max(position.y - land, 0) / Math.max(facts.height, 1e-3));
      this.mesh.position.set(position.x, Math.max(land, world.waterLevel) + lift * world.scale, position.z);
      this.mesh.quaternion.copy(quaternion);
      this.mesh.scale.set(wide * Math.max(0.6 * facts.length, facts.height) * nearness, 1, wide * 1.5 * facts.length * nearness);
    }
  }
}

function soft() {
  const disc = new CircleGeometry(1, edges).rotateX(-Math.PI / 2);
  const colours = new Float32Array(4 * disc.attributes.position.count).fill(1);
  for (let n = 0; n < disc.attributes.position.count; n++) {
    // The first is the middle.
    colours[4 * n + 3] = n === 0 ? darkest : 0;
  }
  return disc.setAttribute('color', new BufferAttribute(colours, 4));
}
