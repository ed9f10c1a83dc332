import { NeutralToneMapping, PCFShadowMap, WebGLRenderer } from 'three';

// Steps down to what a slow machine can draw: sharpness of the picture, share of the plants, shadows.
const steps = [
  { ratio: 2, plants: 1, shadows: true },
  { ratio: 1.25, plants: 1, shadows: true },
  { ratio: 1, plants: 0.55, shadows: true },
  { ratio: 0.7, plants: 0.3, shadows: true },
  { ratio: 0.45, plants: 0.12, shadows: false },
];
const slowMilliseconds = 40;
const framesToJudge = 12;

/** What draws on a canvas, and whether a graphics card does: without one, edges are left as they are unless the `best` is asked for. */
export function openRenderer(canvas, look = {}, best = false) {
  const wishes = { antialias: true, powerPreference: 'high-performance', ...look };
  const context = canvas.getContext('webgl2', { ...wishes, failIfMajorPerformanceCaveat: true });
  const renderer = new WebGLRenderer({ canvas, ...wishes, ...(context ? { context } : { antialias: best }) });
  renderer.toneMapping = NeutralToneMapping;
  return { renderer, quick: context !== null };
}

/** Draws, and draws less when the machine is slow. */
export class Drawing {
  #times = [];
  #step;

  constructor(canvas, wanted) {
    const { renderer, quick } = openRenderer(canvas, {}, wanted === 'best');
    this.renderer = renderer;
    this.renderer.toneMappingExposure = 1.02;
    this.renderer.shadowMap.type = PCFShadowMap;
    this.fixed = wanted !== null;
    // Where there is no graphics card the first picture would take seconds.
    this.#step = wanted === 'best' ? 1 : wanted === 'least' || !quick ? steps.length - 1 : 0;
  }

  apply(world, width, height) {
    const { ratio, plants, shadows } = steps[this.#step];
    this.renderer.setPixelRatio(Math.min(devicePixelRatio, ratio));
    this.renderer.setSize(width, height, false);
    this.renderer.shadowMap.enabled = shadows;
    world.sun.castShadow = shadows;
    world.thin(plants);
  }

  /** Judges the time between frames; true if something was given up for speed. */
  judge(milliseconds) {
    if (this.fixed || document.hidden) {
      return false;
    }
    this.#times.push(milliseconds);
    if (this.#times.length < framesToJudge) {
      return false;
    }
    const median = this.#times.sort((a, b) => a - b)[framesToJudge >> 1];
    this.#times = [];
    if (median > slowMilliseconds && this.#step < steps.length - 1) {
      this.#step++;
      return true;
    }
    return false;
  }
}
