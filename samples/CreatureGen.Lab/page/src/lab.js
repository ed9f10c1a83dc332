import { Vector3 } from 'three';
import { readMesh } from './creature/body.js';
import { growing, ofText } from './design.js';
import { Family } from './family.js';
import { nameOf } from './names.js';
import { isNarrow } from './view/narrow.js';
import { Neighbourhood } from './neighbourhood.js';

const textureSize = 512;
const firstChild = 20;
export const litterSize = 9;

// Where a window is wide the eye comes nearer: panels leave room enough.
const roomy = 0.86;

/** What happens on the stage: one creature that is looked at, its neighbours, and litters. Knows nothing of panels. */
export class Lab extends EventTarget {
  #busy = false;
  #wanted = null;
  #following = null;
  #round = 0;
  #studio = null;

  constructor(library, studio, world, herd, orbit) {
    super();
    Object.assign(this, { library, world, herd, orbit });
    this.#studio = studio;
    this.design = null;
    this.litter = [];
    this.neighbourhood = new Neighbourhood(library, studio, world, herd, (slot, design) => this.grow(slot, design));
    this.neighbourhood.addEventListener('came', () => this.#tell('neighbours'));
    this.family = new Family();
    this.mate = null;
    this.dressing = true;

    /** Whether nobody lives round it. */
    this.alone = false;

    /** What is not needed for the first picture waits for this. */
    this.curtain = Promise.resolve();
  }

  get facts() {
    return this.herd.members.get(0)?.facts;
  }

  get neighbours() {
    return this.neighbourhood.members;
  }

  /** Lets a new creature come, in surroundings that suit it; without parents, it begins a family of its own. */
  async meet(design, parents = null) {
    const round = ++this.#round;
    const facts = await this.grow(0, design);
    await this.clearLitter();
    this.design = design;
    const habitat = facts.medium === 'water' ? 'sea' : 'meadow';
    const unit = Math.max(facts.height, 0.42 * facts.length) / 1.15;
    const moves = habitat !== this.world.name || Math.abs(Math.log(unit / this.world.scale)) > 0.25;
    if (moves || !this.settled) {
      await this.neighbourhood.clear();
      this.world.show(habitat, unit);
      await this.#lay();
      this.settled = true;
    }
    await this.library.call('Place', 0, 0, 0, 0, 0.12);
    await this.library.call('Habit', 0, 'stay', 0, 0, 3 * unit);
    await this.herd.settle(0, facts);
    this.frame(facts);
    this.orbit.jump();
    this.family.add(design, nameOfDesign(design), parents);
    this.mate = null;
    this.#tell('met');
    this.curtain.then(() => this.#furnish(round, design)).catch(problem => this.#tell('trouble', problem));
    return facts;
  }

  /** Changes the creature while a slider moves: always the newest wish, one at a time. */
  change(design) {
    this.design = design;
    this.#wanted = design;
    if (!this.#busy) {
      this.#following = this.#follow();
    }
  }

  /** Makes what was changed sound, by the library's repair. */
  async mend(design) {
    this.#wanted = null;
    this.design = design;
    const round = ++this.#round;
    await this.grow(0, design);
    const facts = JSON.parse(await this.library.call('Mend', 0));
    await this.herd.settle(0, facts);
    if (this.family.now) {
      this.family.now.design = design;
    }
    this.#tell('changed');
    this.#dress(round);
    return facts;
  }

  /** Shows a blueprint in place of the creature, without more ado: while something is bred on. */
  async show(text, seed) {
    ++this.#round;
    this.design = ofText(text, seed, this.design.kind);
    await this.herd.settle(0, await this.grow(0, this.design));
    this.#tell('changed');
  }

  /** Names the creature; its family knows it by that name. */
  rename(name) {
    this.design = { ...this.design, name };
    if (this.family.now) {
      Object.assign(this.family.now, { design: this.design, name: nameOfDesign(this.design) });
    }
  }

  text(slot = 0) {
    return this.library.call('Blueprint', slot);
  }

  /** Opens a file that somebody brought. */
  async open(bytes) {
    const text = await this.library.call('Open', bytes);
    const { seed, kind } = JSON.parse(text);
    return ofText(text, String(BigInt.asUintN(64, readSeed(text, seed))), String(kind).toLowerCase());
  }

  /** A litter of the creature and another, just born, in an arc before the eye. */
  async breed(other, mutation, told) {
    const round = ++this.#round;
    await this.clearLitter();
    const [first, second] = [await this.text(0), typeof other === 'number' ? await this.text(other) : await this.#textOf(other)];
    const { design = other, name, thumb = null } = this.herd.members.get(other) ?? {};
    this.mate = { design, name: name ?? nameOfDesign(design), text: second, thumb };
    const start = Number(BigInt(this.facts.seed) % 1000000n);
    const unit = this.world.scale;
    const azimuth = this.orbit.azimuth;
    this.orbit.frame(new Vector3(1.5 * unit * Math.sin(azimuth), this.world.heightAt(0, 0) + 0.35 * unit, 1.5 * unit * Math.cos(azimuth)), this.facts.length, (isNarrow() ? 9 : 7.4) * unit);
    for (let n = 0; n < litterSize && round === this.#round; n++) {
      told(n + 1);
      const slot = firstChild + n;
      const facts = JSON.parse(await this.library.call('GrowChild', slot, first, second, String(start + 7919 * n + this.litter.length), mutation, 0));
      const { aside, before } = isNarrow() ? inRows(n) : inArc(n);
      const x = unit * (before * Math.sin(azimuth) + aside * Math.cos(azimuth));
      const z = unit * (before * Math.cos(azimuth) - aside * Math.sin(azimuth));
      await this.library.call('Place', slot, x, 0.3 * unit, z, azimuth + 0.4 * Math.sin(9 * n));
      await this.library.call('Habit', slot, 'wander', x, z, 0.5 * unit);
      const member = await this.herd.settle(slot, facts);
      member.name = nameOf(`${facts.seed}.${n}`, facts.kind);
      this.litter.push(member);
      this.#tell('litter');
    }
  }

  /** Blueprints of the creature and its mate, or a neighbour, or itself: whose children are its family. */
  async parents() {
    const own = await this.text(0);
    return [own, this.mate?.text ?? (this.neighbours.length ? await this.text(this.neighbours[0].slot) : own)];
  }

  /** One of the litter grows up and takes its parent's place. */
  async raise(member) {
    const text = await this.text(member.slot);
    const design = { ...ofText(text, member.facts.seed, member.facts.kind), name: member.name };
    await this.meet(design, [this.family.now, this.mate && this.family.guest(this.mate)]);
    return design;
  }

  async clearLitter() {
    const gone = this.litter.splice(0);
    for (const member of gone) {
      await this.herd.remove(member.slot);
    }
    if (gone.length) {
      this.#tell('litter');
    }
  }

  /** Puts the eye before the creature again. */
  frame(facts = this.facts) {
    const unit = this.world.scale;
    const away = 2.1 * Math.max(0.72 * facts.length, facts.height) + 1.5 * unit;
    this.orbit.frame(this.focus(), Math.max(facts.length, facts.height), (isNarrow() ? 1 : roomy) * away);
  }

  /** The middle of the creature that is looked at. */
  focus() {
    const member = this.herd.members.get(0);
    const { position } = member.body.group;
    const lift = member.facts.medium === 'ground' ? 0.52 * member.facts.height : 0.28 * member.facts.height;
    const level = member.moved ? position.y : this.world.heightAt(position.x, position.z);
    return new Vector3(position.x, level + lift, position.z);
  }

  /** Comes when the newest wish is built. */
  async idle() {
    await this.#following;
  }

  async #follow() {
    this.#busy = true;
    while (this.#wanted) {
      const design = this.#wanted;
      this.#wanted = null;
      try {
        const facts = await this.grow(0, design);
        await this.herd.settle(0, facts);
        this.#tell('changed');
      } catch (problem) {
        this.#tell('trouble', problem);
      }
    }
    this.#busy = false;
  }

  /** Grows a design in a slot of the stage, or of another library: its facts. */
  async grow(slot, design, library = this.library) {
    return JSON.parse(await library.call(...growing(slot, design)));
  }

  /** Texture and neighbours for whoever is still there. */
  async #furnish(round, design) {
    if (round !== this.#round) {
      return;
    }
    const dressed = this.#dress(round);
    if (this.neighbours.length === 0 && !this.alone) {
      await this.neighbourhood.settle(design, this.orbit.azimuth + Math.PI, () => round === this.#round);
    }
    await dressed;
  }

  async #textOf(design) {
    const studio = await this.#studio();
    await this.grow(0, design, studio);
    return studio.call('Blueprint', 0);
  }

  async #lay() {
    const { heights, columns, cell, corner } = this.world.heightField();
    await this.library.call('Ground', new Uint8Array(heights.buffer), columns, cell, corner, this.world.waterLevel);
  }

