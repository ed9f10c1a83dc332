import { h } from '../dom.js';
import { texts, words } from '../texts.js';

/** Two parents, nine children. */
export function breedPanel(act) {
  const partner = h('select', { id: 'partner' });
  const seed = h('input', { id: 'partner-seed', type: 'text', inputMode: 'numeric', value: '7', maxLength: 20, 'aria-label': texts.partnerSeed, hidden: true });
  partner.addEventListener('change', () => { seed.hidden = partner.value !== 'seed'; });
  const mutation = h('input', { id: 'mutation', type: 'range', min: 0, max: 1, step: 0.05, value: 0.25 });
  const go = h('button', { type: 'button', className: 'loud', onclick: () => act.litter(partner.value === 'seed' ? seed.value.trim() : Number(partner.value), Number(mutation.value)) }, texts.litter);
  const state = h('p', { className: 'hint', role: 'status' }, texts.litterHint);
  const children = h('ul', { className: 'people' });
  const family = h('div', { className: 'family' });
  const root = h('div', {},
    h('label', { className: 'field', htmlFor: 'partner' }, texts.partner), h('div', { className: 'row' }, partner, seed),
    h('label', { className: 'field', htmlFor: 'mutation' }, texts.mutation), mutation,
    h('div', { className: 'row' }, go),
    state, children, family);
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
    family(trail) {
      family.replaceChildren(...(trail.length ? [h('h3', {}, texts.family), ...trail.map((ancestor, n) => h('button', { type: 'button', className: 'chip', onclick: () => act.back(n) }, ancestor.name))] : []));
    },
  };
}
