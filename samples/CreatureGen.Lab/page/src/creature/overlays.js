import { BufferAttribute, BufferGeometry, CapsuleGeometry, CircleGeometry, Group, LineBasicMaterial, LineSegments, Mesh, MeshBasicMaterial, Points, PointsMaterial, Quaternion, Vector3 } from 'three';

const up = new Vector3(0, 1, 0);

/** Draws what is under the skin of a creature: its joints and bones, or the capsules of its colliders. */
export class Overlay {
  #update = null;

  constructor() {
    this.group = new Group();
    this.group.renderOrder = 5;
  }

  clear() {
    this.group.removeFromParent();
    this.group.traverse(part => {
      part.geometry?.dispose();
      part.material?.dispose();
    });
    this.group.clear();
    this.#update = null;
  }

  /** Bones as lines from joint to joint. */
  bones(body) {
    this.clear();
    const { parents, restPositions, joints } = body.mesh;
    const places = Array.from({ length: joints }, (_, j) => new Vector3());
    const lines = new Float32Array(6 * joints);
    const dots = new Float32Array(3 * joints);
    const geometry = new BufferGeometry().setAttribute('position', new BufferAttribute(lines, 3));
    const dotted = new BufferGeometry().setAttribute('position', new BufferAttribute(dots, 3));
    const bone = new LineSegments(geometry, new LineBasicMaterial({ color: '#ffffff', depthTest: false, transparent: true }));
    const joint = new Points(dotted, new PointsMaterial({ color: '#ff6a3d', size: 6, sizeAttenuation: false, depthTest: false, transparent: true }));
    bone.frustumCulled = joint.frustumCulled = false;
    this.group.add(bone, joint);
    body.group.add(this.group);
    this.#update = () => {
      for (let j = 0; j < joints; j++) {
        body.carry(j, places[j].fromArray(restPositions, 3 * j)).toArray(dots, 3 * j);
        const from = places[Math.max(parents[j], 0)];
        from.toArray(lines, 6 * j);
        places[j].toArray(lines, 6 * j + 3);
      }
      geometry.attributes.position.needsUpdate = dotted.attributes.position.needsUpdate = true;
    };
    this.update();
  }

  /** Colliders: joint, start, end, radius; eight numbers each. */
  capsules(body, numbers) {
    this.clear();
    const parts = [];
    const material = new MeshBasicMaterial({ color: '#1f6f8b', wireframe: true, transparent: true, opacity: 0.5 });
    for (let at = 0; at < numbers.length; at += 8) {
      const [start, end] = [new Vector3().fromArray(numbers, at + 1), new Vector3().fromArray(numbers, at + 4)];
      const mesh = new Mesh(new CapsuleGeometry(numbers[at + 7], start.distanceTo(end), 4, 10), material);
      mesh.frustumCulled = false;
      parts.push({ mesh, joint: numbers[at], start, end });
      this.group.add(mesh);
    }
    body.group.add(this.group);
    const [a, b, way, turn] = [new Vector3(), new Vector3(), new Vector3(), new Quaternion()];
    this.#update = () => {
      for (const { mesh, joint, start, end } of parts) {
        body.carry(joint, a.copy(start));
        body.carry(joint, b.copy(end));
        mesh.position.addVectors(a, b).multiplyScalar(0.5);
        way.subVectors(b, a);
        mesh.quaternion.copy(way.lengthSq() > 1e-12 ? turn.setFromUnitVectors(up, way.normalize()) : turn.identity());
      }
    };
    this.update();
  }

  /** Where feet stand, and how much of the weight each carries. */
  feet(member) {
    this.clear();
    const discs = member.feet.map(() => {
      const disc = new Mesh(new CircleGeometry(1, 28).rotateX(-Math.PI / 2), new MeshBasicMaterial({ color: '#ff6a3d', transparent: true, opacity: 0.75, depthTest: false }));
      this.group.add(disc);
      return disc;
    });
    member.body.group.parent.add(this.group);
    const size = 0.035 * Math.max(member.facts.height, 0.5 * member.facts.length);
    this.#update = () => discs.forEach((disc, n) => {
      const foot = member.feet[n];
      disc.visible = !!foot && foot[3] > 0;
      if (disc.visible) {
        disc.position.set(foot[0], foot[1] + 0.1 * size, foot[2]);
        disc.scale.setScalar(size * (0.6 + 2.2 * Math.sqrt(foot[3])));
      }
    });
    this.update();
  }

  update() {
    this.#update?.();
  }
}
