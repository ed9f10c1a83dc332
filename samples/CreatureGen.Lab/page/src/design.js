// A creature as the page keeps it: a seed and what was changed of it, or a whole blueprint and what was changed. Plain data that is replaced, never changed.

export const maxSeed = 18446744073709551615n;

/** A creature of a seed. */
export const ofSeed = (seed, kind = 'walking', strangeness = 0) => ({ seed: String(seed), kind, strangeness, traits: {}, text: null });

/** A creature of a blueprint. */
export const ofText = (text, seed, kind) => ({ seed, kind, strangeness: 0, traits: {}, text });

/** The changed traits as the library reads them: `girth1.2~legs.8`. */
export function traitText(traits) {
  return Object.entries(traits)
    .map(([name, value]) => name + String(Math.round(value * 100) / 100).replace(/^(-?)0\./, '$1.'))
    .join('~');
}

/** What of an address tells the creature; null for one that tells none. Throws with a message for people. */
export function readAddress(hash) {
  const text = hash.replace(/^#/, '');
  if (text === '') {
    return null;
  }
  if (text.startsWith('b=')) {
    return { packed: text.slice(2).split('~')[0], traits: readTraits(text.slice(2).split('~').slice(1)) };
  }
  const [head, ...rest] = text.split('~');
  const parts = /^([0-9]{1,20})(?:\.(walking|flying|swimming|any))?(?:\.s([0-9]{1,3}))?$/.exec(head);
  if (!parts || BigInt(parts[1]) > maxSeed || Number(parts[3] ?? 0) > 100) {
    throw new Error(`“${head.slice(0, 40)}” tells no creature; expected a seed, such as #31.walking`);
  }
  return { ...ofSeed(parts[1], parts[2] ?? 'any', Number(parts[3] ?? 0) / 100), traits: readTraits(rest) };
}

function readTraits(entries) {
  const traits = {};
  for (const entry of entries.slice(0, 20)) {
    const parts = /^([a-z]{2,12})(-?[0-9]*\.?[0-9]{1,3})$/.exec(entry);
    if (!parts) {
      throw new Error(`“${entry.slice(0, 40)}” is no trait; expected one such as girth1.2`);
    }
    traits[parts[1]] = Number(parts[2]);
  }
  return traits;
}

/** The address of a creature of a seed. */
export function seedAddress(design) {
  const strange = design.strangeness > 0 ? `.s${Math.round(100 * design.strangeness)}` : '';
  const traits = traitText(design.traits);
  return `#${design.seed}.${design.kind}${strange}${traits && '~' + traits}`;
}

/** Steps back and forth through what was made. */
export class History {
  #past = [];
  #future = [];

  constructor(now) {
    this.now = now;
  }

  push(design) {
    this.#past.push(this.now);
    this.#future.length = 0;
    this.now = design;
    if (this.#past.length > 200) {
      this.#past.shift();
    }
  }

  undo() {
    if (this.#past.length) {
      this.#future.push(this.now);
      this.now = this.#past.pop();
    }
    return this.now;
  }

  redo() {
    if (this.#future.length) {
      this.#past.push(this.now);
      this.now = this.#future.pop();
    }
    return this.now;
  }

  get canUndo() {
    return this.#past.length > 0;
  }

  get canRedo() {
    return this.#future.length > 0;
  }
}
