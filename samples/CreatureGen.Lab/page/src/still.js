import { h } from './dom.js';
import { wantsStillness } from './view/stillness.js';

/** What is seen before anything can be drawn: a picture of the first creature as it breathes; an egg where another one was asked for. The browser moves the picture by itself, while the page is busy. */
export async function showStill() {
  const cover = document.getElementById('cover');
  if (location.hash.length > 1) {
    cover.append(h('div', { className: 'egg', 'aria-hidden': 'true' }));
    return;
  }
  const picture = h('img', { src: wantsStillness() ? './first.png' : './first-moving.png', alt: '', width: 360, height: 315 });
  cover.append(picture);
  await picture.decode().catch(() => {});
  requestAnimationFrame(() => performance.mark('creature:baked'));
}
