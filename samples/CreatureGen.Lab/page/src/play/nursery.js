import { ofSeed } from '../design.js';
import { texts } from '../texts.js';
import { checkSeed } from '../visits.js';
import { Evolution } from './evolution.js';

/** Litters, and populations that are bred on towards a goal. `panel` shows how far they are. */
export class Nursery {
  constructor(lab, visits, notices, studio, courtship, shown) {
    Object.assign(this, { lab, visits, notices, studio, courtship, shown });
    this.panel = null;
    this.evolving = null;
  }

  /** The other parent comes. @param other the slot of a neighbour, a seed as text, or null for nobody. */
  court(other) {
    return this.notices.guard(() => {
      if (other === null) {
        return this.courtship.leave();
      }
      if (typeof other === 'string') {
        checkSeed(other);
      }
      return this.courtship.court(typeof other === 'string' ? ofSeed(other, this.lab.facts.kind) : other);
    });
  }

  /** Nine children of the two; the other parent comes if nobody stands there. */
  async litter(other, mutation) {
    if (this.courtship.mate || await this.court(other)) {
      await this.notices.guard(() => this.lab.breed(this.courtship.mate.slot, mutation, n => this.panel.busy(texts.brooding(n))));
      this.panel.busy(null);
    }
  }

  /** One of the litter grows up. */
  raise(member) {
    return this.notices.guard(async () => {
      const design = await this.lab.raise(member);
      this.notices.say(texts.picked(member.name));
      await this.visits.keep(design);
    });
  }

  /** Back to one of the family. */
  back(member) {
    return this.visits.visit(member.design);
  }

  /** Breeds on towards a goal, until it is asked for again. */
  async evolve(goal, mutation, other) {
    if (this.evolving) {
      this.evolving.stop();
      return;
    }
    this.evolving = new Evolution(this.lab, this.studio, (generations, state) =>
      this.panel.evolving(generations, state === null ? texts.working : generations ? texts.evolving(state.number, state.best) : texts.evolved(state.number)));
    const done = await this.notices.guard(async () => this.visits.keep(await this.evolving.run(goal, mutation, other, this.shown)));
    if (!done) {
      this.panel.evolving(null, texts.evolveHint);
    }
    this.evolving = null;
  }
}
