// A creature as the page keeps it: a seed and what was changed of it, or a whole blueprint and what was changed. Plain data that is replaced, never changed.

import { number } from './texts.js';

export const maxSeed = 18446744073709551615n;

/** How strange creatures are if nobody says otherwise: the library's own default, which a test compares. */
export const usualStrangeness = 0.6;

/** What some mail programs and chats cut off: addresses have no more letters. */
export const mostLetters = 2000;

/** A creature of a seed. */
export const ofSeed = (seed, kind = 'walking', strangeness = usualStrangeness, individual = '') => ({ seed: String(seed), kind, strangeness, individual: String(individual), traits: {}, text: null });

/** The creature that a page without an address begins with. */
export const first = ofSeed('25', 'walking');

/** A creature of a blueprint. */
export const ofText = (text, seed, kind) => ({ seed, kind, strangeness: usualStrangeness, individual: '', traits: {}, text });

/** The changed traits as the library reads them: `girth1.2~legs.8`. */
export function traitText(traits) {
  return Object.entries(traits)
    .map(([name, value]) => name + String(Math.round(value * 100) / 100).replace(/^(-?)0\./, '$1.'))
    .join('~');
}

/** What the library is called with to grow a design in a slot. */
export function growing(slot, design) {
  const traits = traitText(design.traits);
  return design.text === null ? ['Grow', slot, design.seed, design.kind, design.strangeness, design.individual ?? '', traits] : ['GrowText', slot, design.text, traits];
}

/** What of an address tells the creature; null for one that tells none. Throws with a message for people. */
export function readAddress(hash) {
  const text = hash.replace(/^#/, '');
  if (text === '') {
    return null;
  }
  if (hash.length > mostLetters) {
    throw new Error(`it has ${number(hash.length)} letters; expected at most ${number(mostLetters)}`);
  }
  if (text.startsWith('b=')) {
    // A whole blueprint, or the seed of a creature and how it differs from it.
    const [first, second, ...rest] = text.slice(2).split('~');
    const differs = first.includes('.');
    return { packed: differs ? `${first}~${second}` : first, traits: readTraits(differs ? rest : [second, ...rest].filter(Boolean)) };
  }
  const [head, ...rest] = text.split('~');
  const parts = /^([0-9]{1,20})(?:\.(walking|flying|swimming|any))?(?:\.i([0-9]{1,20}))?(?:\.s([0-9]{1,3}))?$/.exec(head);
  if (!parts || BigInt(parts[1]) > maxSeed || BigInt(parts[3] ?? 0) > maxSeed || Number(parts[4] ?? 0) > 100) {
    throw new Error(`“${head.slice(0, 40)}” tells no creature; expected a seed, such as #31.walking`);
  }
  return { ...ofSeed(parts[1], parts[2] ?? 'any', parts[4] === undefined ? usualStrangeness : Number(parts[4]) / 100, parts[3] ?? ''), traits: readTraits(rest) };
}

function readTraits(entries) {
  const traits = {};
  for (const entry of entries.slice(0, 20)) {
    if (entry.startsWith('.')) {
      Object.assign(traits, unpackTraits(entry.slice(1)));
      continue;
    }
    const parts = /^([a-z]{2,12})(-?[0-9]*\.?[0-9]{1,3})$/.exec(entry);
    if (!parts) {
      throw new Error(`“${entry.slice(0, 40)}” is no trait; expected one such as girth1.2`);
    }
    traits[parts[1]] = Number(parts[2]);
  }
  return traits;
}

// Packed traits: a letter and two digits of base 36, which count hundredths from a number below the least of all.
const packedNames = ['size', 'girth', 'neck', 'head', 'snout', 'eyes', 'legs', 'stoutness', 'tail', 'wings', 'ornaments', 'pattern', 'colour', 'arms'];
const packedFrom = -320;
const longestAddress = 80;

const packTraits = traits => Object.entries(traits)
  .map(([name, value]) => (packedNames.indexOf(name) + 10).toString(36) + (Math.round(100 * value) - packedFrom).toString(36).padStart(2, '0'))
  .join('');

function unpackTraits(text) {
  if (!/^(?:[a-n][0-9a-z]{2}){1,20}$/.test(text)) {
    throw new Error(`“${text.slice(0, 40)}” are no traits`);
  }
  return Object.fromEntries(text.match(/.{3}/g).map(code => [packedNames[parseInt(code[0], 36) - 10], (parseInt(code.slice(1), 36) + packedFrom) / 100]));
}

/** The address of a creature of a seed: with the names of traits while it is short. */
export function seedAddress(design) {
  const individual = design.individual ? `.i${design.individual}` : '';
  const strange = design.strangeness !== usualStrangeness ? `.s${Math.round(100 * design.strangeness)}` : '';
  const head = `#${design.seed}.${design.kind}${individual}${strange}`;
  const traits = traitText(design.traits);
  const whole = head + (traits && '~' + traits);
  return whole.length <= longestAddress ? whole : `${head}~.${packTraits(design.traits)}`;
}

/** Steps back and forth through what was made. */
export class History {
  #past = [];
  #future = [];

  now = null;

  push(design) {
    if (this.now) {
      this.#past.push(this.now);
    }
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
