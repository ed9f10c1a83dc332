import { h } from '../dom.js';
import { face } from './face.js';
import { texts } from '../texts.js';

/** Names, files, addresses and the collection. */
export function keepPanel(act) {
  const name = h('input', { id: 'name', type: 'text', maxLength: 40, autocomplete: 'off', onchange: () => act.rename(name.value.trim()) });
  const file = h('input', { type: 'file', accept: '.png,.glb,.json', hidden: true, tabIndex: -1, 'aria-hidden': 'true', onchange: () => { if (file.files[0]) { act.open(file.files[0]); } file.value = ''; } });
  const several = h('input', { type: 'file', accept: '.json', hidden: true, tabIndex: -1, 'aria-hidden': 'true', onchange: () => { if (several.files[0]) { act.importAll(several.files[0]); } several.value = ''; } });
  const collection = h('ul', { className: 'people kept' });
  const root = h('div', {},
    h('label', { className: 'field', htmlFor: 'name' }, texts.name), name,
    h('div', { className: 'row full' }, h('button', { type: 'button', className: 'loud', onclick: () => act.save() }, texts.save), h('button', { type: 'button', onclick: () => act.share() }, texts.share)),
    h('h3', {}, texts.download),
    h('div', { className: 'row full' },
      h('button', { type: 'button', onclick: () => act.picture() }, texts.photo),
      h('button', { type: 'button', onclick: () => act.loop() }, texts.loop),
      h('button', { type: 'button', onclick: () => act.json() }, texts.json),
      h('button', { type: 'button', onclick: () => act.glb('plain') }, texts.glb),
      h('button', { type: 'button', onclick: () => act.glb('whole') }, texts.whole)),
    h('p', { className: 'hint' }, texts.pictureHint),
    h('div', { className: 'row' }, h('button', { type: 'button', className: 'quiet', onclick: () => file.click() }, texts.open), file),
    h('h3', {}, texts.collection),
    collection,
    h('div', { className: 'row' }, h('button', { type: 'button', className: 'quiet', onclick: () => act.exportAll() }, texts.exportAll), h('button', { type: 'button', className: 'quiet', onclick: () => several.click() }, texts.importAll), several));
  return {
    root,
    named(value) {
      name.value = value;
    },
    collection(entries) {
      collection.replaceChildren(...(entries.length ? entries.map((entry, n) => h('li', {},
        h('button', { type: 'button', className: 'person', onclick: () => act.visit(n) }, face(entry), h('b', {}, entry.name)),
        h('button', { type: 'button', className: 'quiet', 'aria-label': texts.remove(entry.name), onclick: () => act.remove(n) }, '×'))) : [h('li', { className: 'hint' }, texts.empty)]));
    },
  };
}
