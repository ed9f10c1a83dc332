import { cloudy, smoothstep } from './noise.js';

// The land, in units of about one creature's height: a calm meadow in the middle, a lake behind it, hills round them, mountains beyond.

export const halfWidth = 36;
export const columns = 129;
export const lake = { x: -11, z: -17, radius: 9.5, level: -0.62 };

/** Height of the land of a habitat at a place. */
export function heightAt(x, z, wet) {
  const r = Math.hypot(x, z);
  const calm = 0.5 * (cloudy(x * 0.11 + 40, z * 0.11 + 7, 2) - 0.5);
  const far = smoothstep(15, 80, r);
  const farther = smoothstep(85, 190, r);
  const hills = far > 0 ? far * (10.5 * cloudy(x * 0.028 + 3, z * 0.028 + 11, 4) - 3.6) : 0;
  const mountains = farther > 0 ? farther * 40 * Math.pow(cloudy(x * 0.013 + 61, z * 0.013 + 5, 5), 1.7) : 0;
  let height = calm * (0.35 + smoothstep(4, 16, r)) + hills + mountains;
  if (!wet) {
    const wave = 1 + 0.35 * (cloudy(x * 0.13, z * 0.13 + 30, 2) - 0.5);
    const shore = Math.hypot((x - lake.x) / 1.5, z - lake.z) / (lake.radius * wave);
    const basin = 1 - smoothstep(0.55, 1.35, shore);
    height = height * (1 - basin) + (lake.level - 0.9) * basin;
  }
  return height;
}

/** Heights on the square on which creatures live, for the library. */
export function heightField(wet, scale) {
  const heights = new Float32Array(columns * columns);
  const cell = (2 * halfWidth) / (columns - 1);
  for (let row = 0, at = 0; row < columns; row++) {
    for (let column = 0; column < columns; column++, at++) {
      heights[at] = scale * heightAt(column * cell - halfWidth, row * cell - halfWidth, wet);
    }
  }
  return { heights, columns, cell: cell * scale, corner: -halfWidth * scale };
}
