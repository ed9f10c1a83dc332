import { nameOfDesign } from '../lab.js';
import { isNarrow } from '../view/narrow.js';

const guestSlot = 19;

/** Two who are to be parents, side by side: a neighbour walks up, the creature of another seed appears. */
export class Courtship extends EventTarget {
  #round = 0;

  constructor(library, lab, herd) {
    super();
    Object.assign(this, { library, lab, herd });

    /** The other one, who stands there or is on the way. */
    this.mate = null;
  }

  /** Lets somebody come. @param other the slot of a neighbour, or a design. */
  async court(other) {
    const round = ++this.#round;
    await this.leave();
    const neighbour = this.lab.neighbours.find(member => member.slot === other);
    const mate = neighbour ?? await this.#invite(other, round);
    if (mate && round === this.#round) {
      this.mate = mate;
      this.frame();
      await this.#bring(mate);
      this.dispatchEvent(new Event('came'));
    }
  }

  /** The other one goes its way. */
  async leave() {
    const { mate } = this;
    this.mate = null;
    if (mate?.slot === guestSlot) {
      await this.herd.remove(guestSlot);
    } else if (mate && this.lab.neighbours.includes(mate)) {
      await this.lab.neighbourhood.release(mate);
    }
    if (mate && this.lab.facts) {
      this.frame();
    }
  }

  /** What is looked at: the middle between the two, or the one. */
  focus() {
    const focus = this.lab.focus();
    if (this.mate) {
      const [x, z] = this.beside(this.mate);
      const { position } = this.herd.members.get(0).body.group;
      focus.x += 0.5 * (x - position.x);
      focus.z += 0.5 * (z - position.z);
    }
    return focus;
  }

  /** Both come into view, or the one. */
  frame() {
    const { facts } = this.lab;
    const other = this.mate?.facts;
    this.lab.frame(other ? { length: (isNarrow() ? 1.5 : 0.95) * (facts.length + other.length), height: Math.max(facts.height, other.height) } : facts);
  }

  /** Where the other one is to stand: at the side of the first, as seen by the eye. */
  beside(mate) {
    const { lab } = this;
    const { position } = lab.herd.members.get(0).body.group;
    const { azimuth } = lab.orbit;
    const away = 0.42 * (lab.facts.length + mate.facts.length);
    return [position.x + away * Math.cos(azimuth), position.z - away * Math.sin(azimuth)];
  }

  async #invite(design, round) {
    const facts = await this.lab.grow(guestSlot, design);
    const [x, z] = this.beside({ facts });
    const unit = this.lab.world.scale;
    await this.library.call('Place', guestSlot, x, 0.3 * unit, z, this.lab.orbit.azimuth - 0.5);
    await this.library.call('Habit', guestSlot, 'stay', x, z, unit);
    const mate = await this.herd.settle(guestSlot, facts);
    if (round !== this.#round) {
      return null;
    }
    return Object.assign(mate, { design, name: nameOfDesign(design) });
  }

  async #bring(mate) {
    if (mate.slot !== guestSlot) {
      await this.library.call('Habit', mate.slot, 'stay', ...this.beside(mate), this.lab.world.scale);
      await this.library.call('Go', mate.slot, ...this.beside(mate));
    }
  }
}
