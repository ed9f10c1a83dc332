import { nameOf } from './names.js';
import { isNarrow } from './view/narrow.js';
import { lake } from './world/terrain.js';
import { ofSeed } from './design.js';

const firstSlot = 1;
const coarseLevel = 2;

const dozen = 12;
const few = 6;

// A breath for everybody who lives already, between two that come.
const pauseMilliseconds = 250;

// Sizes that suit: parts of the creature in the middle.
const least = 0.55;
const step = 0.17;

/** The creatures that live round the one that is looked at: neighbours of its seed that walk, fly over the meadow and swim in the lake, or all swim in the sea. */
export class Neighbourhood extends EventTarget {
  /** @param grow builds a design in a slot of a library: `grow(slot, design)`; `studio` gives the second worker. */
  constructor(library, studio, world, herd, grow) {
    super();
    Object.assign(this, { library, studio, world, herd, grow });
    this.members = [];
  }

  async clear() {
    for (const member of this.members.splice(0)) {
      await this.herd.remove(member.slot);
    }
  }

  /** Lets one live as it likes, about its home. */
  release({ slot, home }) {
    return this.library.call('Habit', slot, 'wander', home.x, home.z, home.radius);
  }

  /** Lets them come, one by one; stops when `goesOn()` says so. @param away the angle at which they live, seen from the middle. */
  async settle(design, away, goesOn) {
    const count = isNarrow() ? few : dozen;
    for (let n = 0; n < count; n++) {
      await new Promise(resolve => setTimeout(resolve, pauseMilliseconds));
      if (!goesOn()) {
        return;
      }
      await this.#bring(n, count, BigInt(design.seed), away);
    }
    for (const member of [...this.members]) {
      if (goesOn()) {
        await this.#coarsen(member);
      }
    }
  }

  async #bring(n, count, base, away) {
    const unit = this.world.scale;
    const slot = firstSlot + n;
    const home = this.#home(n, count, away);
    const seed = BigInt.asUintN(64, base * 31n + BigInt(n + 1) * 7919n);
    let design = ofSeed(seed % 1000000n, home.kind);
    let facts = await this.grow(slot, design);
    const wanted = unit * (least + step * (n % 4));
    const size = Math.max(facts.height, 0.42 * facts.length) / 1.15;
    if (size > 1.3 * wanted || size < 0.7 * wanted) {
      design = { ...design, traits: { size: Math.min(2.5, Math.max(0.4, wanted / size)) } };
      facts = await this.grow(slot, design);
    }
    await this.library.call('Place', slot, home.x, (home.kind === 'flying' ? 1 : 0.5) * unit, home.z, home.angle + Math.PI + n);
    const member = await this.herd.settle(slot, facts);
    Object.assign(member, { design, home, name: nameOf(design.seed, home.kind) });
    await this.release(member);
    this.members.push(member);
    this.dispatchEvent(new Event('came'));
  }

  /** Where the n-th lives, how, and how far it strays. */
  #home(n, count, away) {
    const unit = this.world.scale;
    const wet = this.world.name === 'sea';
    if (!wet && n % 6 === 4) {
      const side = n % 4 ? 1 : -1;
      return { kind: 'swimming', x: (lake.x + 4.5 * side) * unit, z: (lake.z + 2.5) * unit, angle: away, radius: 3.2 * unit };
    }
    const angle = away + (n - (count - 1) / 2) * (2.2 / count) + 0.12 * Math.sin(n * 5);
    const r = (5.4 + 1.9 * ((n * 5) % 4)) * unit;
    return { kind: wet ? 'swimming' : n % 4 === 3 ? 'flying' : 'walking', x: r * Math.sin(angle), z: r * Math.cos(angle), angle, radius: 2.4 * unit };
  }

  /** A coarser level of a neighbour's mesh for when it is far, made by the second worker. */
  async #coarsen(member) {
    const studio = await this.studio();
    await studio.call('GrowText', 2, await this.library.call('Blueprint', member.slot), '');
    const bytes = await studio.call('Level', 2, coarseLevel);
    if (this.herd.members.get(member.slot) === member) {
      member.body.coarsen(new Int32Array(bytes.buffer, bytes.byteOffset, bytes.byteLength / 4));
    }
  }
}
