import { Library } from './library.js';
import { World } from './world/world.js';
import { Herd } from './creature/herd.js';
import { Looks } from './creature/looks.js';
import { Orbit } from './view/orbit.js';
import { Drawing } from './view/renderer.js';
import { Pointer } from './view/pointer.js';
import { Sound } from './view/sound.js';
import { Touch } from './view/touch.js';
import { Gaits } from './view/gaits.js';
import { Portraits } from './view/portraits.js';
import { Theatre } from './view/theatre.js';
import { Treats } from './play/treats.js';
import { Playmate } from './play/playmate.js';
import { Shaping } from './play/shaping.js';
import { Courtship } from './play/courtship.js';
import { Making } from './play/making.js';
import { Nursery } from './play/nursery.js';
import { Taking } from './play/taking.js';
import { Lab } from './lab.js';
import { first } from './design.js';
import offered from './offered.json';
import { Visits } from './visits.js';
import { Notices } from './notices.js';
import { h } from './dom.js';
import { Keeping } from './keeping.js';
import { beast, length, texts, weight } from './texts.js';
import { headerBar } from './panels/header.js';
import { fillTabs } from './panels/tabs.js';
import { makePanel } from './panels/make.js';
import { meetPanel } from './panels/meet.js';
import { breedPanel } from './panels/breed.js';
import { keepPanel } from './panels/keep.js';
import { deedsBar } from './panels/deeds.js';
import { Grid } from './panels/grid.js';

const moods = { calm: [0, 0, 0], glad: [0.4, 1, 0.2], afraid: [1, -1, -1], angry: [1, -1, 1], sad: [-0.8, -1, -0.4], excited: [1, 1, 0.4] };
const moodSeconds = 8;
const lookMilliseconds = 90;
const costMilliseconds = 500;
const fadeMilliseconds = 400;

/** The page: panels round a stage. It makes all parts, passes what people do to those that do it, and shows what comes of it. */
export class Frame {
  #studio = null;
  #looked = 0;
  #told = 0;

