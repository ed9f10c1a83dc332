import { h } from '../dom.js';
import { length, texts, weight, words } from '../texts.js';

/** Who it is, and who lives round it. */
export function meetPanel(act) {
  const facts = h('dl', { className: 'facts' });
  const near = h('ul', { className: 'people' });
  const cost = h('p', { className: 'fine' });
  const sound = h('input', { type: 'checkbox', id: 'sound', onchange: () => act.sound(sound.checked) });
  const root = h('div', {},
    facts,
    h('div', { className: 'row' },
      h('button', { type: 'button', className: 'loud', onclick: act.come }, texts.come),
      h('button', { type: 'button', onclick: act.push }, texts.push),
      h('button', { type: 'button', 'aria-pressed': 'false', onclick: event => {
        const on = event.currentTarget.getAttribute('aria-pressed') !== 'true';
        event.currentTarget.setAttribute('aria-pressed', on);
        act.wander(on);
      } }, texts.wander)),
    h('p', { className: 'hint' }, texts.hint),
    h('h3', {}, texts.neighbours),
    near,
    h('label', { className: 'check', htmlFor: 'sound' }, sound, texts.sound),
    cost);
  return {
    root,
    refresh(f) {
      const rows = [
        [texts.facts.plan, words(f.plan)],
        [texts.facts.body, f.bodies.slice(0, 3).map(words).join(', ')],
        [texts.facts.mass, weight(f.mass)],
        [texts.facts.length, length(f.length)],
        [f.medium === 'ground' ? texts.facts.pace : texts.facts.flight, `${f.pace.toFixed(2)} m/s`],
        f.legs ? [texts.facts.legs, f.legs] : null,
        f.generation ? [texts.facts.generation, f.generation] : null,
      ];
      facts.replaceChildren(...rows.filter(Boolean).map(([what, value]) => h('div', {}, h('dt', {}, what), h('dd', {}, value))));
    },
    people(neighbours) {
      near.replaceChildren(...neighbours.map(member => h('li', {},
        h('button', { type: 'button', className: 'person', onclick: () => act.call(member) }, h('b', {}, member.name), h('span', {}, words(member.facts.body))))));
    },
    cost(ms, count) {
      cost.textContent = texts.cost(ms, count);
    },
  };
}
