import { DirectionalLight, HemisphereLight, PerspectiveCamera, Scene } from 'three';
import { Body, readMesh } from '../creature/body.js';
import { Herd } from '../creature/herd.js';
import { growing, ofSeed, ofText, usualStrangeness } from '../design.js';
import { nameOfDesign } from '../lab.js';
import { choices, h, icon } from '../dom.js';
import { nameOf } from '../names.js';
import { beast, texts, words } from '../texts.js';
import { openRenderer } from '../view/renderer.js';

const firstSlot = 4;
const slots = 24;
const batch = 12;
const margin = 300;
const apart = 1000;
const captionHeight = 50;
const childMutation = 0.25;

// Seeds that are looked at in one go, and the milliseconds after them in which the worker does other things.
const stretch = 100n;
const breath = 50;

// Metres of scale at which creatures count as small and as large.
const sizes = { all: () => true, small: scale => scale < 0.7, medium: scale => scale >= 0.7 && scale <= 1.4, large: scale => scale > 1.4 };

/** Creatures of consecutive seeds, without end, alive while they are seen. They live in the second worker. */
export class Grid {
  #next = 1n;
  #filling = false;
  #round = 0;
  #free = [];
  #rest = 0;
  #picture = 0;
  #filters = { kind: 'walking', size: 'all', plan: 'all', strangeness: usualStrangeness };
  #plans = new Set();
  #who = 'seeds';

  /** Cards in their order, by their items: who is on them, a glance at them, and the slot in which they live if they are grown. */
  cards = new Map();

  /** @param act `choose` takes the one that is picked, `shown` hears whether the grid is open. */
  constructor(studio, act) {
    Object.assign(this, { studio, act });
  }

  /** @param design whose species and family can be seen. @param family the blueprints of its parents, or of itself and another, and its name. */
  async open(design, family) {
    this.library = await this.studio();
    this.design = design;
    this.family = family;
    this.#build();
    this.#take(design.kind === 'any' ? 'walking' : design.kind);
    this.#choose(this.#who === 'species' && design.text !== null ? 'seeds' : this.#who);
    this.dialog.showModal();
    this.act.shown(true);
    this.#begin();
    this.#picture = requestAnimationFrame(now => this.#draw(now, now));
  }

