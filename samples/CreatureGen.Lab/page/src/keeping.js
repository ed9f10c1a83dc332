import { h } from './dom.js';
import { nameOfDesign } from './lab.js';
import { download, parseCollection, readCollection, writeCollection } from './storage.js';
import { texts } from './texts.js';

export const largestFile = 32e6;
const pictureSize = 1000;
const thumbSize = 120;

/** What is kept of creatures: the collection, and files to take home. */
export class Keeping {
  /** @param snapshot gives a canvas of a size with the creature on it. */
  constructor(lab, studio, snapshot) {
    Object.assign(this, { lab, studio, snapshot });
    this.collection = readCollection();
  }

  get name() {
    return nameOfDesign(this.lab.design);
  }

  /** Its portrait; where there is none yet, what is seen. */
  thumb() {
    return this.lab.herd.members.get(0).thumb ?? this.snapshot(thumbSize).toDataURL('image/jpeg', 0.8);
  }

  save() {
    const { seed, kind, strangeness, individual, traits, text } = this.lab.design;
    this.collection.unshift({ name: this.name, thumb: this.thumb(), design: { seed: String(seed), kind, strangeness, individual, traits, text, name: this.name } });
    this.store();
  }

  remove(n) {
    this.collection.splice(n, 1);
    this.store();
  }

  store() {
    writeCollection(this.collection);
  }

  /** Adds the creatures of an exported collection: how many. */
  async take(file) {
    if (file.size > largestFile) {
      throw new Error(texts.tooLarge(file.name, file.size));
    }
    const entries = parseCollection(await file.text());
    this.collection.unshift(...entries);
    this.store();
    return entries.length;
  }

  exportAll() {
    download('creatures.json', JSON.stringify(this.collection, null, 1), 'application/json');
  }

  /** What is seen, cut to a square about the creature, with its blueprint in it. */
  async picture() {
    const blob = await new Promise(resolve => this.snapshot(pictureSize).toBlob(resolve, 'image/png'));
    return this.lab.library.call('Sign', new Uint8Array(await blob.arrayBuffer()), 0);
  }

  /** Its gait as a picture that moves, with its blueprint in it. */
  async loop() {
    const { loopPicture } = await import('./view/loop.js');
    return this.lab.library.call('Sign', await loopPicture(await this.studio(), await this.lab.text()), 0);
  }
}

/** A square of a canvas about the middle of what no panel covers. */
export function squareOf(canvas, free, size) {
  const side = Math.min(free.width, free.height);
  const square = h('canvas', { width: size, height: size });
  square.getContext('2d').drawImage(canvas, (free.width - side) / 2, (free.height - side) / 2, side, side, 0, 0, size, size);
  return square;
}
