import { h } from '../dom.js';
import { texts, words } from '../texts.js';
import { treeOf } from './tree.js';

const drawnGenerations = 400;

/** Two parents, nine children; a family to walk through; and breeding towards a goal. */
export function breedPanel(act) {
  const partner = h('select', { id: 'partner' });
  const seed = h('input', { id: 'partner-seed', type: 'text', inputMode: 'numeric', value: '7', maxLength: 20, 'aria-label': texts.partnerSeed, hidden: true });
  partner.addEventListener('change', () => { seed.hidden = partner.value !== 'seed'; });
  const other = () => (partner.value === 'seed' ? seed.value.trim() : Number(partner.value));
  const mutation = h('input', { id: 'mutation', type: 'range', min: 0, max: 1, step: 0.05, value: 0.25 });
  const go = h('button', { type: 'button', className: 'loud', onclick: () => act.litter(other(), Number(mutation.value)) }, texts.litter);
  const state = h('p', { className: 'hint', role: 'status' }, texts.litterHint);
  const children = h('ul', { className: 'people' });
  const family = h('div', { className: 'family' });

  const goal = h('select', { id: 'goal' }, ...Object.entries(texts.goals).map(([value, text]) => h('option', { value }, text)));
  const evolve = h('button', { type: 'button', className: 'loud', onclick: () => act.evolve(goal.value, Number(mutation.value), other()) }, texts.evolve);
  const chart = document.createElementNS('http://www.w3.org/2000/svg', 'svg');
  chart.setAttribute('class', 'chart');
  chart.setAttribute('viewBox', '0 0 300 80');
  chart.setAttribute('preserveAspectRatio', 'none');
  chart.setAttribute('aria-hidden', 'true');
  const progress = h('p', { className: 'hint', role: 'status' }, texts.evolveHint);

  const root = h('div', {},
    h('label', { className: 'field', htmlFor: 'partner' }, texts.partner), h('div', { className: 'row' }, partner, seed),
    h('label', { className: 'field', htmlFor: 'mutation' }, texts.mutation), mutation,
    h('div', { className: 'row' }, go),
    state, children, family,
    h('h3', {}, texts.towards),
    h('div', { className: 'row nowrap' }, h('label', { className: 'hidden', htmlFor: 'goal' }, texts.towards), goal, evolve),
    progress, chart);
  return {
    root,
    partners(neighbours, chosen) {
      const before = chosen ?? partner.value;
      partner.replaceChildren(...neighbours.map(member => h('option', { value: member.slot }, `${member.name}, ${words(member.facts.body)}`)), h('option', { value: 'seed' }, texts.partnerSeed));
      if ([...partner.options].some(option => option.value === String(before))) {
        partner.value = before;
      }
      seed.hidden = partner.value !== 'seed';
    },
    litter(members) {
      children.replaceChildren(...members.map(member => h('li', {}, h('button', { type: 'button', className: 'person', onclick: () => act.raise(member), 'aria-label': texts.pick(member.name) }, h('b', {}, member.name), h('span', {}, words(member.facts.plan))))));
    },
    busy(text) {
      go.disabled = text !== null;
      state.textContent = text ?? texts.litterHint;
    },
    family(all) {
      family.replaceChildren(...(all.members.length > 1 ? [h('h3', {}, texts.family), treeOf(all, act.back)] : []));
    },
    /** How far breeding towards a goal has come; null when it is over. */
    evolving(generations, text) {
      evolve.textContent = generations ? texts.evolveStop : texts.evolve;
      evolve.setAttribute('aria-pressed', generations ? 'true' : 'false');
      progress.textContent = text;
      goal.disabled = !!generations;
      if (generations) {
        const shown = generations.slice(-drawnGenerations);
        const most = Math.max(...shown.map(one => one.best), 1e-9);
        const line = key => shown.map((one, n) => `${n ? 'L' : 'M'}${(300 * n) / Math.max(shown.length - 1, 1)} ${76 - (70 * one[key]) / most}`).join('');
        chart.replaceChildren(...[['median', '#8aa396'], ['best', '#c8431d']].map(([key, colour]) => {
          const path = document.createElementNS('http://www.w3.org/2000/svg', 'path');
          path.setAttribute('d', line(key));
          path.setAttribute('stroke', colour);
          return path;
        }));
      }
    },
  };
}
