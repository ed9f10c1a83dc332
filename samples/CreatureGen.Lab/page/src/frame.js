import { Library } from './library.js';
import { World } from './world/world.js';
import { Herd } from './creature/herd.js';
import { Overlay } from './creature/overlays.js';
import { Orbit } from './view/orbit.js';
import { Drawing } from './view/renderer.js';
import { Pointer } from './view/pointer.js';
import { Sound } from './view/sound.js';
import { Touch } from './view/touch.js';
import { Gaits } from './view/gaits.js';
import { Treats } from './play/treats.js';
import { Playmate } from './play/playmate.js';
import { Shaping } from './play/shaping.js';
import { Evolution } from './play/evolution.js';
import { Lab, showFirst } from './lab.js';
import { History, maxSeed, ofSeed, ofText, readAddress, seedAddress, usualStrangeness } from './design.js';
import { choices, h, icon } from './dom.js';
import { Keeping, largestFile, squareOf } from './keeping.js';
import { download } from './storage.js';
import { length, texts, weight, words } from './texts.js';
import { makePanel } from './panels/make.js';
import { meetPanel } from './panels/meet.js';
import { breedPanel } from './panels/breed.js';
import { keepPanel } from './panels/keep.js';
import { deedsBar } from './panels/deeds.js';
import { Grid } from './panels/grid.js';

const farLengths = 5;
const moods = { calm: [0, 0, 0], glad: [0.4, 1, 0.2], afraid: [1, -1, -1], angry: [1, -1, 1], sad: [-0.8, -1, -0.4], excited: [1, 1, 0.4] };
const moodSeconds = 8;
const first = ofSeed('25', 'walking');

/** The page: panels round a stage. It passes what people do to the lab, and shows what comes of it. */
export class Frame {
  #studio = null;
  #lookAt = 0;
  #before = 0;
  #told = 0;
  #stopFirst = () => {};

  constructor() {
    const query = new URLSearchParams(location.search);
    this.library = new Library();
    this.canvas = document.getElementById('stage');
    this.canvas.setAttribute('aria-label', texts.stage);
    this.drawing = new Drawing(this.canvas, query.get('draw'));
    this.world = new World(this.drawing.renderer);
    this.herd = new Herd(this.library, this.world.scene);
    this.orbit = new Orbit();
    this.overlay = new Overlay();
    this.sound = new Sound();
    this.gaits = new Gaits();
    this.treats = new Treats(this.world.scene);
    this.touch = new Touch(this.library, this.herd);
    this.lab = new Lab(this.library, () => this.studio(), this.world, this.herd, this.orbit);
    this.play = new Playmate(this.lab, this.treats, (what, ...more) => this.#report(what, ...more));
    this.look = 'skin';
    this.keeping = new Keeping(this.lab, () => this.studio(), size => this.#snapshot(size));
    this.history = new History(first);
    this.still = query.has('still');
  }

  /** A second worker with the library, for what takes long: textures, other parents, the grid. */
  async studio() {
    this.#studio ??= new Library();
    await this.#studio.ready;
    return this.#studio;
  }

  async start() {
    this.#build();
    this.#size();
    addEventListener('resize', () => this.#size());
    let wanted = first;
    try {
      wanted = readAddress(location.hash) ?? first;
    } catch (problem) {
      this.#complain(texts.badAddress(problem.message));
    }
    if (wanted === first) {
      showFirst(this.herd, this.world, this.orbit).then(step => {
        if (!this.lab.design) {
          this.#stopFirst = step;
          this.#uncover();
          performance.mark('creature:baked');
        }
      }, () => {});
    }
    requestAnimationFrame(now => this.#draw(now));
    try {
      await this.library.ready;
    } catch (problem) {
      document.getElementById('cover').textContent = texts.stopped(problem.message);
      throw problem;
    }
    this.#panels(JSON.parse(await this.library.call('Sliders')), JSON.parse(await this.library.call('Palette')));
    await this.#arrive(wanted).catch(async problem => {
      this.#complain(texts.badAddress(problem.message));
      await this.#arrive(first);
    });
    performance.mark('creature:live');
    addEventListener('hashchange', () => this.#follow());
  }

  addressOf(design) {
    return seedAddress(design);
  }

  designOf(address) {
    return readAddress(address);
  }

  async #arrive(wanted) {
    let design = wanted;
    if (wanted.packed) {
      const text = await this.library.call('FromAddress', wanted.packed);
      design = { ...await this.lab.open(new TextEncoder().encode(text)), traits: wanted.traits };
    }
    await this.#meet(design);
  }

  async #follow() {
    if (location.hash !== this.address) {
      try {
        await this.#arrive(readAddress(location.hash) ?? first);
      } catch (problem) {
        this.#complain(texts.badAddress(problem.message));
      }
    }
  }

  /** A new creature comes, and can be taken back. */
  async #meet(design) {
    this.#work(texts.working);
    this.treats.clear();
    try {
      const facts = await this.lab.meet(design);
      if (this.history.now !== design) {
        this.history.push(design);
      }
      this.#uncover();
      this.make.tell([...facts.reasons]);
      await this.#remember();
    } finally {
      this.#work('');
    }
  }

