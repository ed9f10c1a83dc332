import { first, History, maxSeed, mostLetters, ofSeed, readAddress, seedAddress } from './design.js';
import { texts } from './texts.js';

/** Throws with a message for people if a text is no seed. */
export function checkSeed(text) {
  if (!/^[0-9]{1,20}$/.test(text) || BigInt(text) > maxSeed) {
    throw new Error(texts.badSeed(text));
  }
}

/** Who is met, one after the other: by seeds, addresses and files; the way back, and the address of whoever is there. */
export class Visits extends EventTarget {
  #address = '';

  constructor(library, lab, notices) {
    super();
    Object.assign(this, { library, lab, notices });
    this.history = new History();
  }

  /** Whether the address bar tells who is there. */
  get told() {
    return this.#address !== '';
  }

  addressOf(design) {
    return seedAddress(design);
  }

  designOf(address) {
    return readAddress(address);
  }

  /** What the address bar asks for; who comes if it cannot be read. */
  wanted() {
    try {
      return this.designOf(location.hash) ?? first;
    } catch (problem) {
      this.notices.complain(texts.badAddress(problem.message));
      return first;
    }
  }

  /** Meets what an address told. */
  async arrive(wanted) {
    let design = wanted;
    if (wanted.packed) {
      const text = await this.library.call('FromAddress', wanted.packed);
      design = { ...await this.lab.open(new TextEncoder().encode(text)), traits: wanted.traits };
    }
    await this.meet(design);
  }

  /** Meets whom the address bar tells now, after somebody changed it. */
  async follow() {
    if (location.hash !== this.#address) {
      await this.notices.guard(() => this.arrive(this.designOf(location.hash) ?? first), texts.badAddress);
    }
  }

  /** A new creature comes, and can be taken back. */
  async meet(design) {
    await this.notices.during(async () => {
      this.dispatchEvent(new Event('leave'));
      const facts = await this.lab.meet(design);
      await this.keep(design);
      this.dispatchEvent(new CustomEvent('come', { detail: facts }));
    });
  }

  /** The same; what goes wrong is told. */
  visit(design) {
    return this.notices.guard(() => this.meet(design));
  }

  /** The creature of a seed. */
  hatch(seed, kind) {
    return this.notices.guard(() => {
      checkSeed(seed);
      return this.meet(ofSeed(BigInt(seed), kind));
    });
  }

  /** The creature of a file. */
  open(bytes) {
    return this.lab.open(bytes).then(design => this.meet(design));
  }

  /** A design that was reached can be taken back, and the address tells it. */
  async keep(design) {
    if (this.history.now !== design) {
      this.history.push(design);
    }
    await this.remember();
    this.dispatchEvent(new Event('kept'));
  }

  /** The address tells the creature; one that takes too many letters has none, and that is told. */
  async remember() {
    const { design } = this.lab;
    const address = design.text === null ? this.addressOf(design) : `#b=${await this.library.call('Address', 0)}`;
    const room = address.length <= mostLetters;
    if (!room && this.#address !== '') {
      this.notices.complain(texts.noAddress(address.length, mostLetters));
    }
    this.#address = room ? address : '';
    window.history.replaceState(null, '', this.#address || location.pathname + location.search);
  }
}