  #build() {
    if (this.dialog) {
      return;
    }
    this.canvas = h('canvas', { className: 'cards', 'aria-hidden': 'true' });
    this.list = h('ul', { className: 'grid' });
    this.end = h('p', { className: 'hint', role: 'status' }, texts.working);
    this.plan = h('select', { 'aria-label': texts.filters.plan, onchange: () => { this.#filters.plan = this.plan.value; this.#begin(); } });
    const strange = h('input', { type: 'range', min: 0, max: 1, step: 0.1, value: usualStrangeness, 'aria-label': texts.filters.strange, onchange: () => { this.#filters.strangeness = Number(strange.value); this.#begin(); } });
    this.scroller = h('div', { className: 'scroller', tabIndex: 0 }, this.list, this.end);
    this.dialog = h('dialog', { className: 'many', 'aria-label': texts.grid },
      h('div', { className: 'filters' },
        h('h2', {}, texts.grid),
        this.whose = choices(texts.grid, texts.who, 'seeds', who => { this.#choose(who); this.#begin(); }),
        this.kind = choices(texts.kind, texts.kinds, this.#filters.kind, kind => { this.#take(kind); this.#begin(); }),
        this.size = choices(texts.filters.size, { all: texts.filters.all, small: texts.filters.small, medium: texts.filters.medium, large: texts.filters.large }, 'all', size => { this.#filters.size = size; this.#begin(); }),
        this.plan,
        this.strange = h('label', { className: 'strange' }, texts.filters.strange, strange),
        h('button', { type: 'button', className: 'quiet', 'aria-label': texts.close, onclick: () => this.dialog.close() }, icon('close'))),
      this.scroller, this.canvas);
    this.dialog.addEventListener('close', () => {
      clearTimeout(this.#rest);
      cancelAnimationFrame(this.#picture);
      this.act.shown(false);
      this.#round++;
      this.#clear();
    });
    document.body.append(this.dialog);

    const { renderer, quick } = openRenderer(this.canvas, { alpha: true });
    this.renderer = renderer;
    this.sharpness = quick ? 2 : 0.6;
    this.renderer.setScissorTest(true);
    this.scene = new Scene();
    const sun = new DirectionalLight('#fff3da', 3);
    sun.position.set(0.6, 1, 0.7);
    this.scene.add(sun, new HemisphereLight('#d8ecf6', '#9aa86a', 2.2));
    this.herd = new Herd(this.library, this.scene);
    this.herd.eye = -1;
    this.camera = new PerspectiveCamera(28, 1, 0.01, 500);
    new IntersectionObserver(entries => entries.some(entry => entry.isIntersecting) && this.#fill(), { root: this.scroller, rootMargin: `${margin}px` }).observe(this.end);
    this.seen = new IntersectionObserver(entries => {
      for (const { target, isIntersecting } of entries) {
        const card = this.cards.get(target);
        if (card) {
          card.seen = isIntersecting;
        }
      }
      this.#wake();
    }, { root: this.scroller });
  }

  /** Everybody, one species, or one family: filters are for everybody. */
  #choose(who) {
    this.#who = who;
    this.whose.take(who);
    for (const filter of [this.kind, this.size, this.plan, this.strange]) {
      filter.hidden = who !== 'seeds';
    }
    this.whose.querySelector('[data-value=species]').disabled = this.design.text !== null;
  }

  /** Another kind has builds of its own. */
  #take(kind) {
    if (kind !== this.#filters.kind) {
      this.#plans.clear();
      Object.assign(this.#filters, { kind, plan: 'all' });
    }
    this.kind.take(kind);
    this.#offer();
  }

  /** The builds that were seen so far can be asked for. */
  #offer() {
    this.plan.replaceChildren(h('option', { value: 'all' }, texts.filters.anyBuild), ...[...this.#plans].sort().map(name => h('option', { value: name }, words(name))));
    this.plan.value = this.#filters.plan;
  }

  /** The next that may be shown; null for one that no filter lets through. */
  async #candidate(n) {
    if (this.#who === 'family') {
      return { child: n, name: nameOf(`${this.design.seed}.${n}`, this.design.kind) };
    }
    const { kind, size, plan, strangeness } = this.#filters;
    const design = this.#who === 'species' ? ofSeed(this.design.seed, this.design.kind, this.design.strangeness, n) : ofSeed(n, kind, strangeness);
    let glance;
    try {
      glance = JSON.parse(await this.library.call('Glance', design.seed, design.kind, design.strangeness, design.individual));
    } catch (problem) {
      return { design, problem };
    }
    if (this.#who === 'species') {
      return { design, glance };
    }
    if (!this.#plans.has(glance.plan)) {
      this.#plans.add(glance.plan);
      this.#offer();
    }
    return sizes[size](glance.scale) && (plan === 'all' || plan === glance.plan) ? { design, glance } : null;
  }

  async #begin() {
    this.#round++;
    this.#next = 1n;
    this.end.textContent = texts.working;
    await this.#clear();
    this.#fill();
  }

  async #clear() {
    const gone = [...this.herd.members.keys()];
    this.cards.clear();
    this.seen.disconnect();
    this.list.replaceChildren();
    this.#free = Array.from({ length: slots }, (_, n) => firstSlot + n);
    await Promise.all(gone.map(slot => this.herd.remove(slot)));
  }

  /** Adds the next creatures that pass the filters, however many seeds that takes, and says how many it were. */
  async #fill() {
    if (this.#filling) {
      return;
    }
    this.#filling = true;
    const round = this.#round;
    for (let added = 0; added < batch && round === this.#round;) {
      const looked = this.#next++;
      const candidate = await this.#candidate(looked);
      if (candidate && round === this.#round) {
        this.#add(candidate);
        added++;
      }
      if (looked % stretch === 0n) {
        this.end.textContent = texts.looked(looked);
        await new Promise(done => setTimeout(done, breath));
      }
    }
    this.#filling = false;
    const more = this.end.getBoundingClientRect().top < this.scroller.getBoundingClientRect().bottom + margin;
    if (this.dialog.open && (round !== this.#round || more)) {
      this.#fill();
    }
  }

  #add({ design, glance, child, problem, name = nameOfDesign(design) }) {
    const told = h('span', {}, glance ? `${beast(glance.body)} · ${design.individual || design.seed}` : texts.child);
    const card = { design, glance, child, name, told, seen: false, slot: null };
    card.item = h('li', {}, h('button', { type: 'button', className: 'card', onclick: () => this.#meet(card) }, h('b', {}, name), told));
    if (problem) {
      this.#fail(card, problem);
    }
    this.cards.set(card.item, card);
    this.list.append(card.item);
    this.seen.observe(card.item);
  }

  /** Tells on a card why nobody lives there. */
  #fail(card, problem) {
    card.failed = true;
    card.told.textContent = texts.notGrown(problem.message);
    card.told.className = 'wrong';
  }

  /** One of them is met: a child by the blueprint that it was born with. */
  async #meet({ design, name, slot }) {
    if (!design && slot === null) {
      return;
    }
    const text = design ? null : await this.library.call('Blueprint', slot);
    const chosen = design ?? { ...ofText(text, this.herd.members.get(slot).facts.seed, this.herd.members.get(slot).facts.kind), name };
    this.dialog.close();
    this.act.choose(chosen);
  }

  /** Grows those that are seen, one after the other, in the slots of those that are not. */
  async #wake() {
    if (this.waking) {
      return;
    }
    this.waking = true;
    const round = this.#round;
    for (let card; round === this.#round && (card = [...this.cards.values()].find(c => c.seen && c.slot === null && !c.failed));) {
      if (this.#free.length === 0) {
        const asleep = [...this.cards.values()].find(c => !c.seen && c.slot !== null);
        if (!asleep) {
          break;
        }
        await this.herd.remove(asleep.slot);
        if (round !== this.#round) {
          break;
        }
        this.#free.push(asleep.slot);
        asleep.slot = null;
      }
      const slot = this.#free.pop();
      try {
        const facts = JSON.parse(await this.#grow(slot, card));
        const bytes = round === this.#round ? await this.#settle(slot) : null;
        if (round === this.#round) {
          this.herd.put(slot, facts, new Body(readMesh(bytes.buffer, bytes.byteOffset)));
          card.slot = slot;
        } else {
          await this.library.call('Remove', slot);
        }
      } catch (problem) {
        this.#fail(card, problem);
        if (round === this.#round) {
          this.#free.push(slot);
        }
      }
    }
    this.waking = false;
    if (round !== this.#round) {
      this.#wake();
    }
  }

  /** Lets whoever was grown in a slot stay there, far from others: the mesh. */
  async #settle(slot) {
    const calls = [['Place', slot, apart * slot, 0, 0, 0], ['Habit', slot, 'stay', apart * slot, 0, 1], ['Mesh', slot]];
    return (await Promise.all(calls.map(call => this.library.call(...call)))).at(-1);
  }

  #grow(slot, { design, child }) {
    return this.library.call(...(design ? growing(slot, design) : ['GrowChild', slot, ...this.family, String(child), childMutation, 1]));
  }

  #draw(now, before) {
    const milliseconds = now - before;
    const rest = milliseconds > 60 ? Math.min(milliseconds, 500) : 0;
    this.#rest = setTimeout(() => { this.#picture = requestAnimationFrame(next => this.#draw(next, now)); }, rest);
    const seconds = Math.min(milliseconds / 1000, 0.1);
    this.herd.step(seconds);
    this.herd.glide(seconds);
    this.render();
  }

  /** Each card's creature, drawn where its card lies. */
  render() {
    const frame = this.scroller.getBoundingClientRect();
    const { renderer, camera } = this;
    this.canvas.style.height = `${frame.height}px`;
    renderer.setPixelRatio(Math.min(devicePixelRatio, this.sharpness));
    renderer.setSize(frame.width, frame.height, false);
    renderer.setScissor(0, 0, frame.width, frame.height);
    renderer.setClearAlpha(0);
    renderer.clear();
    for (const card of this.cards.values()) {
      const member = this.herd.members.get(card.slot);
      if (!card.seen || !member?.moved) {
        continue;
      }
      const whole = card.item.getBoundingClientRect();
      const rect = { width: whole.width, height: whole.height - captionHeight };
      const [x, y] = [whole.left - frame.left, frame.bottom - whole.bottom + captionHeight];
      for (const other of this.herd.members.values()) {
        other.body.group.visible = other === member;
      }
      const { height, length } = member.facts;
      const focus = member.body.middle();
      const far = 2.5 * Math.max(0.72 * length, height);
      camera.aspect = rect.width / rect.height;
      camera.near = far / 50;
      camera.far = far * 20;
      camera.position.set(focus.x + far * 0.62, focus.y + far * 0.26, focus.z + far * 0.74);
      camera.lookAt(focus);
      camera.updateProjectionMatrix();
      renderer.setViewport(x, y, rect.width, rect.height);
      renderer.setScissor(x, y, rect.width, rect.height);
      renderer.render(this.scene, camera);
    }
  }
}
