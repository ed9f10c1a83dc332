import { h } from '../dom.js';
import { face } from './face.js';
import { beast, length, texts, weight, words } from '../texts.js';

const more = ['Sit', 'Lie', 'Sniff', 'Eat', 'Drink', 'Shake', 'Scratch', 'Groom', 'Bite', 'Claw', 'Kick', 'TailSweep', 'Threaten', 'Submit'];

/** Who it is, what it can do, and who lives round it. */
export function meetPanel(act) {
  const facts = h('dl', { className: 'facts' });
  const near = h('ul', { className: 'people' });
  const cost = h('p', { className: 'fine' });
  const moods = h('div', { className: 'row' }, ...Object.entries(texts.moods).map(([name, text]) => h('button', { type: 'button', className: 'chip', onclick: () => act.feel(name) }, text)));
  const acts = h('div', { className: 'row' }, ...more.map(name => h('button', { type: 'button', className: 'chip', onclick: () => act.perform(name) }, texts.acts[name])));
  const root = h('div', {},
    facts,
    h('div', { className: 'row' },
      h('button', { type: 'button', className: 'loud', onclick: act.come }, texts.come),
      h('button', { type: 'button', 'aria-pressed': 'false', onclick: event => {
        const on = event.currentTarget.getAttribute('aria-pressed') !== 'true';
        event.currentTarget.setAttribute('aria-pressed', on);
        act.wander(on);
      } }, texts.wander)),
    h('p', { className: 'hint' }, texts.hint),
    h('h3', {}, texts.canDo), acts,
    h('h3', {}, texts.mood), moods,
    h('h3', {}, texts.neighbours),
    near,
    cost);
  return {
    root,
    refresh(f) {
      const rows = [
        [texts.facts.body, f.bodies.slice(0, 3).map(beast).join(', '), 'long'],
        [texts.facts.plan, words(f.plan)],
        [texts.facts.mass, weight(f.mass)],
        [texts.facts.length, length(f.length)],
        [f.medium === 'ground' ? texts.facts.pace : texts.facts.flight, `${f.pace.toFixed(2)} m/s`],
        f.legs ? [texts.facts.legs, f.legs] : null,
        f.generation ? [texts.facts.generation, f.generation] : null,
      ];
      facts.replaceChildren(...rows.filter(Boolean).map(([what, value, room = '']) => h('div', { className: room }, h('dt', {}, what), h('dd', {}, value))));
    },
    people(neighbours) {
      near.replaceChildren(...neighbours.map(member => h('li', {},
        h('button', { type: 'button', className: 'person', onclick: () => act.call(member) }, face(member), h('b', {}, member.name), h('span', {}, beast(member.facts.body))))));
    },
    cost(ms, count) {
      cost.textContent = texts.cost(ms, count);
    },
  };
}