  /** Scales, fur and feathers, painted by a second worker, so that nobody on the stage waits. */
  async #dress(round) {
    if (!this.dressing) {
      return;
    }
    const member = this.herd.members.get(0);
    const studio = await this.#studio();
    await studio.call('GrowText', 1, await this.text(0), '');
    const pixels = await studio.call('Textures', 1, textureSize);
    const bytes = await studio.call('TexturedMesh', 1);
    if (round === this.#round && this.herd.members.get(0) === member && !this.#wanted) {
      member.body.texture(readMesh(bytes.buffer, bytes.byteOffset), pixels, textureSize);
      this.#tell('dressed');
    }
  }

  #tell(name, detail) {
    this.dispatchEvent(new CustomEvent(name, { detail }));
  }
}

/** Where the n-th of a litter stands, aside of its parents and before them: all in an arc, or where there is little room in three rows. */
function inArc(n) {
  const angle = 0.2 * (n - (litterSize - 1) / 2);
  const r = 2.5 * (n % 2 ? 1.22 : 1);
  return { aside: r * Math.sin(angle), before: r * Math.cos(angle) };
}

function inRows(n) {
  const row = Math.floor(n / 3);
  return { aside: 0.8 * ((n % 3) - 1) - 0.15, before: 1.5 + 0.8 * row };
}

/** What a creature is called: as somebody named it, or by its seed. */
export const nameOfDesign = design => design.name ?? nameOf(design.individual ? `${design.seed}.${design.individual}` : design.seed, design.kind);

// Seeds have more digits than the page's numbers hold.
function readSeed(text, fallback) {
  const digits = /"seed":\s*"?([0-9]{1,20})/.exec(text);
  return BigInt(digits ? digits[1] : fallback);
}
