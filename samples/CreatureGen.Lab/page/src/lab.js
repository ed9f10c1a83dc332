import { Vector3 } from 'three';
import { Body, readMesh } from './creature/body.js';
import { ofSeed, ofText, traitText } from './design.js';
import { Family } from './family.js';
import { nameOf } from './names.js';

const textureSize = 512;
const coarseLevel = 2;
const neighbourCount = innerWidth < 700 ? 4 : 7;
const firstNeighbour = 1;
const firstChild = 20;
export const litterSize = 9;

/** What happens on the stage: one creature that is looked at, its neighbours, and litters. Knows nothing of panels. */
export class Lab extends EventTarget {
  #busy = false;
  #wanted = null;
  #round = 0;
  #studio = null;

  constructor(library, studio, world, herd, orbit) {
    super();
    Object.assign(this, { library, world, herd, orbit });
    this.#studio = studio;
    this.design = null;
    this.litter = [];
    this.neighbours = [];
    this.family = new Family();
    this.mate = null;
    this.dressing = true;
  }

  get facts() {
    return this.herd.members.get(0)?.facts;
  }

  /** Lets a new creature come, in surroundings that suit it; without parents, it begins a family of its own. */
  async meet(design, parents = null) {
    const round = ++this.#round;
    const facts = await this.#grow(0, design);
    await this.clearLitter();
    this.design = design;
    const habitat = facts.medium === 'water' ? 'sea' : 'meadow';
    const unit = Math.max(facts.height, 0.42 * facts.length) / 1.15;
    const moves = habitat !== this.world.name || Math.abs(Math.log(unit / this.world.scale)) > 0.25;
    if (moves || !this.settled) {
      await this.clearNeighbours();
      this.world.show(habitat, unit);
      await this.#lay();
      this.settled = true;
    }
    await this.library.call('Place', 0, 0, 0, 0, 0.12);
    await this.library.call('Habit', 0, 'stay', 0, 0, 3 * unit);
    await this.herd.settle(0, facts);
    this.#frame(facts);
    this.family.add(design, nameOfDesign(design), parents);
    this.mate = null;
    this.#tell('met');
    this.#dress(round);
    if (this.neighbours.length === 0) {
      this.#settleNeighbours(round).catch(problem => this.#tell('trouble', problem));
    }
    return facts;
  }

  /** Changes the creature while a slider moves: always the newest wish, one at a time. */
  change(design) {
    this.design = design;
    this.#wanted = design;
    if (!this.#busy) {
      this.#follow();
    }
  }

  /** Makes what was changed sound, by the library's repair. */
  async mend(design) {
    this.#wanted = null;
    this.design = design;
    const round = ++this.#round;
    await this.#grow(0, design);
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
    await this.herd.settle(0, await this.#grow(0, this.design));
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
    const member = this.neighbours.find(neighbour => neighbour.slot === other);
    this.mate = { design: member?.design ?? other, name: member?.name ?? nameOfDesign(other), text: second };
    const start = Number(BigInt(this.facts.seed) % 1000000n);
    const unit = this.world.scale;
    const azimuth = this.orbit.azimuth;
    this.orbit.frame(new Vector3(1.5 * unit * Math.sin(azimuth), this.world.heightAt(0, 0) + 0.35 * unit, 1.5 * unit * Math.cos(azimuth)), this.facts.length, 7.4 * unit);
    for (let n = 0; n < litterSize && round === this.#round; n++) {
      told(n + 1);
      const slot = firstChild + n;
      const facts = JSON.parse(await this.library.call('GrowChild', slot, first, second, String(start + 7919 * n + this.litter.length), mutation, 0));
      const spread = (n - (litterSize - 1) / 2) * 0.27;
      const r = 2.5 * unit * (n % 2 ? 1.22 : 1);
      const [x, z] = [r * Math.sin(azimuth + spread), r * Math.cos(azimuth + spread)];
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
    await this.meet(design, [this.family.now, this.mate && this.family.guest(this.mate.design, this.mate.name)]);
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

  async clearNeighbours() {
    for (const member of this.neighbours.splice(0)) {
      await this.herd.remove(member.slot);
    }
  }

  /** Puts the eye before the creature again. */
  #frame(facts) {
    const unit = this.world.scale;
    this.orbit.frame(this.focus(), Math.max(facts.length, facts.height), 2.1 * Math.max(0.72 * facts.length, facts.height) + 1.5 * unit);
    this.orbit.jump();
  }

  /** The middle of the creature that is looked at. */
  focus() {
    const member = this.herd.members.get(0);
    const { position } = member.body.group;
    const lift = member.facts.medium === 'ground' ? 0.52 * member.facts.height : 0.28 * member.facts.height;
    const level = member.moved ? position.y : this.world.heightAt(position.x, position.z);
    return new Vector3(position.x, level + lift, position.z);
  }

  async #follow() {
    this.#busy = true;
    while (this.#wanted) {
      const design = this.#wanted;
      this.#wanted = null;
      try {
        const facts = await this.#grow(0, design);
        await this.herd.settle(0, facts);
        this.#tell('changed');
      } catch (problem) {
        this.#tell('trouble', problem);
      }
    }
    this.#busy = false;
  }

  async #grow(slot, design, library = this.library) {
    const traits = traitText(design.traits);
    return JSON.parse(design.text === null
      ? await library.call('Grow', slot, design.seed, design.kind, design.strangeness, design.individual ?? '', traits)
      : await library.call('GrowText', slot, design.text, traits));
  }

