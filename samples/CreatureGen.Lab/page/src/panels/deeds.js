import { h, icon } from '../dom.js';
import { texts } from '../texts.js';

/** The bar on the stage: what one does with the creature, always at hand. */
export function deedsBar(act) {
  const button = (name, drawing) => h('button', { type: 'button', 'aria-label': texts.deeds[name], title: texts.deeds[name], 'data-deed': name, onclick: act[name] }, icon(drawing));
  const sound = h('button', { type: 'button', 'aria-label': texts.sound, title: texts.sound, 'aria-pressed': 'false', onclick: () => {
    const on = sound.getAttribute('aria-pressed') !== 'true';
    sound.setAttribute('aria-pressed', on);
    act.sound(on);
  } }, icon('loud'));
  return h('div', { className: 'deeds', role: 'toolbar', 'aria-label': texts.play },
    button('pet', 'heart'), button('feed', 'apple'), button('push', 'push'), button('dance', 'note'), button('jump', 'jump'), button('call', 'call'), button('faint', 'faint'), sound);
}
