import { Library } from './library.js';
import { World } from './world/world.js';
import { Herd } from './creature/herd.js';
import { Overlay } from './creature/overlays.js';
import { Orbit } from './view/orbit.js';
import { Drawing } from './view/renderer.js';
import { Pointer } from './view/pointer.js';
import { Sound } from './view/sound.js';
import { Lab, showFirst } from './lab.js';
import { History, maxSeed, ofSeed, readAddress, seedAddress } from './design.js';
import { choices, h, icon } from './dom.js';
import { nameOf } from './names.js';
import { download, readCollection, writeCollection } from './storage.js';
import { length, texts, weight, words } from './texts.js';
import { makePanel } from './panels/make.js';
import { meetPanel } from './panels/meet.js';
import { breedPanel } from './panels/breed.js';
import { keepPanel } from './panels/keep.js';
import { Grid } from './panels/grid.js';

const largestFile = 32e6;
const pictureSize = 1000;
const first = ofSeed('3', 'walking');

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
    this.lab = new Lab(this.library, () => this.studio(), this.world, this.herd, this.orbit);
    this.look = 'skin';
    this.collection = readCollection();
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
    this.#panels(JSON.parse(await this.library.call('Sliders')));
    await this.#arrive(wanted).catch(async problem => {
      this.#complain(texts.badAddress(problem.message));
      await this.#arrive(first);
    });
    addEventListener('hashchange', () => this.#follow());
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
    const pointer = new Pointer(this.canvas, this.orbit, this.world, this.herd);
    pointer.addEventListener('look', ({ detail }) => this.#aim(detail));
    pointer.addEventListener('send', ({ detail }) => this.library.call('Go', 0, detail.x, detail.z));
    pointer.addEventListener('pick', ({ detail }) => this.#pick(detail));
    this.herd.onFootfall = (place, strength) => this.sound.step(strength, place.distanceTo(this.orbit.focus) / this.world.scale, this.lab.facts?.mass ?? 50);
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

  #panels(sliders) {
    const lab = this.lab;
    this.make = makePanel(sliders, {
      slide: (name, value) => this.#change(this.#with(lab.design, name, value)),
      settle: () => this.#settle(),
      undo: () => this.#travel(this.history.undo()),
      redo: () => this.#travel(this.history.redo()),
      random: free => this.#vary(free, slider => slider.least + (slider.most - slider.least) * (0.15 + 0.7 * Math.random())),
      nudge: free => this.#vary(free, (slider, value) => Math.min(slider.most, Math.max(slider.least, value + (slider.most - slider.least) * 0.24 * (Math.random() - 0.5)))),
      reset: () => { this.#change({ ...lab.design, traits: {}, strangeness: 0 }); this.#settle(); },
      look: look => { this.look = look; this.#reveal(); },
    });
    this.meet = meetPanel({
      come: () => { const { camera } = this.orbit; const focus = lab.focus(); this.library.call('Go', 0, camera.position.x * 0.45 + focus.x * 0.55, camera.position.z * 0.45 + focus.z * 0.55); },
      push: () => { const focus = lab.focus(); const { position } = this.orbit.camera; this.library.call('Push', 0, focus.x - position.x, focus.z - position.z); },
      wander: on => this.library.call('Habit', 0, on ? 'wander' : 'stay', 0, 0, 4 * this.world.scale),
      call: member => this.#pick(member),
      sound: on => this.sound.turn(on),
    });
    this.breed = breedPanel({
      litter: (other, mutation) => this.#litter(other, mutation),
      raise: member => this.#raise(member),
      back: n => { const { design } = lab.family[n]; lab.family.length = n; this.#meet(design).catch(problem => this.#complain(problem.message)); },
    });
    this.keep = keepPanel({
      rename: name => { lab.design = { ...lab.design, name: name || undefined }; this.#caption(); },
      save: () => this.#save(),
      share: () => this.#share(),
      picture: () => this.#picture(),
      glb: what => this.#file(`${this.#name()}.glb`, () => this.library.call('Glb', 0, what), 'model/gltf-binary'),
      json: () => this.#file(`${this.#name()}.json`, () => lab.text(), 'application/json'),
      open: file => this.#open(file),
      visit: n => this.#meet(this.collection[n].design).catch(problem => this.#complain(problem.message)),
      remove: n => { this.collection.splice(n, 1); this.#collected(); },
      exportAll: () => download('creatures.json', JSON.stringify(this.collection, null, 1), 'application/json'),
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
    lab.addEventListener('dressed', () => this.#reveal());
    lab.addEventListener('neighbours', () => { this.meet.people(lab.neighbours); this.breed.partners(lab.neighbours); });
    lab.addEventListener('litter', () => this.breed.litter(lab.litter));
    lab.addEventListener('trouble', ({ detail }) => this.#complain(detail.message));
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
    this.breed.family(this.lab.family);
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

  #save() {
    const { seed, kind, strangeness, traits, text } = this.lab.design;
    this.collection.unshift({ name: this.#name(), design: { seed: String(seed), kind, strangeness, traits, text, name: this.#name() } });
    this.#collected();
    this.status.textContent = texts.saved(this.#name());
  }

  #collected() {
    writeCollection(this.collection);
    this.keep.collection(this.collection);
  }

  async #share() {
    try {
      await navigator.clipboard.writeText(location.href);
      this.status.textContent = texts.shared;
    } catch {
      this.status.textContent = texts.addressIs;
    }
  }

  /** What is seen, cut to a square about the creature, with its blueprint in it. */
  async picture() {
    this.#render();
    const { width, height } = this.canvas;
    const side = Math.min(width, height);
    const cover = this.#covered();
    const ratio = width / innerWidth;
    const square = new OffscreenCanvas(pictureSize, pictureSize);
    square.getContext('2d').drawImage(this.canvas, Math.max(0, (width - cover.right * ratio - side) / 2), Math.max(0, (height - cover.bottom * ratio - side) / 2), side, side, 0, 0, pictureSize, pictureSize);
    const png = new Uint8Array(await (await square.convertToBlob({ type: 'image/png' })).arrayBuffer());
    return this.library.call('Sign', png, 0);
  }

  #picture() {
    return this.#file(`${this.#name()}.png`, () => this.picture(), 'image/png');
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
    this.grid.open(this.lab.design);
  }

  #name() {
    const { name, seed, kind } = this.lab.design;
    return name ?? nameOf(seed, kind);
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
    this.meet.people(this.lab.neighbours);
    this.#caption();
    this.seed.value = design.seed;
    this.kind.take(facts.kind);
    this.#reveal();
  }

  #reveal() {
    const { body } = this.herd.members.get(0);
    this.overlay.clear();
    body.wireframe = this.look === 'wire';
    body.skin.visible = this.look !== 'capsules';
    body.skin.material.forEach(material => { material.transparent = this.look === 'bones'; material.opacity = this.look === 'bones' ? 0.55 : 1; });
    if (this.look === 'bones') {
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
    this.overlay.update();
    this.world.update(seconds, this.orbit.focus);
    this.orbit.update(seconds, this.world);
    if (performance.now() - this.#told > 500 && this.meet) {
      this.#told = performance.now();
      this.meet.cost(this.herd.frameCost(), this.herd.members.size);
    }
    await done;
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