  /** @param library starts already. */
  constructor(library) {
    const query = new URLSearchParams(location.search);
    const studio = () => this.studio();
    this.library = library;
    this.canvas = document.getElementById('stage');
    this.canvas.setAttribute('aria-label', texts.stage);
    this.notices = new Notices();
    this.drawing = new Drawing(this.canvas, query.get('draw'));
    this.world = new World();
    this.herd = new Herd(this.library, this.world.scene);
    this.orbit = new Orbit();
    this.sound = new Sound();
    const gaits = new Gaits();
    this.gaitsCanvas = gaits.canvas;
    this.looks = new Looks(this.library, this.herd, gaits);
    this.treats = new Treats(this.world.scene);
    this.touch = new Touch(this.library, this.herd);
    this.lab = new Lab(this.library, studio, this.world, this.herd, this.orbit);
    this.portraits = new Portraits(this.drawing.renderer, this.herd);
    this.courtship = new Courtship(this.library, this.lab, this.herd);
    this.theatre = new Theatre(this.canvas, this.drawing, this.world, this.herd, this.orbit, this.lab, this.courtship, this.portraits, [this.looks, gaits, this.treats]);
    this.theatre.still = query.has('still');
    this.lab.alone = query.has('alone');
    if (!this.theatre.still) {
      this.lab.curtain = this.theatre.seen;
    }
    this.play = new Playmate(this.lab, this.treats, (what, ...more) => this.#report(what, ...more));
    this.keeping = new Keeping(this.lab, studio, size => this.theatre.snapshot(size));
    this.visits = new Visits(this.library, this.lab, this.notices);
    this.making = new Making(this.lab, this.visits, this.notices, studio);
    this.nursery = new Nursery(this.lab, this.visits, this.notices, studio, this.courtship, () => this.#thumb());
    this.taking = new Taking(this.lab, this.visits, this.notices, this.keeping, studio);
  }

  /** A second worker with the library, for what takes long: textures, other parents, the grid. */
  async studio() {
    this.#studio ??= new Library();
    await this.#studio.ready;
    return this.#studio;
  }

  async start() {
    this.#build();
    const wanted = this.visits.wanted();
    this.theatre.start();
    this.theatre.prepare();
    this.theatre.seen.then(() => {
      performance.mark('creature:live');
      this.#uncover();
    });
    try {
      await this.library.ready;
    } catch (problem) {
      document.getElementById('cover').textContent = texts.stopped(problem.message);
      throw problem;
    }
    this.#fillPanel(offered.sliders, offered.parts);
    if (!await this.notices.guard(() => this.visits.arrive(wanted), texts.badAddress)) {
      await this.visits.arrive(first);
    }
    addEventListener('hashchange', () => this.visits.follow());
  }

  #build() {
    const { play } = this;
    this.pointer = this.#input();
    this.title = h('h1', {}, '');
    this.subtitle = h('p', {}, '');
    this.panel = h('aside', { className: 'panel', 'aria-label': texts.title });
    this.header = headerBar({ hatch: (seed, kind) => this.visits.hatch(seed, kind), grid: () => this.#openGrid() });
    this.bar = deedsBar({
      pet: () => play.pet(), feed: () => play.feed(), dance: () => play.act('Dance'), jump: () => play.jump(), call: () => play.act('Call'), faint: () => play.faint(),
      push: () => { const focus = this.lab.focus(); const { position } = this.orbit.camera; return play.push(focus.x - position.x, focus.z - position.z); },
      sound: on => this.sound.turn(on),
    });
    this.bar.hidden = true;
    this.ghost = h('div', { className: 'ghost', hidden: true, 'aria-hidden': 'true' });
    document.body.append(
      this.header.root,
      h('main', {}, h('div', { className: 'caption' }, this.title, this.subtitle, this.notices.status), this.panel),
      this.notices.alert, this.bar, this.ghost,
      h('div', { className: 'dropzone', 'aria-hidden': 'true' }, texts.dropHere));
  }

  /** What fingers, mouse and dropped files do. */
  #input() {
    const { play } = this;
    const pointer = new Pointer(this.canvas, this.orbit, this.world, this.herd, this.touch);
    const on = (name, act) => pointer.addEventListener(name, ({ detail }) => act(detail));
    on('look', point => this.#aim(point));
    on('send', place => this.library.call('Go', 0, place.x, place.z).catch(() => {}));
    on('pick', member => this.#pick(member));
    on('pet', () => play.pet());
    on('push', push => play.push(push.x, push.z, push.joint, push.strength));
    on('hover', hit => { this.canvas.style.cursor = hit ? (pointer.shaping && this.shaping?.traits(hit.part) ? 'move' : 'pointer') : ''; });
    this.herd.onMoment = moment => this.#moment(moment);
    addEventListener('dragover', event => { event.preventDefault(); document.body.classList.add('dragging'); });
    addEventListener('dragleave', event => { if (!event.relatedTarget) { document.body.classList.remove('dragging'); } });
    addEventListener('drop', event => {
      event.preventDefault();
      document.body.classList.remove('dragging');
      if (event.dataTransfer.files[0]) {
        this.taking.open(event.dataTransfer.files[0]);
      }
    });
    return pointer;
  }

  #fillPanel(sliders, parts) {
    const { lab, making, nursery, taking } = this;
    this.bar.hidden = false;
    this.#shape(sliders);
    this.make = makePanel(sliders, parts, making, look => this.looks.take(look));
    this.meet = meetPanel({
      come: () => { const { camera } = this.orbit; const focus = lab.focus(); this.library.call('Go', 0, camera.position.x * 0.45 + focus.x * 0.55, camera.position.z * 0.45 + focus.z * 0.55); },
      wander: on => this.library.call('Habit', 0, on ? 'wander' : 'stay', 0, 0, 4 * this.world.scale),
      call: member => this.#pick(member),
      perform: name => this.play.act(name),
      feel: name => this.library.call('Feel', 0, ...moods[name], moodSeconds),
    });
    this.breed = nursery.panel = breedPanel(nursery);
    this.keep = keepPanel(taking);
    this.show = fillTabs(this.panel, { make: this.make, meet: this.meet, breed: this.breed, keep: this.keep }, name => this.#turnTo(name));
    this.show('make');
    this.keep.collection(this.keeping.collection);
    this.#listen();
  }

  /** Another panel is open: where one breeds, two stand side by side. */
  #turnTo(name) {
    this.pointer.shaping = name === 'make';
    this.tab = name;
    this.#court();
  }

  #court() {
    if (this.tab === 'breed' && this.lab.facts) {
      this.nursery.court(this.breed.other());
    } else {
      this.notices.guard(() => this.courtship.leave());
    }
  }

  #listen() {
    const { lab, making, taking, visits } = this;
    const refresh = () => this.#refresh();
    lab.addEventListener('met', () => {
      if (this.theatre.still) {
        this.#uncover();
      }
      refresh();
      this.#court();
    });
    lab.addEventListener('changed', refresh);
    lab.addEventListener('dressed', () => {
      this.looks.show();
      this.#thumb();
      // The first act that is tried takes longest: it is tried before somebody asks for one.
      this.play.rehearse('Dance').catch(() => {});
    });
    lab.addEventListener('neighbours', () => {
      this.#showNeighbours();
      this.#face(lab.neighbours.at(-1), () => this.#showNeighbours());
      if (!this.courtship.mate) {
        this.#court();
      }
    });
    lab.addEventListener('litter', () => {
      this.breed.litter(lab.litter);
      this.#face(lab.litter.at(-1), () => this.breed.litter(lab.litter));
    });
    this.courtship.addEventListener('came', () => {
      this.#pair();
      this.#face(this.courtship.mate, () => this.#pair());
    });
    lab.addEventListener('trouble', ({ detail }) => this.notices.complain(detail.message));
    visits.addEventListener('leave', () => this.treats.clear());
    visits.addEventListener('come', ({ detail }) => this.make.tell([...detail.reasons]));
    visits.addEventListener('kept', () => this.make.refresh(lab.design, lab.facts, visits.history));
    making.addEventListener('wished', () => this.make.refresh(lab.design, null, visits.history));
    making.addEventListener('repaired', ({ detail }) => this.make.tell(detail.reasons, detail.title));
    taking.addEventListener('renamed', () => { this.#caption(); this.breed.family(lab.family); });
    taking.addEventListener('collected', () => this.keep.collection(this.keeping.collection));
    this.theatre.addEventListener('advanced', () => {
      if (performance.now() - this.#told > costMilliseconds) {
        this.#told = performance.now();
        this.meet.cost(this.herd.frameCost(), this.herd.members.size);
      }
    });
  }

  /** Pulling on the body itself. */
  #shape(sliders) {
    const { lab, making, ghost } = this;
    this.shaping = new Shaping(lab, this.orbit.camera, sliders, {
      value: name => lab.design.traits[name] ?? sliders.find(slider => slider.name === name).own,
      slide: (name, value) => making.slide(name, value),
      takeBack: design => making.change(design),
      settle: () => making.settle(),
      label: (name, value, x, y) => {
        ghost.hidden = name === null;
        if (name !== null) {
          ghost.textContent = texts.pulled(texts.traits[name], value);
          ghost.style.transform = `translate(${Math.min(x + 18, innerWidth - 150)}px, ${Math.max(y - 46, 8)}px)`;
        }
      },
    });
    for (const name of ['grip', 'pull', 'release']) {
      this.pointer.addEventListener(name, ({ detail }) => this.shaping[name](detail));
    }
  }

  /** What happened to somebody: it is heard, and seen where it matters. */
  #moment({ kind, member, place, strength }) {
    this.sound.play(kind, strength, place.distanceTo(this.orbit.focus) / this.world.scale, member.facts, member.slot);
    if (member.slot !== 0) {
      return;
    }
    if (kind === 'contact') {
      this.play.bitten();
    } else if (kind === 'done') {
      this.play.eaten();
    } else if (kind === 'fell' || kind === 'rose') {
      this.#report(kind);
    }
  }

  /** Tells in words how play goes. */
  #report(what, reason, act) {
    this.notices.say(what === 'refuses' ? texts.refuses(texts.acts[act] ?? act.toLowerCase(), reason) : texts.told[what] ?? '');
  }

