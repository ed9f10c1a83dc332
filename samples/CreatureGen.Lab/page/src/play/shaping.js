import { Vector3 } from 'three';

const perPixel = 0.006;

// What a pull changes on each part of the body: along the part, away from the trunk, and across it.
const traitsOf = {
  trunk: { along: 'size', across: 'girth' },
  neck: { along: 'neck', across: 'neck' },
  head: { along: 'neck', across: 'head' },
  snout: { along: 'snout', across: 'head' },
  eye: { along: 'eyes', across: 'eyes' },
  tail: { along: 'tail', across: 'tail' },
  leg: { along: 'legs', across: 'stoutness' },
  arm: { along: 'arms', across: 'stoutness' },
  wing: { along: 'wings', across: 'wings' },
  ear: { along: 'ornaments', across: 'ornaments' },
};

/** Pulls on the body itself: a part grows the way it is pulled. */
export class Shaping {
  #pull = null;

  /** @param act `value(name)`, `slide(name, value)`, `takeBack(design)`, `settle()` and `label(text, x, y)`; a slider of its name for each trait. */
  constructor(lab, camera, sliders, act) {
    this.sliders = new Map(sliders.map(slider => [slider.name, slider]));
    Object.assign(this, { lab, camera, act });
  }

  /** The traits that a part of the body is pulled for; null where nothing of this creature answers. */
  traits(part) {
    const traits = traitsOf[part];
    const has = name => this.lab.facts?.traits.includes(name);
    return traits && (has(traits.along) || has(traits.across)) ? traits : null;
  }

  grip({ part, place, dx, dy }) {
    const traits = this.traits(part);
    if (!traits) {
      return;
    }
    const way = part === 'trunk' ? { x: 1, y: 0 } : part === 'leg' ? { x: 0, y: 1 } : this.#onScreen(place);
    const along = Math.abs(dx * way.x + dy * way.y) >= Math.abs(dx * way.y - dy * way.x);
    const name = this.lab.facts.traits.includes(along ? traits.along : traits.across) ? (along ? traits.along : traits.across) : traits.along;
    // Across, up is more.
    this.#pull = { name, design: this.lab.design, way: along ? way : part === 'leg' ? { x: 1, y: 0 } : { x: 0, y: -1 }, from: this.act.value(name) };
  }

  pull({ dx, dy, x, y }) {
    if (!this.#pull) {
      return;
    }
    const { name, way, from } = this.#pull;
    const { least, most } = this.sliders.get(name);
    const value = Math.min(most, Math.max(least, from * Math.exp(perPixel * (dx * way.x + dy * way.y))));
    this.act.slide(name, value);
    this.act.label(name, value, x, y);
  }

  release(takenBack) {
    if (this.#pull) {
      const { design } = this.#pull;
      this.#pull = null;
      this.act.label(null);
      if (takenBack) {
        this.act.takeBack(design);
      }
      this.act.settle();
    }
  }

  /** The way from the middle of the body to a point, on the screen. */
  #onScreen(place) {
    const [from, to] = [this.lab.focus().project(this.camera), new Vector3().copy(place).project(this.camera)];
    const [x, y] = [(to.x - from.x) * innerWidth, (from.y - to.y) * innerHeight];
    const length = Math.hypot(x, y) || 1;
    return { x: x / length, y: y / length };
  }
}
