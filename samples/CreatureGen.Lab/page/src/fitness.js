import { h } from './dom.js';
import { nameOf } from './names.js';
import { texts } from './texts.js';

/** Why this browser cannot show the page; null if it can. `?without=webgl` and `?without=wasm` let it seem so. */
export function unfit() {
  const without = new URLSearchParams(location.search).get('without');
  if (typeof WebAssembly !== 'object' || typeof Worker === 'undefined' || without === 'wasm') {
    return texts.noWasm;
  }
  return without !== 'webgl' && typeof WebGL2RenderingContext === 'function' ? null : texts.noWebGl;
}

/** Pictures in place of the page, and why; where WebGL 2 is there in name only, that comes out when the page begins to draw. */
export async function showStills(problem) {
  document.getElementById('cover')?.remove();
  document.getElementById('stage').remove();
  const gallery = h('ul', { className: 'stills' });
  document.body.classList.add('plain');
  document.body.append(h('main', { className: 'gallery' }, h('h1', {}, texts.title), h('p', { role: 'alert' }, typeof problem === 'string' ? problem : texts.noWebGl), h('p', {}, texts.stills), gallery));
  const list = await (await fetch('./stills/list.json')).json();
  gallery.append(...list.map(({ seed, kind, file }) => h('li', {}, h('img', { src: `./stills/${file}`, alt: `${nameOf(seed, kind)}, ${texts.kinds[kind].toLowerCase()}`, width: 360, height: 300 }), h('b', {}, nameOf(seed, kind)))));
}