  /** Another creature was clicked: a young one grows up, a neighbour comes and may be a parent. */
  #pick(member) {
    if (this.lab.litter.includes(member)) {
      this.nursery.raise(member);
    } else if (member.slot !== 0) {
      if (this.tab === 'breed') {
        this.breed.choose(member.slot);
      } else {
        const focus = this.lab.focus();
        const angle = this.orbit.azimuth + 0.9;
        const away = 0.8 * (this.lab.facts.length + member.facts.length);
        this.library.call('Go', member.slot, focus.x + away * Math.sin(angle), focus.z + away * Math.cos(angle));
      }
      this.notices.say(`${member.name}, ${beast(member.facts.body)}`);
    }
  }

  #aim(point) {
    const now = performance.now();
    if (point === null || now - this.#looked > lookMilliseconds) {
      this.#looked = now;
      const { x, y, z } = point ?? { x: NaN, y: NaN, z: NaN };
      this.library.call('Look', 0, x, y, z).catch(() => {});
    }
  }

  /** A small picture of somebody, if there is none yet. */
  async #face(member, shown) {
    if (member && !member.thumb) {
      member.thumb = await this.portraits.take(member);
      shown();
    }
  }

  /** A small picture of whoever stands there, for the family tree. */
  #thumb() {
    const { family } = this.lab;
    const { now } = family;
    this.#face(this.herd.members.get(0), () => {
      now.thumb = this.herd.members.get(0).thumb ?? now.thumb;
      this.breed.family(family);
      this.#pair();
    });
  }

  #pair() {
    const { mate } = this.courtship;
    this.breed.pair({ name: this.keeping.name, thumb: this.lab.family.now?.thumb }, mate);
  }

  #showNeighbours() {
    const { neighbours, facts } = this.lab;
    this.meet.people(neighbours);
    // Those of the lake and those of the land do not meet.
    this.breed.partners(neighbours.filter(member => (member.facts.medium === 'water') === (facts.medium === 'water')));
  }

  async #openGrid() {
    this.grid ??= new Grid(() => this.studio(), { choose: design => this.visits.visit(design), shown: on => { this.theatre.covered = on; } });
    await this.notices.guard(async () => this.grid.open(this.lab.design, await this.lab.parents()));
  }

  #caption() {
    const { facts } = this.lab;
    const { name } = this.keeping;
    this.title.textContent = name;
    this.subtitle.textContent = [texts.kin(facts.bodies.slice(0, 2).map(beast)), weight(facts.mass), length(facts.length)].join(' · ');
    document.title = `${name}, ${texts.title}`;
    this.keep.named(name);
  }

  #refresh() {
    const { design, facts, family } = this.lab;
    this.make.refresh(design, facts, this.visits.history);
    this.meet.refresh(facts);
    this.#showNeighbours();
    this.breed.family(family);
    this.#pair();
    this.touch.learn().catch(() => {});
    this.#caption();
    this.header.refresh(design, facts);
    this.looks.show();
  }

  /** The stage comes into view. */
  #uncover() {
    const cover = document.getElementById('cover');
    if (cover && !cover.classList.contains('gone')) {
      cover.classList.add('gone');
      setTimeout(() => cover.remove(), fadeMilliseconds);
    }
  }
}
