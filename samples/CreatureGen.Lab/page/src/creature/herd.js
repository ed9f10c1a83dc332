import { Vector3 } from 'three';
import { Body, readMesh } from './body.js';

const headLength = 13;

/** Everybody who lives on the stage: their bodies, by slots, and what the library says of them in each frame. */
export class Herd {
  #buffer = new ArrayBuffer(1 << 17);
  #waiting = false;
  #owed = 0;
  #costs = [];

  constructor(library, scene) {
    this.library = library;
    this.scene = scene;
    this.members = new Map();
    this.eye = 0;
    this.onFootfall = null;
  }

  /** Settles what was grown in a slot. */
  async settle(slot, facts) {
    const bytes = await this.library.call('Mesh', slot);
    return this.put(slot, facts, new Body(readMesh(bytes.buffer, bytes.byteOffset)));
  }

  /** Shows a body in a slot, in place of the one that was there. */
  put(slot, facts, body) {
    const before = this.members.get(slot);
    const member = { slot, facts, body, feet: [], speed: 0, phase: 0, moved: false };
    if (before) {
      body.group.position.copy(before.body.group.position);
      body.group.quaternion.copy(before.body.group.quaternion);
      before.body.dispose();
    }
    // It is seen with its first pose.
    body.group.visible = false;
    this.scene.add(body.group);
    this.members.set(slot, member);
    return member;
  }

  async remove(slot) {
    const member = this.members.get(slot);
    if (member) {
      this.members.delete(slot);
      member.body.dispose();
      await this.library.call('Remove', slot);
    }
  }

  /** The median cost of the library's frames of the last second, milliseconds. */
  frameCost() {
    const now = performance.now();
    this.#costs = this.#costs.filter(cost => now - cost.at < 1000);
    const sorted = this.#costs.map(cost => cost.ms).sort((a, b) => a - b);
    return sorted.length ? sorted[sorted.length >> 1] : 0;
  }

  /** Lets time go on; one frame is under way at most, and what could not be sent is owed. */
  async step(seconds) {
    this.#owed = Math.min(this.#owed + seconds, 0.1);
    if (this.#waiting) {
      return;
    }
    this.#waiting = true;
    const owed = this.#owed;
    this.#owed = 0;
    try {
      const { buffer, cost } = await this.library.frame(owed, this.eye, this.#buffer);
      this.#buffer = buffer;
      this.#costs.push({ at: performance.now(), ms: cost });
      this.#apply(new Float32Array(buffer));
    } finally {
      this.#waiting = false;
    }
  }

  #apply(numbers) {
    let at = 2;
    for (let n = 0; n < numbers[0]; n++) {
      const [slot, joints, feet] = [numbers[at], numbers[at + 1], numbers[at + 2]];
      const member = this.members.get(slot);
      const matrices = at + headLength + 4 * feet;
      if (member && member.body.joints === joints) {
        const { group } = member.body;
        group.position.set(numbers[at + 3], numbers[at + 4], numbers[at + 5]);
        group.quaternion.set(numbers[at + 6], numbers[at + 7], numbers[at + 8], numbers[at + 9]);
        member.speed = numbers[at + 10];
        member.phase = numbers[at + 11];
        member.feet = Array.from({ length: feet }, (_, f) => numbers.slice(at + headLength + 4 * f, at + headLength + 4 * f + 4));
        member.body.pose(numbers.subarray(matrices, matrices + 16 * joints));
        group.visible = true;
        member.moved = true;
      }
      at = matrices + 16 * joints;
    }
    for (let n = 0; n < numbers[1]; n++, at += 4) {
      this.onFootfall?.(new Vector3(numbers[at], numbers[at + 1], numbers[at + 2]), numbers[at + 3]);
    }
  }
}
