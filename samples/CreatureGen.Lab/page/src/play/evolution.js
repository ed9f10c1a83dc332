import { ofText } from '../design.js';

const population = 10;

/** Breeds a population on towards a goal, generation by generation, while one looks on: the best of each stands on the stage. */
export class Evolution {
  #over = false;

  /** @param told called with the generations so far and what to say; with null when it is over. */
  constructor(lab, studio, told) {
    Object.assign(this, { lab, studio, told });
  }

  stop() {
    this.#over = true;
  }

  /** Runs until it is stopped. @param other the slot of the other founder, or anything else for none. @param shown called for every new best. */
  async run(goal, mutation, other, shown) {
    const { lab } = this;
    const generations = [];
    lab.dressing = false;
    try {
      await lab.clearLitter();
      const studio = await this.studio();
      const second = typeof other === 'number' && lab.herd.members.has(other) ? await lab.text(other) : '';
      this.told([{ best: 0, median: 0 }], null);
      await lab.library.call('Habit', 0, 'wander', 0, 0, 2.5 * lab.world.scale);
      let state = JSON.parse(await studio.call('Evolve', await lab.text(), second, goal, population, mutation, String(Math.floor(Math.random() * 1e9))));
      let text = '';
      for (;;) {
        generations.push(state);
        const best = await studio.call('Fittest');
        if (best !== text) {
          text = best;
          await lab.show(text, lab.facts.seed);
          shown();
        }
        this.told(generations, state);
        if (this.#over) {
          break;
        }
        state = JSON.parse(await studio.call('EvolveOn'));
      }
      lab.dressing = true;
      const design = ofText(text, lab.facts.seed, lab.facts.kind);
      await lab.meet(design, [lab.family.now]);
      this.told(null, state);
      return design;
    } finally {
      lab.dressing = true;
    }
  }
}
