import { choices, h, icon } from '../dom.js';
import { texts } from '../texts.js';

/** The bar at the top: whom to meet. `act` hatches a seed, or opens the grid. */
export function headerBar(act) {
  const seed = h('input', { type: 'text', inputMode: 'numeric', id: 'seed', maxLength: 20, autocomplete: 'off', spellcheck: false });
  const hatch = () => act.hatch(seed.value.trim(), kind.querySelector('[aria-checked=true]').dataset.value);
  const kind = choices(texts.kind, texts.kinds, 'walking', hatch);
  const take = number => {
    seed.value = String(number);
    return hatch();
  };
  const today = () => {
    const now = new Date();
    return take(now.getUTCFullYear() * 10000 + (now.getUTCMonth() + 1) * 100 + now.getUTCDate());
  };
  const button = (drawing, text, onclick, name = '') => h('button', { type: 'button', className: `quiet ${name}`.trim(), 'aria-label': text, title: text, onclick }, icon(drawing));
  const root = h('header', {}, h('div', { className: 'brand' }, icon('egg'), texts.title),
    h('form', { className: 'search', onsubmit: event => { event.preventDefault(); hatch(); } },
      h('label', { htmlFor: 'seed' }, texts.seed), seed,
      h('button', { type: 'submit', className: 'loud' }, texts.hatch),
      button('dice', texts.dice, () => take(Math.floor(Math.random() * 1e6)))),
    kind, button('sun', texts.today, today, 'today'), button('grid', texts.grid, act.grid));
  return {
    root,
    /** Shows whose seed it is. */
    refresh(design, facts) {
      seed.value = design.seed;
      kind.take(facts.kind);
    },
  };
}
