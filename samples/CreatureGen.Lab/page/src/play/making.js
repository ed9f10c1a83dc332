import { ofText, usualStrangeness } from '../design.js';
import { texts } from '../texts.js';

/** Makes the creature over: traits, parts, steps back. What repair changes is told. */
export class Making extends EventTarget {
  constructor(lab, visits, notices, studio) {
    super();
    Object.assign(this, { lab, visits, notices, studio });
  }

  /** Pulls at a trait; the newest wish is built. */
  slide(name, value) {
    this.change(withTrait(this.lab.design, name, value));
  }

  change(design) {
    this.lab.change(design);
    this.dispatchEvent(new Event('wished'));
  }

  /** The pull is over: what came of it is made sound. */
  settle() {
    const { design } = this.lab;
    return this.notices.work(async () => {
      const facts = await this.lab.mend(design);
      this.#tell(facts.reasons);
      await this.visits.keep(design);
    });
  }

  /** A part of another creature. */
  give(name) {
    return this.#part(name, 'GivePart', String(Math.floor(Math.random() * 1e6)));
  }

  take(name) {
    return this.#part(name, 'TakePart');
  }

  /** Traits anywhere in the middle of their ranges. */
  random(free) {
    this.#vary(free, slider => slider.least + (slider.most - slider.least) * (0.15 + 0.7 * Math.random()));
  }

  /** Traits a little to either side. */
  nudge(free) {
    this.#vary(free, (slider, value) => Math.min(slider.most, Math.max(slider.least, value + (slider.most - slider.least) * 0.24 * (Math.random() - 0.5))));
  }

  /** As it was born. */
  reset() {
    this.change({ ...this.lab.design, traits: {}, strangeness: usualStrangeness });
    return this.settle();
  }

  undo() {
    return this.#travel(this.visits.history.undo());
  }

  redo() {
    return this.#travel(this.visits.history.redo());
  }

  #part(name, method, ...more) {
    return this.notices.work(async () => {
      const studio = await this.studio();
      const { blueprint, parts, reasons } = JSON.parse(await studio.call(method, await this.lab.text(), name, ...more));
      const { seed, kind, name: called } = this.lab.design;
      const design = { ...ofText(blueprint, seed, kind), name: called };
      await this.lab.mend(design);
      this.#tell(reasons, method === 'GivePart' && !parts.includes(name) ? texts.refused(texts.parts[name]) : texts.repaired);
      await this.visits.keep(design);
    });
  }

  #vary(free, value) {
    let { design } = this.lab;
    for (const slider of free) {
      if (slider.name !== 'strangeness' && this.lab.facts.traits.includes(slider.name)) {
        design = withTrait(design, slider.name, value(slider, design.traits[slider.name] ?? slider.own));
      }
    }
    this.change(design);
    return this.settle();
  }

  async #travel(design) {
    const now = this.lab.design;
    if (design.seed === now.seed && design.kind === now.kind && design.text === now.text) {
      this.change(design);
      await this.settle();
    } else {
      await this.visits.visit(design);
    }
  }

  #tell(reasons, title = texts.repaired) {
    this.dispatchEvent(new CustomEvent('repaired', { detail: { reasons, title } }));
  }
}

function withTrait(design, name, value) {
  return name === 'strangeness' ? { ...design, strangeness: Math.round(100 * value) / 100 } : { ...design, traits: { ...design.traits, [name]: value } };
}
