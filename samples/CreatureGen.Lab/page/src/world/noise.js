// Smooth noise of places, the same on every machine: for hills, tufts and colours of the meadow. Creatures know nothing of it.

function lattice(x, z) {
  let h = Math.imul(x, 374761393) + Math.imul(z, 668265263);
  h = Math.imul(h ^ (h >>> 13), 1274126177);
  return ((h ^ (h >>> 16)) >>> 0) / 4294967295;
}

const ease = t => t * t * t * (t * (t * 6 - 15) + 10);

/** Between 0 and 1, changing over about one unit. */
export function noise(x, z) {
  const i = Math.floor(x);
  const k = Math.floor(z);
  const u = ease(x - i);
  const v = ease(z - k);
  const near = lattice(i, k) * (1 - u) + lattice(i + 1, k) * u;
  const far = lattice(i, k + 1) * (1 - u) + lattice(i + 1, k + 1) * u;
  return near * (1 - v) + far * v;
}

/** Several octaves of noise, between 0 and 1. */
export function cloudy(x, z, octaves = 4) {
  let sum = 0;
  let weight = 0.5;
  let whole = 0;
  for (let o = 0; o < octaves; o++) {
    sum += weight * noise(x + 17.3 * o, z - 9.1 * o);
    whole += weight;
    weight *= 0.5;
    x *= 2.03;
    z *= 2.03;
  }
  return sum / whole;
}

export const smoothstep = (from, to, x) => {
  const t = Math.min(1, Math.max(0, (x - from) / (to - from)));
  return t * t * (3 - 2 * t);
};

/** A row of numbers in 0..1 that always begins the same way. */
export function sequence(seed) {
  let state = seed >>> 0;
  return () => {
    state = (state + 0x6d2b79f5) >>> 0;
    let t = Math.imul(state ^ (state >>> 15), 1 | state);
    t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
    return ((t ^ (t >>> 14)) >>> 0) / 4294967296;
  };
}
