import { Vector3 } from 'three';

/** The chosen creature's body for fingers: which bone of it a ray meets. */
export class Touch {
  #capsules = new Float32Array(0);
  #parts = [];
  #body = null;

  constructor(library, herd) {
    Object.assign(this, { library, herd });
  }

  /** Learns a new body by its colliders. */
  async learn() {
    const member = this.herd.members.get(0);
    const [bytes, parts] = [await this.library.call('Capsules', 0), JSON.parse(await this.library.call('Parts', 0))];
    if (this.herd.members.get(0) === member) {
      this.#capsules = new Float32Array(bytes.buffer, bytes.byteOffset, bytes.byteLength / 4);
      this.#parts = parts;
      this.#body = member.body;
    }
  }

  /** The bone that a ray meets first: its joint, its part of the body and where; null for none. `room` is added to every radius. */
  hit(ray, room) {
    const body = this.#body;
    if (!body || this.herd.members.get(0)?.body !== body) {
      return null;
    }
    const local = ray.clone().applyMatrix4(body.group.matrixWorld.clone().invert());
    let best = null;
    let nearest = Infinity;
    const [a, b, onRay, onBone] = [new Vector3(), new Vector3(), new Vector3(), new Vector3()];
    for (let at = 0; at < this.#capsules.length; at += 8) {
      const joint = this.#capsules[at];
      body.carry(joint, a.fromArray(this.#capsules, at + 1));
      body.carry(joint, b.fromArray(this.#capsules, at + 4));
      const apart = Math.sqrt(local.distanceSqToSegment(a, b, onRay, onBone));
      const far = onRay.distanceTo(local.origin) - this.#capsules[at + 7];
      if (apart < this.#capsules[at + 7] + room && far < nearest) {
        nearest = far;
        best = { joint, part: this.#parts[joint], place: onBone.clone().applyMatrix4(body.group.matrixWorld) };
      }
    }
    return best;
  }
}
