import { choices, h, icon } from '../dom.js';
import { usualStrangeness } from '../design.js';
import { texts } from '../texts.js';

const alwaysThere = ['eyes', 'coat'];

/** Sliders, parts, and what goes with them. `act` changes the design; the panel only shows it. `take` takes a way of looking at it. */
export function makePanel(sliders, parts, act, take) {
  const locked = new Set();
  const rows = new Map();
  const all = [...sliders, { name: 'strangeness', least: 0, most: 1, own: usualStrangeness }];
  for (const slider of all) {
    const id = `trait-${slider.name}`;
    const label = texts.traits[slider.name];
    const range = h('input', { id, type: 'range', min: slider.least, max: slider.most, step: 'any', value: slider.own, className: slider.name === 'colour' ? 'hues' : '' });
    const told = h('output', { 'for': id });
    const lock = h('button', { type: 'button', className: 'lock', 'aria-label': texts.lock(label), 'aria-pressed': 'false', title: texts.lock(label), onclick: () => {
      const on = !locked.delete(slider.name);
      if (on) {
        locked.add(slider.name);
      }
      lock.setAttribute('aria-pressed', on);
      range.disabled = on;
    } }, icon('lock'));
    range.addEventListener('input', () => {
      show(slider, Number(range.value));
      act.slide(slider.name, Number(range.value));
    });
    range.addEventListener('change', () => act.settle());
    range.addEventListener('dblclick', () => {
      act.slide(slider.name, slider.own);
      act.settle();
    });
    rows.set(slider.name, { slider, range, told, row: h('div', { className: 'slider' }, h('label', { htmlFor: id }, label), range, told, lock) });
  }

  function show(slider, value) {
    const { range, told } = rows.get(slider.name);
    range.value = value;
    const share = (value - slider.least) / (slider.most - slider.least);
    const own = (slider.own - slider.least) / (slider.most - slider.least);
    range.style.setProperty('--from', `${100 * Math.min(share, own)}%`);
    range.style.setProperty('--to', `${100 * Math.max(share, own)}%`);
    told.value = slider.name === 'colour' ? `${Math.round((value * 180) / Math.PI)}°` : slider.name === 'strangeness' ? value.toFixed(2) : `${value.toFixed(2)} ×`;
    range.setAttribute('aria-valuetext', told.value);
  }

  const undo = h('button', { type: 'button', className: 'quiet', onclick: () => act.undo(), 'aria-label': texts.undo, title: texts.undo }, icon('undo'));
  const redo = h('button', { type: 'button', className: 'quiet', onclick: () => act.redo(), 'aria-label': texts.redo, title: texts.redo }, icon('redo'));
  const reasons = h('div', { className: 'reasons', role: 'status' });
  const counts = h('p', { className: 'fine' });
  const tiles = new Map(parts.map(name => {
    const give = h('button', { type: 'button', className: 'part', onclick: () => act.give(name) }, texts.parts[name]);
    const off = h('button', { type: 'button', className: 'take', 'aria-label': texts.takePart(texts.parts[name]), hidden: true, onclick: () => act.take(name) }, '×');
    return [name, { give, off, tile: h('li', {}, give, off) }];
  }));
  const root = h('div', {},
    h('div', { className: 'row' },
      h('button', { type: 'button', className: 'loud', onclick: () => act.random(all.filter(s => !locked.has(s.name))) }, texts.random),
      h('button', { type: 'button', onclick: () => act.nudge(all.filter(s => !locked.has(s.name))) }, texts.nudge),
      undo, redo),
    reasons,
    h('p', { className: 'hint first' }, texts.dragHint),
    h('div', { className: 'sliders' }, ...[...rows.values()].map(row => row.row)),
    h('h3', {}, texts.palette),
    h('ul', { className: 'palette' }, ...[...tiles.values()].map(tile => tile.tile)),
    h('h3', {}, texts.look),
    h('div', { className: 'row looks' }, choices(texts.look, texts.looks, 'skin', take)),
    h('div', { className: 'row' }, h('button', { type: 'button', className: 'quiet', onclick: () => act.reset() }, texts.reset)),
    counts);

  return {
    root,
    /** Shows where the sliders of a design stand, and those that the creature has. */
    refresh(design, facts, history) {
      for (const { slider, row } of rows.values()) {
        const strange = slider.name === 'strangeness';
        row.hidden = strange ? design.text !== null : !!facts && !facts.traits.includes(slider.name);
        show(slider, strange ? design.strangeness : design.traits[slider.name] ?? slider.own);
      }
      undo.disabled = !history.canUndo;
      redo.disabled = !history.canRedo;
      for (const [name, { give, off }] of facts ? tiles : []) {
        const on = facts.parts.includes(name) && !alwaysThere.includes(name);
        give.setAttribute('aria-pressed', on);
        off.hidden = !on;
      }
      counts.textContent = facts ? texts.counts(facts) : '';
    },
    /** Tells why the library changed something. */
    tell(list, title = texts.repaired) {
      reasons.replaceChildren(...(list.length ? [h('strong', {}, title), h('ul', {}, ...list.slice(0, 3).map(reason => h('li', {}, reason)))] : []));
    },
  };
}