  #build() {
    this.title = h('h1', {}, '');
    this.subtitle = h('p', {}, '');
    this.seed = h('input', { type: 'text', inputMode: 'numeric', id: 'seed', maxLength: 20, autocomplete: 'off', spellcheck: false });
    this.kind = choices(texts.kind, texts.kinds, 'walking', () => this.#hatch());
    this.status = h('p', { className: 'status', role: 'status' });
    this.alert = h('div', { className: 'alert', role: 'alert', hidden: true });
    this.panel = h('aside', { className: 'panel', 'aria-label': texts.title });
    const form = h('form', { className: 'search', onsubmit: event => { event.preventDefault(); this.#hatch(); } },
      h('label', { htmlFor: 'seed' }, texts.seed), this.seed,
      h('button', { type: 'submit', className: 'loud' }, texts.hatch),
      h('button', { type: 'button', className: 'quiet', 'aria-label': texts.dice, title: texts.dice, onclick: () => this.#roll() }, icon('dice')));
    document.body.append(
      h('header', {}, h('div', { className: 'brand' }, icon('egg'), texts.title), form, this.kind,
        h('button', { type: 'button', className: 'quiet today', 'aria-label': texts.today, title: texts.today, onclick: () => this.#today() }, icon('sun')),
        h('button', { type: 'button', className: 'quiet', 'aria-label': texts.grid, title: texts.grid, onclick: () => this.#openGrid() }, icon('grid'))),
      h('main', {}, h('div', { className: 'caption' }, this.title, this.subtitle, this.status), this.panel), this.alert);
    const play = this.play;
    const bar = deedsBar({
      pet: () => play.pet(), feed: () => play.feed(), dance: () => play.act('Dance'), jump: () => play.jump(), call: () => play.act('Call'), faint: () => play.faint(),
      push: () => { const focus = this.lab.focus(); const { position } = this.orbit.camera; return play.push(focus.x - position.x, focus.z - position.z); },
      sound: on => this.sound.turn(on),
    });
    bar.hidden = true;
    this.bar = bar;
    document.body.append(bar);
    this.ghost = h('div', { className: 'ghost', hidden: true, 'aria-hidden': 'true' });
    document.body.append(this.ghost);
    const pointer = new Pointer(this.canvas, this.orbit, this.world, this.herd, this.touch);
    this.pointer = pointer;
    pointer.addEventListener('look', ({ detail }) => this.#aim(detail));
    pointer.addEventListener('send', ({ detail }) => this.library.call('Go', 0, detail.x, detail.z).catch(() => {}));
    pointer.addEventListener('pick', ({ detail }) => this.#pick(detail));
    pointer.addEventListener('pet', () => play.pet());
    pointer.addEventListener('push', ({ detail }) => play.push(detail.x, detail.z, detail.joint, detail.strength));
    pointer.addEventListener('hover', ({ detail }) => { this.canvas.style.cursor = detail ? (pointer.shaping && this.shaping?.traits(detail.part) ? 'move' : 'pointer') : ''; });
    this.herd.onMoment = moment => this.#moment(moment);
    addEventListener('dragover', event => { event.preventDefault(); document.body.classList.add('dragging'); });
    addEventListener('dragleave', event => { if (!event.relatedTarget) { document.body.classList.remove('dragging'); } });
    addEventListener('drop', event => {
      event.preventDefault();
      document.body.classList.remove('dragging');
      if (event.dataTransfer.files[0]) {
        this.#open(event.dataTransfer.files[0]);
      }
    });
    document.body.append(h('div', { className: 'dropzone', 'aria-hidden': 'true' }, texts.dropHere));
  }

  #panels(sliders, parts) {
    const lab = this.lab;
    this.bar.hidden = false;
    this.shaping = new Shaping(lab, this.orbit.camera, sliders, {
      value: name => lab.design.traits[name] ?? sliders.find(slider => slider.name === name).own,
      slide: (name, value) => this.#change(this.#with(lab.design, name, value)),
      takeBack: design => this.#change(design),
      settle: () => this.#settle(),
      label: (name, value, x, y) => {
        this.ghost.hidden = name === null;
        if (name !== null) {
          this.ghost.textContent = texts.pulled(texts.traits[name], value);
          this.ghost.style.transform = `translate(${Math.min(x + 18, innerWidth - 150)}px, ${Math.max(y - 46, 8)}px)`;
        }
      },
    });
    for (const name of ['grip', 'pull', 'release']) {
      this.pointer.addEventListener(name, ({ detail }) => this.shaping[name](detail));
    }
    this.make = makePanel(sliders, parts, {
      give: name => this.#part(name, 'GivePart', String(Math.floor(Math.random() * 1e6))),
      take: name => this.#part(name, 'TakePart'),
      slide: (name, value) => this.#change(this.#with(lab.design, name, value)),
      settle: () => this.#settle(),
      undo: () => this.#travel(this.history.undo()),
      redo: () => this.#travel(this.history.redo()),
      random: free => this.#vary(free, slider => slider.least + (slider.most - slider.least) * (0.15 + 0.7 * Math.random())),
      nudge: free => this.#vary(free, (slider, value) => Math.min(slider.most, Math.max(slider.least, value + (slider.most - slider.least) * 0.24 * (Math.random() - 0.5)))),
      reset: () => { this.#change({ ...lab.design, traits: {}, strangeness: usualStrangeness }); this.#settle(); },
      look: look => { this.look = look; this.#reveal(); },
    });
    this.meet = meetPanel({
      come: () => { const { camera } = this.orbit; const focus = lab.focus(); this.library.call('Go', 0, camera.position.x * 0.45 + focus.x * 0.55, camera.position.z * 0.45 + focus.z * 0.55); },
      wander: on => this.library.call('Habit', 0, on ? 'wander' : 'stay', 0, 0, 4 * this.world.scale),
      call: member => this.#pick(member),
      perform: name => this.play.act(name),
      feel: name => this.library.call('Feel', 0, ...moods[name], moodSeconds),
    });
    this.breed = breedPanel({
      litter: (other, mutation) => this.#litter(other, mutation),
      raise: member => this.#raise(member),
      back: member => this.#meet(member.design).catch(problem => this.#complain(problem.message)),
      evolve: (goal, mutation, other) => (this.evolving ? this.evolving.stop() : this.#evolve(goal, mutation, other)),
    });
    this.keep = keepPanel({
      rename: name => { lab.rename(name || undefined); this.#caption(); this.breed.family(lab.family); },
      save: () => { this.keeping.save(); this.#collected(); this.status.textContent = texts.saved(this.#name()); },
      share: () => this.#share(),
      picture: () => this.#file(`${this.#name()}.png`, () => this.picture(), 'image/png'),
      loop: () => this.#file(`${this.#name()}-loop.png`, () => this.loop(), 'image/png'),
      glb: what => this.#file(`${this.#name()}.glb`, () => this.library.call('Glb', 0, what), 'model/gltf-binary'),
      json: () => this.#file(`${this.#name()}.json`, () => lab.text(), 'application/json'),
      open: file => this.#open(file),
      visit: n => this.#meet(this.keeping.collection[n].design).catch(problem => this.#complain(problem.message)),
      remove: n => { this.keeping.remove(n); this.#collected(); },
      importAll: file => this.importCollection(file),
      exportAll: () => this.keeping.exportAll(),
    });
    const panels = { make: this.make, meet: this.meet, breed: this.breed, keep: this.keep };
    const tabs = h('div', { className: 'tabs', role: 'tablist', 'aria-label': texts.title });
    const pages = [];
    for (const [name, { root }] of Object.entries(panels)) {
      const page = h('section', { id: `panel-${name}`, role: 'tabpanel', 'aria-labelledby': `tab-${name}`, tabIndex: 0 }, root);
      const tab = h('button', { type: 'button', role: 'tab', id: `tab-${name}`, 'aria-controls': page.id, onclick: () => show(name) }, texts.tabs[name]);
      tabs.append(tab);
      pages.push(page);
    }
    const show = name => {
      this.pointer.shaping = name === 'make';
      for (const tab of tabs.children) {
        const on = tab.id === `tab-${name}`;
        tab.setAttribute('aria-selected', on);
        tab.tabIndex = on ? 0 : -1;
      }
      for (const page of pages) {
        page.hidden = page.id !== `panel-${name}`;
      }
    };
    tabs.addEventListener('keydown', event => {
      const step = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
      if (step) {
        const all = [...tabs.children];
        const next = all[(all.indexOf(document.activeElement) + step + all.length) % all.length];
        next.click();
        next.focus();
      }
    });
    show('make');
    this.panel.append(tabs, ...pages);
    this.show = show;
    this.#collected();
    lab.addEventListener('met', () => this.#refresh());
    lab.addEventListener('changed', () => this.#refresh());
    lab.addEventListener('dressed', () => {
      this.#reveal();
      this.#thumb();
      // The first act that is tried takes longest: it is tried before somebody asks for one.
      this.library.call('Rehearse', 0, 'Dance').catch(() => {});
    });
    lab.addEventListener('neighbours', () => { this.meet.people(lab.neighbours); this.breed.partners(lab.neighbours); });
    lab.addEventListener('litter', () => this.breed.litter(lab.litter));
    lab.addEventListener('trouble', ({ detail }) => this.#complain(detail.message));
  }

  /** A part of another creature is put on, or one is taken off; what repair says of it is told. */
  async #part(name, method, ...more) {
    this.#work(texts.working);
    try {
      const studio = await this.studio();
      const { blueprint, parts, reasons } = JSON.parse(await studio.call(method, await this.lab.text(), name, ...more));
      const { seed, kind, name: called } = this.lab.design;
      const design = { ...ofText(blueprint, seed, kind), name: called };
      await this.lab.mend(design);
      this.history.push(design);
      this.make.tell(reasons, method === 'GivePart' && !parts.includes(name) ? texts.refused(texts.parts[name]) : texts.repaired);
      this.#refresh();
      await this.#remember();
    } catch (problem) {
      this.#complain(problem.message);
    } finally {
      this.#work('');
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
    this.status.textContent = what === 'refuses' ? texts.refuses(texts.acts[act] ?? act.toLowerCase(), reason) : texts.told[what] ?? '';
  }

  /** Breeds on towards a goal until it is stopped. */
  async #evolve(goal, mutation, other) {
    this.evolving = new Evolution(this.lab, () => this.studio(), (generations, state) =>
      this.breed.evolving(generations, state === null ? texts.working : generations ? texts.evolving(state.number, state.best) : texts.evolved(state.number)));
    try {
      this.history.push(await this.evolving.run(goal, mutation, other, () => this.#thumb()));
      await this.#remember();
    } catch (problem) {
      this.breed.evolving(null, texts.evolveHint);
      this.#complain(problem.message);
    } finally {
      this.evolving = null;
    }
  }

  /** Adds the creatures of an exported collection. */
  async importCollection(file) {
    try {
      const count = await this.keeping.take(file);
      this.#collected();
      this.status.textContent = texts.imported(count);
    } catch (problem) {
      this.#complain(texts.badFile(file.name, problem.message));
    }
  }

  picture() {
    return this.keeping.picture();
  }

  loop() {
    return this.keeping.loop();
  }

  #with(design, name, value) {
    if (name === 'strangeness') {
      return { ...design, strangeness: Math.round(100 * value) / 100 };
    }
    return { ...design, traits: { ...design.traits, [name]: value } };
  }

  #change(design) {
    this.lab.change(design);
    this.make.refresh(design, null, this.history);
  }

  async #settle() {
    const design = this.lab.design;
    this.#work(texts.working);
    try {
      const facts = await this.lab.mend(design);
      if (this.history.now !== design) {
        this.history.push(design);
      }
      this.make.tell(facts.reasons);
      this.#refresh();
      await this.#remember();
    } catch (problem) {
      this.#complain(problem.message);
    } finally {
      this.#work('');
    }
  }

  #vary(free, value) {
    let design = this.lab.design;
    for (const slider of free) {
      if (slider.name !== 'strangeness' && this.lab.facts.traits.includes(slider.name)) {
        design = this.#with(design, slider.name, value(slider, design.traits[slider.name] ?? slider.own));
      }
    }
    this.#change(design);
    this.#settle();
  }

  async #travel(design) {
    const same = design.seed === this.lab.design.seed && design.kind === this.lab.design.kind && design.text === this.lab.design.text;
    if (same) {
      this.#change(design);
      await this.#settle();
    } else {
      await this.#meet(design).catch(problem => this.#complain(problem.message));
    }
  }

  async #hatch() {
    const text = this.seed.value.trim();
    if (!/^[0-9]{1,20}$/.test(text) || BigInt(text) > maxSeed) {
      this.#complain(texts.badSeed(text));
      return;
    }
    const kind = this.kind.querySelector('[aria-checked=true]').dataset.value;
    await this.#meet(ofSeed(BigInt(text), kind)).catch(problem => this.#complain(problem.message));
  }

  #roll() {
    this.seed.value = String(Math.floor(Math.random() * 1e6));
    return this.#hatch();
  }

  #today() {
    const now = new Date();
    this.seed.value = String(now.getUTCFullYear() * 10000 + (now.getUTCMonth() + 1) * 100 + now.getUTCDate());
    return this.#hatch();
  }

  async #litter(other, mutation) {
    if (typeof other === 'string' && (!/^[0-9]{1,20}$/.test(other) || BigInt(other) > maxSeed)) {
      this.#complain(texts.badSeed(other));
      return;
    }
    try {
      await this.lab.breed(typeof other === 'string' ? ofSeed(other, this.lab.facts.kind) : other, mutation, n => this.breed.busy(texts.brooding(n)));
    } catch (problem) {
      this.#complain(problem.message);
    } finally {
      this.breed.busy(null);
    }
  }

  async #raise(member) {
    const design = await this.lab.raise(member);
    this.history.push(design);
    this.status.textContent = texts.picked(member.name);
    await this.#remember();
  }

  #pick(member) {
    if (this.lab.litter.includes(member)) {
      this.#raise(member).catch(problem => this.#complain(problem.message));
    } else if (member.slot !== 0) {
      const focus = this.lab.focus();
      const angle = this.orbit.azimuth + 0.9;
      const away = 0.8 * (this.lab.facts.length + member.facts.length);
      this.library.call('Go', member.slot, focus.x + away * Math.sin(angle), focus.z + away * Math.cos(angle));
      this.breed.partners(this.lab.neighbours, member.slot);
      this.status.textContent = `${member.name}, ${words(member.facts.body)}`;
    }
  }

  #aim(point) {
    const now = performance.now();
    if (point === null || now - this.#lookAt > 90) {
      this.#lookAt = now;
      const { x, y, z } = point ?? { x: NaN, y: NaN, z: NaN };
      this.library.call('Look', 0, x, y, z).catch(() => {});
    }
  }

  async #open(file) {
    if (file.size > largestFile) {
      this.#complain(texts.tooLarge(file.name, file.size));
      return;
    }
    try {
      await this.#meet(await this.lab.open(new Uint8Array(await file.arrayBuffer())));
    } catch (problem) {
      this.#complain(texts.badFile(file.name, problem.message));
    }
  }

  #collected() {
    this.keep.collection(this.keeping.collection);
  }

  async #share() {
    try {
      await navigator.clipboard.writeText(location.href);
      this.status.textContent = texts.shared;
    } catch {
      this.status.textContent = texts.addressIs;
    }
  }

  #snapshot(size) {
    this.#render();
    const { width, height } = this.canvas;
    const cover = this.#covered();
    const ratio = width / innerWidth;
    return squareOf(this.canvas, { width: width - cover.right * ratio, height: height - cover.bottom * ratio }, size);
  }

  /** A small picture of whoever stands there, for the family tree. */
  #thumb() {
    const { family } = this.lab;
    if (family.now && this.herd.members.get(0)?.moved) {
      family.now.thumb = this.keeping.thumb();
      this.breed.family(family);
    }
  }

  async #file(name, make, type) {
    this.#work(texts.working);
    try {
      download(name, await make(), type);
    } catch (problem) {
      this.#complain(problem.message);
    } finally {
      this.#work('');
    }
  }

  async #openGrid() {
    this.grid ??= new Grid(() => this.studio(), design => this.#meet(design).catch(problem => this.#complain(problem.message)));
    try {
      this.grid.open(this.lab.design, await this.lab.parents());
    } catch (problem) {
      this.#complain(problem.message);
    }
  }

  #name() {
    return this.keeping.name;
  }

  #caption() {
    const facts = this.lab.facts;
    this.title.textContent = this.#name();
    this.subtitle.textContent = [words(facts.bodies[0]), weight(facts.mass), length(facts.length)].join(' · ');
    document.title = `${this.#name()}, ${texts.title}`;
    this.keep.named(this.#name());
  }

  #refresh() {
    const { design, facts } = this.lab;
    this.make.refresh(design, facts, this.history);
    this.meet.refresh(facts);
    this.breed.partners(this.lab.neighbours);
    this.breed.family(this.lab.family);
    this.meet.people(this.lab.neighbours);
    this.touch.learn().catch(() => {});
    this.#caption();
    this.seed.value = design.seed;
    this.kind.take(facts.kind);
    this.#reveal();
  }

  #reveal() {
    const { body } = this.herd.members.get(0);
    this.overlay.clear();
    body.wireframe = this.look === 'wire';
    body.flat = this.look === 'flat';
    this.gaits.shown = this.look === 'feet';
    body.skin.visible = this.look !== 'capsules';
    body.skin.material.forEach(material => { material.transparent = this.look === 'bones'; material.opacity = this.look === 'bones' ? 0.55 : 1; });
    if (this.look === 'feet') {
      this.overlay.feet(this.herd.members.get(0));
    } else if (this.look === 'bones') {
      this.overlay.bones(body);
    } else if (this.look === 'capsules') {
      this.library.call('Capsules', 0).then(bytes => this.overlay.capsules(body, new Float32Array(bytes.buffer, bytes.byteOffset, bytes.byteLength / 4)));
    }
  }

