import { texts } from './texts.js';

/** Why this browser cannot show the page; null if it can. */
export function unfit() {
  if (typeof WebAssembly !== 'object' || typeof Worker === 'undefined') {
    return texts.noWasm;
  }
  return document.createElement('canvas').getContext('webgl2') ? null : texts.noWebGl;
}
