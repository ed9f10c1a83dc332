// The library, in a worker: every call is a promise. `new Library()` starts at once; calls wait until it runs.
const longestStart = 60_000;

export class Library {
  #calls = new Map();
  #ahead = new Map();
  #next = 1;
  #worker;

  constructor() {
    const runtime = new URL('./runtime/', document.baseURI).href;
    this.#worker = new Worker(new URL('./worker.js', import.meta.url), { type: 'module', name: runtime });
    this.ready = new Promise((resolve, reject) => {
      this.#calls.set(0, { resolve, reject });
      this.#worker.onerror = event => reject(new Error(event.message || 'the worker could not be started'));
      setTimeout(() => reject(new Error('the library did not start')), longestStart);
    });
    this.#worker.onmessage = ({ data: { id, value, problem } }) => {
      const call = this.#calls.get(id);
      this.#calls.delete(id);
      if (problem === undefined) {
        call?.resolve(value);
      } else {
        call?.reject(new Error(problem));
      }
    };
  }

  /** Calls a method of the library by its name. */
  call(name, ...values) {
    const key = JSON.stringify([name, values]);
    const answer = this.#ahead.get(key) ?? this.#send(name, values, []);
    this.#ahead.delete(key);
    return answer;
  }

  /** Calls a method before somebody needs its answer: the next call of the same gets it. */
  ahead(name, ...values) {
    const answer = this.#send(name, values, []);
    answer.catch(() => {});
    this.#ahead.set(JSON.stringify([name, values]), answer);
  }

  /** Moves all creatures on; `buffer` comes back filled. */
  frame(seconds, eye, buffer) {
    return this.#send('frame', { seconds, eye, buffer }, [buffer]);
  }

  /** Bytes of the memory in which the library runs; it only ever grows. */
  heapSize() {
    return this.#send('heapSize', [], []);
  }

  #send(name, values, moved) {
    const id = this.#next++;
    return new Promise((resolve, reject) => {
      this.#calls.set(id, { resolve, reject });
      this.#worker.postMessage({ id, name, values }, moved);
    });
  }
}