  /** The address tells the creature. */
  async #remember() {
    const { design } = this.lab;
    this.address = design.text === null ? seedAddress(design) : `#b=${await this.library.call('Address', 0)}`;
    window.history.replaceState(null, '', this.address);
  }

  #work(text) {
    this.status.textContent = text;
    document.body.classList.toggle('working', text !== '');
  }

  #complain(text) {
    this.alert.replaceChildren(h('p', {}, text), h('button', { type: 'button', className: 'quiet', 'aria-label': texts.close, onclick: () => { this.alert.hidden = true; } }, icon('close')));
    this.alert.hidden = false;
  }

  #uncover() {
    document.getElementById('cover')?.remove();
  }

  #covered() {
    const narrow = innerWidth < 760;
    return { right: narrow ? 0 : 360, bottom: narrow ? Math.round(innerHeight * 0.42) : 0 };
  }

  #size() {
    this.drawing.apply(this.world, innerWidth, innerHeight);
    this.orbit.fit(innerWidth, innerHeight, this.#covered());
  }

  #draw(now) {
    const milliseconds = now - this.#before;
    this.#before = now;
    // Where a picture takes long it is drawn half the time at most: the library is to live, too.
    const rest = milliseconds > 60 ? Math.min(milliseconds, 500) : 0;
    setTimeout(() => requestAnimationFrame(next => this.#draw(next)), rest);
    if (this.still || !this.herd.members.get(0)) {
      return;
    }
    this.advance(Math.min(milliseconds / 1000, 0.1));
    this.#render();
    if (this.drawing.judge(milliseconds)) {
      this.#size();
    }
  }

  /** Lets time go on. */
  async advance(seconds) {
    this.#stopFirst();
    const done = this.lab.settled ? this.herd.step(seconds) : null;
    const member = this.herd.members.get(0);
    if (member && this.lab.litter.length === 0 && this.lab.settled) {
      this.orbit.goal.copy(this.lab.focus());
    }
    this.herd.glide(seconds);
    this.overlay.update();
    this.gaits.update(seconds, member);
    this.treats.update(seconds);
    this.#coarsen();
    this.world.update(seconds, this.orbit.focus);
    this.orbit.update(seconds, this.world);
    if (performance.now() - this.#told > 500 && this.meet) {
      this.#told = performance.now();
      this.meet.cost(this.herd.frameCost(), this.herd.members.size);
    }
    await done;
  }

  /** Those that are far are drawn with fewer triangles. */
  #coarsen() {
    const { position } = this.orbit.camera;
    for (const { slot, body, facts } of this.herd.members.values()) {
      body.far = slot !== 0 && body.group.position.distanceTo(position) > farLengths * Math.max(facts.length, facts.height);
    }
  }

  #render() {
    this.drawing.renderer.render(this.world.scene, this.orbit.camera);
  }

  /** One picture with the whole drawing, for tests of the looks: lets time go on in even steps, then draws once. */
  async portrait(steps) {
    for (let i = 0; i < steps; i++) {
      await this.advance(1 / 30);
    }
    this.orbit.jump();
    this.orbit.update(0, this.world);
    this.#render();
  }
}
