import { h, icon } from '../dom.js';
import { beast, texts, words } from '../texts.js';
import { face } from './face.js';
import { treeOf } from './tree.js';

const drawnGenerations = 400;

/** Two parents, nine children; a family to walk through; and breeding towards a goal. */
export function breedPanel(act) {
  let wished = false;
  const court = () => {
    wished = true;
    seed.hidden = partner.value !== 'seed';
    act.court(other());
  };
  const partner = h('select', { id: 'partner', onchange: court });
  const seed = h('input', { id: 'partner-seed', type: 'text', inputMode: 'numeric', value: '7', maxLength: 20, 'aria-label': texts.partnerSeed, hidden: true, onchange: court });
  const other = () => (partner.value === 'seed' ? seed.value.trim() : Number(partner.value));
  const waits = () => !wished && partner.value === 'seed';
  const pair = h('div', { className: 'pair' });
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
    pair,
    h('label', { className: 'field', htmlFor: 'partner' }, texts.partner), h('div', { className: 'row' }, partner, seed),
    h('label', { className: 'field', htmlFor: 'mutation' }, texts.mutation), mutation,
    h('div', { className: 'row' }, go),
    state, children, family,
    h('h3', {}, texts.towards),
    h('div', { className: 'row nowrap' }, h('label', { className: 'hidden', htmlFor: 'goal' }, texts.towards), goal, evolve),
    progress, chart);
  return {
    root,
    /** The other parent as somebody wants it; null while nobody has come who could be. */
    other: () => (waits() ? null : other()),
    /** Who could be the other parent; whoever came first is taken until somebody says otherwise. */
    partners(neighbours) {
      const before = wished ? partner.value : String(neighbours[0]?.slot ?? 'seed');
      partner.replaceChildren(...neighbours.map(member => h('option', { value: member.slot }, `${member.name}, ${beast(member.facts.body)}`)), h('option', { value: 'seed' }, texts.partnerSeed));
      if ([...partner.options].some(option => option.value === before)) {
        partner.value = before;
      } else {
        wished = false;
      }
      seed.hidden = partner.value !== 'seed';
    },
    choose(slot) {
      if ([...partner.options].some(option => option.value === String(slot))) {
        partner.value = slot;
        court();
      }
    },
    /** Shows the two, side by side. */
    pair(...two) {
      pair.replaceChildren(...two.map(one => h('figure', {}, one?.thumb ? h('img', { src: one.thumb, alt: '', width: 96, height: 96 }) : h('i', {}), h('figcaption', {}, one?.name ?? '…'))));
      pair.firstChild.after(icon('heart'));
    },
    litter(members) {
      children.replaceChildren(...members.map(member => h('li', {}, h('button', { type: 'button', className: 'person', onclick: () => act.raise(member), 'aria-label': texts.pick(member.name) }, face(member), h('b', {}, member.name), h('span', {}, words(member.facts.plan))))));
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
