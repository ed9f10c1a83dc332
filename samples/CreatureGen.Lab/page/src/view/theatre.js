import { Body } from '../creature/body.js';
import { Shade } from '../creature/shade.js';
import { squareOf } from '../keeping.js';
import { isNarrow } from './narrow.js';

const farLengths = 5;
const longestStep = 0.1;

// Pictures that take longer than this, in milliseconds, are drawn half the time at most: the library is to live, too.
const slowPicture = 60;
const longestRest = 500;

/** Lets time go on upon the stage and draws it. Everything in `things` has an `update(seconds)`. */
export class Theatre extends EventTarget {
  #before = 0;
  #drawn = null;
  #begun = false;

  constructor(canvas, drawing, world, herd, orbit, lab, courtship, portraits, things) {
    super();
    Object.assign(this, { canvas, drawing, world, herd, orbit, lab, courtship, portraits, things });
    this.still = false;

    /** While something else covers all of it, time stands still here. */
    this.covered = false;

    /** Kept when the first picture has been drawn. */
    this.seen = new Promise(resolve => { this.#drawn = resolve; });
  }

  start() {
    this.size();
    addEventListener('resize', () => this.size());
    requestAnimationFrame(now => this.#draw(now));
  }

  /** Has all that the first picture needs made ready for drawing, while the library grows who is in it. */
  prepare() {
    const body = Body.sample();
    const { mesh } = new Shade();
    this.world.scene.add(body.group, mesh);
    this.drawing.renderer.compile(this.world.scene, this.orbit.camera);
    // What nothing is drawn with any more would be forgotten.
    this.seen.then(() => { body.dispose(); mesh.removeFromParent(); });
    body.group.visible = mesh.visible = false;
  }

  /** Lets time go on. */
  async advance(seconds) {
    const { lab, herd, orbit, world, courtship } = this;
    const done = lab.settled ? herd.step(seconds) : null;
    if (herd.members.get(0) && lab.litter.length === 0 && lab.settled) {
      orbit.goal.copy(courtship.focus());
    }
    herd.glide(seconds);
    for (const thing of this.things) {
      thing.update(seconds, herd.members.get(0));
    }
    this.#coarsen();
    for (const member of herd.members.values()) {
      member.shade.follow(member, world, !world.sun.castShadow);
    }
    world.update(seconds, orbit.focus);
    orbit.update(seconds, world);
    this.dispatchEvent(new Event('advanced'));
    await done;
  }

  render() {
    this.portraits.draw();
    this.drawing.renderer.render(this.world.scene, this.orbit.camera);
  }

  /** One picture with the whole drawing, for tests of the looks: lets time go on in even steps, then draws once. */
  async portrait(steps) {
    for (let i = 0; i < steps; i++) {
      await this.advance(1 / 30);
    }
    this.orbit.jump();
    this.orbit.update(0, this.world);
    this.render();
  }

  /** What is seen, as a square canvas about the creature. */
  snapshot(size) {
    this.render();
    const { width, height } = this.canvas;
    const cover = covered();
    const ratio = width / innerWidth;
    return squareOf(this.canvas, { width: width - cover.right * ratio, height: height - cover.bottom * ratio }, size);
  }

  size() {
    this.drawing.apply(this.world, innerWidth, innerHeight);
    this.orbit.fit(innerWidth, innerHeight, covered());
  }

  #draw(now) {
    const milliseconds = now - this.#before;
    this.#before = now;
    // Nobody rests before the first picture: it is waited for.
    setTimeout(() => requestAnimationFrame(next => this.#draw(next)), this.#begun && milliseconds > slowPicture ? Math.min(milliseconds, longestRest) : 0);
    if (this.still || this.covered || !this.herd.members.get(0)) {
      return;
    }
    this.advance(Math.min(milliseconds / 1000, longestStep));
    // Nothing is drawn before the first creature has its first pose.
    if (!this.#begun && !this.herd.members.get(0).moved) {
      return;
    }
    this.render();
    if (!this.#begun) {
      this.#begun = true;
      this.#drawn();
    }
    if (this.drawing.judge(milliseconds)) {
      this.size();
    }
  }

  /** Those that are far are drawn with fewer triangles. */
  #coarsen() {
    const { position } = this.orbit.camera;
    for (const { slot, body, facts } of this.herd.members.values()) {
      body.far = slot !== 0 && body.group.position.distanceTo(position) > farLengths * Math.max(facts.length, facts.height);
    }
  }
}

/** What the panel covers of the window. */
function covered() {
  const narrow = isNarrow();
  return { right: narrow ? 0 : 360, bottom: narrow ? Math.round(innerHeight * 0.42) : 0 };
}
