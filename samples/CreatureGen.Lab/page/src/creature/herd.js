import { Quaternion, Vector3 } from 'three';
import { Body, readMesh } from './body.js';
import { Shade } from './shade.js';

const headLength = 15;
const momentLength = 6;

// What a moment is of; in the order of the library's side.
const moments = ['footfall', 'wingBeat', 'call', 'callEnd', 'contact', 'done', 'fell', 'rose'];

/** States of a body, in the library's order. */
export const states = ['supported', 'leaping', 'falling', 'landed', 'limp', 'rising'];

// Moves that lie farther apart than this, in seconds, are drawn one after the other without anything between.
const smoothest = 0.02;
const longestGlide = 0.4;

/** Everybody who lives on the stage: their bodies, by slots, and what the library says of them in each frame. */
export class Herd {
  #buffer = new ArrayBuffer(1 << 17);
  #waiting = false;
  #owed = 0;
  #costs = [];
  #time = 0;

  constructor(library, scene) {
    this.library = library;
    this.scene = scene;
    this.members = new Map();
    this.eye = 0;
    this.onMoment = null;
  }

  /** Settles what was grown in a slot. */
  async settle(slot, facts) {
    const bytes = await this.library.call('Mesh', slot);
    return this.put(slot, facts, new Body(readMesh(bytes.buffer, bytes.byteOffset)));
  }

  /** Shows a body in a slot, in place of the one that was there. */
  put(slot, facts, body) {
    const before = this.members.get(slot);
    const member = { slot, facts, body, feet: [], speed: 0, phase: 0, state: 'supported', moved: false, shown: this.#time, shade: new Shade() };
    if (before) {
      body.group.position.copy(before.body.group.position);
      body.group.quaternion.copy(before.body.group.quaternion);
      before.body.dispose();
      before.shade.mesh.removeFromParent();
    }
    // It is seen with its first pose.
    body.group.visible = false;
    this.scene.add(body.group, member.shade.mesh);
    this.members.set(slot, member);
    return member;
  }

  async remove(slot) {
    const member = this.members.get(slot);
    if (member) {
      this.members.delete(slot);
      member.body.dispose();
      member.shade.mesh.removeFromParent();
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

  /** Draws those that take turns between their last two moves. */
  glide(seconds) {
    this.#time += seconds;
    for (const member of this.members.values()) {
      const { glide } = member;
      if (glide && glide.at < 1) {
        glide.at = Math.min(1, glide.at + seconds / glide.seconds);
        member.body.group.position.lerpVectors(glide.from.position, glide.to.position, glide.at);
        member.body.group.quaternion.slerpQuaternions(glide.from.turn, glide.to.turn, glide.at);
        member.body.blend(glide.from.matrices, glide.to.matrices, glide.at);
      }
    }
  }

  #apply(numbers) {
    let at = 2;
    for (let n = 0; n < numbers[0]; n++) {
      const [slot, joints, feet] = [numbers[at], numbers[at + 1], numbers[at + 2]];
      const member = this.members.get(slot);
      const matrices = at + headLength + 4 * feet;
      if (member && member.body.joints === joints) {
        member.speed = numbers[at + 10];
        member.phase = numbers[at + 11];
        member.state = states[numbers[at + 13]];
        for (let f = 0; f < feet; f++) {
          const foot = (member.feet[f] ??= new Float32Array(4));
          for (let k = 0, from = at + headLength + 4 * f; k < 4; k++) {
            foot[k] = numbers[from + k];
          }
        }
        this.#show(member, numbers, at, numbers.subarray(matrices, matrices + 16 * joints));
      }
      at = matrices + 16 * joints;
    }
    for (let n = 0; n < numbers[1]; n++, at += momentLength) {
      const member = this.members.get(numbers[at + 1]);
      if (member) {
        this.onMoment?.({ kind: moments[numbers[at]], member, place: new Vector3(numbers[at + 2], numbers[at + 3], numbers[at + 4]), strength: numbers[at + 5] });
      }
    }
  }

  #show(member, numbers, at, matrices) {
    const { body } = member;
    const seconds = Math.max(numbers[at + 14], this.#time - member.shown);
    member.shown = this.#time;
    if (member.moved && seconds > smoothest && member.slot !== this.eye) {
      // The same room is used for every move: nothing is left for the collector.
      const glide = (member.glide ??= { from: place(body.joints), to: place(body.joints), seconds, at: 0 });
      glide.from.position.copy(body.group.position);
      glide.from.turn.copy(body.group.quaternion);
      glide.from.matrices.set(body.skeleton.boneMatrices.subarray(0, matrices.length));
      glide.to.position.fromArray(numbers, at + 3);
      glide.to.turn.fromArray(numbers, at + 6);
      glide.to.matrices.set(matrices);
      glide.seconds = Math.min(seconds, longestGlide);
      glide.at = 0;
    } else {
      if (member.glide) {
        member.glide.at = 1;
      }
      body.group.position.fromArray(numbers, at + 3);
      body.group.quaternion.fromArray(numbers, at + 6);
      body.pose(matrices);
    }
    body.group.visible = true;
    member.moved = true;
  }
}

const place = joints => ({ position: new Vector3(), turn: new Quaternion(), matrices: new Float32Array(16 * joints) });
