import { h, icon } from './dom.js';
import { texts } from './texts.js';

/** What the page tells: a line on what goes on, and complaints that stay until they are closed. */
export class Notices {
  constructor() {
    this.status = h('p', { className: 'status', role: 'status' });
    this.alert = h('div', { className: 'alert', role: 'alert', hidden: true });
  }

  say(text) {
    this.status.textContent = text;
  }

  complain(text) {
    this.alert.replaceChildren(h('p', {}, text), h('button', { type: 'button', className: 'quiet', 'aria-label': texts.close, onclick: () => { this.alert.hidden = true; } }, icon('close')));
    this.alert.hidden = false;
  }

  /** Does a task; what goes wrong in it is complained of, in the words that `wording` makes of the reason. Whether it was done. */
  async guard(task, wording = reason => reason) {
    try {
      await task();
      return true;
    } catch (problem) {
      this.complain(wording(problem.message));
      return false;
    }
  }

  /** Says that the page works while a task is done. */
  async during(task) {
    this.#work(texts.working);
    try {
      return await task();
    } finally {
      this.#work('');
    }
  }

  /** Both. */
  work(task) {
    return this.guard(() => this.during(task));
  }

  #work(text) {
    this.say(text);
    document.body.classList.toggle('working', text !== '');
  }
}
