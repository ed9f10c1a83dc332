import { Vector3 } from 'three';

const calmSeconds = 3.5;
const restSeconds = 2.2;
const firstPush = 0.32;

// What the library tries of an act at once: in between frames go on.
const trialMilliseconds = 8;

/** What one does with a creature: push it, pet it, feed it, let it dance. Knows the library and the stage, nothing of panels. */
export class Playmate {
  #pushes = 0;
  #pushed = -Infinity;
  #lies = null;

  constructor(lab, treats, tell) {
    Object.assign(this, { lab, treats, tell });
  }

  /** Each push soon after the one before is harder, until it falls over. */
  async push(x, z, joint = -1, strength = null) {
    const now = performance.now() / 1000;
    this.#pushes = now - this.#pushed < calmSeconds ? this.#pushes + 1 : 0;
    this.#pushed = now;
    await this.lab.library.call('Push', 0, joint, x, z, strength ?? firstPush * Math.pow(1.5, Math.min(this.#pushes, 4)));
  }

  async pet() {
    await this.lab.library.call('Feel', 0, 0.2, 1, 0.2, 5);
    this.love();
    if (await this.#try('Sniff') === '') {
      this.tell('petted');
    }
  }

  /** A fruit before the creature; it comes and eats. */
  async feed() {
    const { lab } = this;
    const { facts } = lab;
    const { group } = lab.herd.members.get(0).body;
    const way = new Vector3(0.35, 0, 1).applyQuaternion(group.quaternion).setY(0).normalize().multiplyScalar(1.5 * facts.length + 0.5 * facts.height);
    const place = group.position.clone().add(way);
    await this.offer(place.x, place.z);
  }

  /** A fruit at a place. */
  async offer(x, z) {
    const { lab } = this;
    const size = 0.2 * Math.max(0.6 * lab.facts.height, 0.35 * lab.facts.length);
    const ground = lab.world.heightAt(x, z);
    const y = lab.facts.medium === 'ground' ? ground : lab.herd.members.get(0).body.group.position.y;
    this.treats.drop(new Vector3(x, y, z), size);
    await lab.library.call('Feed', 0, x, y + 0.5 * size, z);
    this.tell('fed');
  }

  /** It was bitten into. */
  bitten() {
    this.treats.bite();
  }

  /** Its meal is over: what is left of a fruit that it has bitten into is gone. */
  eaten() {
    if (this.treats.fruit?.bitten) {
      this.treats.clear();
      this.love();
      this.tell('ate');
    }
  }

  /** An act of the library; why not is told. */
  async act(name) {
    const reason = await this.#try(name);
    this.tell(reason === '' ? 'acts' : 'refuses', reason, name);
    return reason === '';
  }

  /** It lets itself fall, and gets up again after a while. */
  async faint() {
    await this.lab.library.call('Faint', 0);
    clearTimeout(this.#lies);
    this.#lies = setTimeout(() => this.lab.library.call('GetUp', 0), 1000 * restSeconds);
    this.tell('faints');
  }

  async jump() {
    const { lab } = this;
    const { group } = lab.herd.members.get(0).body;
    for (const far of [1.6, 1, 0.6]) {
      const way = new Vector3(0, 0, 1).applyQuaternion(group.quaternion).multiplyScalar(far * Math.max(lab.facts.height, 0.6 * lab.facts.length));
      if (await lab.library.call('Jump', 0, group.position.x + way.x, group.position.z + way.z)) {
        this.tell('jumps');
        return true;
      }
    }
    this.tell('cannotJump');
    return false;
  }

  love() {
    const { lab } = this;
    const size = Math.max(0.5 * lab.facts.height, 0.3 * lab.facts.length);
    const place = lab.focus();
    place.y += 0.5 * lab.facts.height;
    this.treats.hearts(place, size, innerHeight);
  }

  /** Has an act tried on the body, a little at a time, so that it begins at once when it is asked for. */
  async rehearse(name) {
    while (!await this.lab.library.call('Rehearse', 0, name, trialMilliseconds)) {
      // Frames, and what else is asked for, come in between.
    }
  }

  async #try(name) {
    await this.rehearse(name);
    return this.lab.library.call('Perform', 0, name);
  }
}