  async #textOf(design) {
    const studio = await this.#studio();
    await this.#grow(0, design, studio);
    return studio.call('Blueprint', 0);
  }

  async #lay() {
    const { heights, columns, cell, corner } = this.world.heightField();
    await this.library.call('Ground', new Uint8Array(heights.buffer), columns, cell, corner);
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

  /** A coarser level of a neighbour's mesh for when it is far, made by the second worker. */
  async #coarsen(member) {
    const studio = await this.#studio();
    await studio.call('GrowText', 2, await this.text(member.slot), '');
    const bytes = await studio.call('Level', 2, coarseLevel);
    if (this.herd.members.get(member.slot) === member) {
      member.body.coarsen(new Int32Array(bytes.buffer, bytes.byteOffset, bytes.byteLength / 4));
    }
  }

  async #settleNeighbours(round) {
    const base = BigInt(this.design.seed);
    const wet = this.world.name === 'sea';
    const unit = this.world.scale;
    for (let n = 0; n < neighbourCount; n++) {
      await new Promise(resolve => setTimeout(resolve, 250));
      if (round !== this.#round) {
        return;
      }
      const slot = firstNeighbour + n;
      const kind = wet ? 'swimming' : n % 4 === 3 ? 'flying' : 'walking';
      const seed = BigInt.asUintN(64, base * 31n + BigInt(n + 1) * 7919n);
      let design = ofSeed(seed % 1000000n, kind);
      let facts = await this.#grow(slot, design);
      const wanted = unit * (0.55 + 0.17 * (n % 4));
      const size = Math.max(facts.height, 0.42 * facts.length) / 1.15;
      if (size > 1.3 * wanted || size < 0.7 * wanted) {
        design = { ...design, traits: { size: Math.min(2.5, Math.max(0.4, wanted / size)) } };
        facts = await this.#grow(slot, design);
      }
      const angle = this.orbit.azimuth + Math.PI + (n - (neighbourCount - 1) / 2) * 0.3 + 0.12 * Math.sin(n * 5);
      const r = (5.4 + 2.3 * ((n * 2) % 3)) * unit;
      const [x, z] = [r * Math.sin(angle), r * Math.cos(angle)];
      await this.library.call('Place', slot, x, (kind === 'flying' ? 1 : 0.5) * unit, z, angle + Math.PI + n);
      await this.library.call('Habit', slot, 'wander', x, z, 2.4 * unit);
      const member = await this.herd.settle(slot, facts);
      Object.assign(member, { design, name: nameOf(design.seed, kind) });
      this.neighbours.push(member);
      this.#tell('neighbours');
    }
    for (const member of [...this.neighbours]) {
      if (round === this.#round) {
        await this.#coarsen(member);
      }
    }
  }

  #tell(name, detail) {
    this.dispatchEvent(new CustomEvent(name, { detail }));
  }
}

/** What a creature is called: as somebody named it, or by its seed. */
export const nameOfDesign = design => design.name ?? nameOf(design.individual ? `${design.seed}.${design.individual}` : design.seed, design.kind);

// Seeds have more digits than the page's numbers hold.
function readSeed(text, fallback) {
  const digits = /"seed":\s*"?([0-9]{1,20})/.exec(text);
  return BigInt(digits ? digits[1] : fallback);
}

/** The baked creature that is seen while the library starts. Returns what stops it. */
export async function showFirst(herd, world, orbit) {
  const answer = await fetch('./first.bin');
  if (!answer.ok) {
    return () => {};
  }
  const buffer = await answer.arrayBuffer();
  const [meshBytes, frames, joints] = new Int32Array(buffer, 0, 4);
  const body = new Body(readMesh(buffer, 16));
  const poses = new Uint16Array(buffer, 16 + meshBytes, frames * joints * 16);
  const matrices = new Float32Array(16 * joints);
  let height = 0;
  let length = 0;
  const p = body.mesh.positions;
  for (let i = 0; i < p.length; i += 3) {
    height = Math.max(height, p[i + 1]);
    length = Math.max(length, 2 * Math.abs(p[i + 2]));
  }
  const unit = Math.max(height, 0.42 * length) / 1.15;
  world.show('meadow', unit);
  const member = herd.put(0, { height, length, medium: 'ground' }, body);
  body.group.position.set(0, world.heightAt(0, 0), 0);
  body.group.rotation.y = 0.12;
  body.group.visible = true;
  orbit.frame(new Vector3(0, body.group.position.y + 0.52 * height, 0), Math.max(length, height), 2.1 * Math.max(0.72 * length, height) + 1.5 * unit);
  orbit.jump();
  const begin = performance.now();
  return () => {
    if (herd.members.get(0) === member) {
      const frame = Math.floor(((performance.now() - begin) / 1000) * 12) % frames;
      for (let i = 0; i < matrices.length; i++) {
        matrices[i] = half(poses[frame * matrices.length + i]);
      }
      body.pose(matrices);
    }
  };
}

function half(bits) {
  const exponent = (bits >> 10) & 31;
  const fraction = bits & 1023;
  const value = exponent === 0 ? fraction / 16777216 : (1 + fraction / 1024) * 2 ** (exponent - 15);
  return bits & 32768 ? -value : value;
}
