import { h } from './dom.js';

/** What is seen before anything can be drawn: a picture of the first creature; an egg where another one was asked for. The picture stays still: where the browser puts pictures together in software, one that moves kept the stage waiting for half a minute. */
export async function showStill() {
  const cover = document.getElementById('cover');
  if (location.hash.length > 1) {
    cover.append(h('div', { className: 'egg', 'aria-hidden': 'true' }));
    return;
  }
  const picture = h('img', { src: './first.png', alt: '', width: 640, height: 560 });
  cover.append(picture);
  await picture.decode().catch(() => {});
  requestAnimationFrame(() => performance.mark('creature:still'));
}
