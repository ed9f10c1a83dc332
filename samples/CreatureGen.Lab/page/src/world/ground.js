import { BufferAttribute, BufferGeometry, Color, Mesh, MeshLambertMaterial } from 'three';
import { cloudy, smoothstep } from './noise.js';
import { columns, halfWidth, heightAt, lake } from './terrain.js';

const white = new Color('#ffffff');
const parsed = new WeakMap();

/** The colours of a palette's ground as numbers: they are asked for at every vertex and tuft. */
function coloursOf(palette) {
  let colours = parsed.get(palette);
  if (!colours) {
    const { grass, dry, shore, rock } = palette;
    colours = { grass: grass.map(one => new Color(one)), dry: new Color(dry), shore: new Color(shore), rock: new Color(rock) };
    parsed.set(palette, colours);
  }
  return colours;
}

/** The colour of the ground at a place, into `colour`. */
export function groundColour(palette, x, z, colour) {
  const { grass, dry, shore, rock } = coloursOf(palette);
  const broad = cloudy(x * 0.09 + 5, z * 0.09 + 80, 3);
  const fine = cloudy(x * 0.5, z * 0.5 + 33, 3);
  colour.copy(grass[0]).lerp(grass[1], smoothstep(0.35, 0.7, broad)).lerp(grass[2], 0.55 * smoothstep(0.45, 0.75, fine));
  colour.lerp(dry, 0.5 * smoothstep(0.6, 0.85, cloudy(x * 0.05 + 90, z * 0.05, 3)));
  if (!palette.wet) {
    const height = heightAt(x, z, false);
    const r = Math.hypot(x, z);
    if (Math.hypot(x - lake.x, z - lake.z) < 2.4 * lake.radius) {
      colour.lerp(shore, 0.9 * (1 - smoothstep(lake.level + 0.02, lake.level + 0.26, height)));
    }
    colour.lerp(rock, 0.85 * smoothstep(12, 26, height) * smoothstep(80, 130, r));
    colour.lerp(white, smoothstep(22, 34, height) * smoothstep(100, 150, r));
  }
  return colour;
}

/** The land: a square grid where creatures live, rings of ever wider cells to the mountains. */
export function makeGround(palette) {
  const material = new MeshLambertMaterial({ vertexColors: true });
  const inner = new Mesh(square(palette), material);
  inner.receiveShadow = true;
  const outer = new Mesh(rings(palette), material);
  return [inner, outer];
}

function square(palette) {
  const cell = (2 * halfWidth) / (columns - 1);
  return surface(palette, columns, columns, (i, k) => [i * cell - halfWidth, k * cell - halfWidth]);
}

function rings(palette) {
  const across = 160;
  const along = 46;
  return surface(palette, across + 1, along, (i, k) => {
    const angle = (2 * Math.PI * i) / across;
    // From inside the square, whose corners reach farther, to the mountains.
    const r = 35 * Math.pow(230 / 35, k / (along - 1));
    const x = r * Math.sin(angle);
    const z = r * Math.cos(angle);
    const sink = Math.max(Math.abs(x), Math.abs(z)) < halfWidth ? 0.35 : 0;
    return [x, z, sink];
  });
}

function surface(palette, width, height, place) {
  const positions = new Float32Array(3 * width * height);
  const colours = new Float32Array(3 * width * height);
  const indices = [];
  const colour = new Color();
  for (let k = 0, at = 0; k < height; k++) {
    for (let i = 0; i < width; i++, at++) {
      const [x, z, sink = 0] = place(i, k);
      positions.set([x, heightAt(x, z, palette.wet) - sink, z], 3 * at);
      groundColour(palette, x, z, colour).toArray(colours, 3 * at);
      if (i > 0 && k > 0) {
        const a = at - width - 1;
        indices.push(a, at - 1, a + 1, a + 1, at - 1, at);
      }
    }
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(positions, 3));
  geometry.setAttribute('color', new BufferAttribute(colours, 3));
  geometry.setIndex(indices);
  geometry.computeVertexNormals();
  return geometry;
}
