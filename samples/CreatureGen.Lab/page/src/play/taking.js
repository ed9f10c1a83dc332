import { largestFile } from '../keeping.js';
import { download } from '../storage.js';
import { texts } from '../texts.js';

// Where the second worker makes what goes into a file.
const fileSlot = 40;

/** What is taken home or brought along: files, the address, the collection. */
export class Taking extends EventTarget {
  /** @param studio gives the second worker. */
  constructor(lab, visits, notices, keeping, studio) {
    super();
    Object.assign(this, { lab, visits, notices, keeping, studio });
  }

  rename(name) {
    this.lab.rename(name || undefined);
    this.dispatchEvent(new Event('renamed'));
  }

  save() {
    this.keeping.save();
    this.#collected();
    this.notices.say(texts.saved(this.keeping.name));
  }

  async share() {
    if (!this.visits.told) {
      this.notices.say(texts.takeFile);
      return;
    }
    try {
      await navigator.clipboard.writeText(location.href);
      this.notices.say(texts.shared);
    } catch {
      this.notices.say(texts.addressIs);
    }
  }

  picture() {
    return this.#file('.png', () => this.keeping.picture(), 'image/png');
  }

  loop() {
    return this.#file('-loop.png', () => this.keeping.loop(), 'image/png');
  }

  glb(what) {
    // Textures and clips take seconds: the second worker makes them, so that nobody on the stage waits.
    return this.#file('.glb', async () => {
      const studio = await this.studio();
      await studio.call('GrowText', fileSlot, await this.lab.text(), '');
      return studio.call('Glb', fileSlot, what);
    }, 'model/gltf-binary');
  }

  json() {
    return this.#file('.json', () => this.lab.text(), 'application/json');
  }

  /** Meets the creature of a file that somebody brought. */
  async open(file) {
    if (file.size > largestFile) {
      this.notices.complain(texts.tooLarge(file.name, file.size));
      return;
    }
    await this.notices.guard(async () => this.visits.open(new Uint8Array(await file.arrayBuffer())), reason => texts.badFile(file.name, reason));
  }

  visit(n) {
    return this.visits.visit(this.keeping.collection[n].design);
  }

  remove(n) {
    this.keeping.remove(n);
    this.#collected();
  }

  /** Adds the creatures of an exported collection. */
  importAll(file) {
    return this.notices.guard(async () => {
      const count = await this.keeping.take(file);
      this.#collected();
      this.notices.say(texts.imported(count));
    }, reason => texts.badFile(file.name, reason));
  }

  exportAll() {
    this.keeping.exportAll();
  }

  #file(ending, make, type) {
    return this.notices.work(async () => download(this.keeping.name + ending, await make(), type));
  }

  #collected() {
    this.dispatchEvent(new Event('collected'));
  }
}
