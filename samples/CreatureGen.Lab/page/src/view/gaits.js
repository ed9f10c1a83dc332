import { h } from '../dom.js';
import { texts } from '../texts.js';

const seconds = 3;
const row = 13;

/** The gait diagram: a row for each foot, filled while it stands. */
export class Gaits {
  #past = [];
  #time = 0;

  constructor() {
    this.canvas = h('canvas', { className: 'gaits', role: 'img', 'aria-label': texts.gaits, hidden: true });
    document.body.append(this.canvas);
  }

  set shown(on) {
    this.canvas.hidden = !on;
    this.#past = [];
  }

  update(dt, member) {
    if (this.canvas.hidden || !member) {
      return;
    }
    this.#time += dt;
    this.#past.push({ at: this.#time, stands: member.feet.map(foot => foot[3] > 0) });
    while (this.#past[0].at < this.#time - seconds) {
      this.#past.shift();
    }
    this.#draw(member.feet.length);
  }

  #draw(feet) {
    const { canvas } = this;
    const ratio = Math.min(devicePixelRatio, 2);
    const [width, height] = [250, Math.max(1, feet) * row + 10];
    canvas.style.width = `${width}px`;
    canvas.style.height = `${height}px`;
    canvas.width = width * ratio;
    canvas.height = height * ratio;
    const pen = canvas.getContext('2d');
    pen.scale(ratio, ratio);
    const x = at => 8 + ((width - 16) * (at - this.#time + seconds)) / seconds;
    for (let foot = 0; foot < feet; foot++) {
      const y = 5 + foot * row;
      pen.fillStyle = 'rgb(34 51 43 / 12%)';
      pen.fillRect(8, y + 2, width - 16, row - 4);
      pen.fillStyle = foot % 2 ? '#2f6b4a' : '#c8431d';
      for (let n = 1; n < this.#past.length; n++) {
        if (this.#past[n].stands[foot]) {
          pen.fillRect(x(this.#past[n - 1].at), y + 2, x(this.#past[n].at) - x(this.#past[n - 1].at) + 0.6, row - 4);
        }
      }
    }
  }
}
