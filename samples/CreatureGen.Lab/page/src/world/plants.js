import { BufferAttribute, BufferGeometry, Color, DoubleSide, IcosahedronGeometry, InstancedMesh, Matrix4, MeshLambertMaterial, Quaternion, Vector3 } from 'three';
import { mergeGeometries } from 'three/addons/utils/BufferGeometryUtils.js';
import { cloudy, sequence, smoothstep } from './noise.js';
import { halfWidth, heightAt, lake } from './terrain.js';
import { groundColour } from './ground.js';

const up = new Vector3(0, 1, 0);

/** What bends in the wind, by its own colours; lit like the ground it grows on. */
function swaying(clock, strength) {
  const material = new MeshLambertMaterial({ vertexColors: true, side: DoubleSide });
  material.onBeforeCompile = shader => {
    shader.uniforms.clock = clock;
    shader.vertexShader = shader.vertexShader
      .replace('#include <common>', '#include <common>\nuniform float clock;')
      .replace('#include <beginnormal_vertex>', 'vec3 objectNormal = vec3(0.0, 1.0, 0.0);')
      .replace(
        '#include <begin_vertex>',
        `vec3 transformed = position;
        vec3 root = vec3(instanceMatrix[3]);
        float gust = sin(clock * 1.7 + root.x * 0.9 + root.z * 0.6) + 0.5 * sin(clock * 3.1 + root.x * 2.3 - root.z * 1.7);
        transformed.x += gust * ${strength.toFixed(3)} * position.y * position.y;
        transformed.z += gust * ${(0.6 * strength).toFixed(3)} * position.y * position.y;`,
      );
    // Both sides of a blade are lit from above.
    shader.fragmentShader = shader.fragmentShader.replace('#include <normal_fragment_begin>', 'vec3 normal = normalize(vNormal);\nvec3 nonPerturbedNormal = normal;');
  };
  return material;
}

/** One tuft, one unit high: blades that bend outwards, dark at the root. */
function tuft(blade, random) {
  const positions = [];
  const colours = [];
  const indices = [];
  const root = new Color(blade.root);
  const tip = new Color(blade.tip);
  const colour = new Color();
  const steps = 3;
  for (let n = 0; n < 7; n++) {
    const angle = 2 * Math.PI * random();
    const out = 0.04 + 0.3 * random();
    const height = 0.55 + 0.45 * random();
    const bend = blade.bend * (0.4 + random());
    const width = blade.width / blade.height;
    const [s, c] = [Math.sin(angle), Math.cos(angle)];
    const turn = angle + 1.2 + 0.7 * random();
    const [ws, wc] = [Math.sin(turn), Math.cos(turn)];
    const first = positions.length / 3;
    for (let k = 0; k <= steps; k++) {
      const t = k / steps;
      const away = out + bend * height * t * t * 0.7;
      const half = width * (1 - t) * (1 - 0.3 * t);
      const y = height * t * (1 - 0.18 * bend * t);
      colour.copy(root).lerp(tip, Math.pow(t, 1.2));
      for (const side of k === steps ? [0] : [-1, 1]) {
        positions.push(s * away + side * half * ws, y, c * away + side * half * wc);
        colours.push(colour.r, colour.g, colour.b);
      }
      if (k < steps - 1) {
        const a = first + 2 * k;
        indices.push(a, a + 1, a + 2, a + 1, a + 3, a + 2);
      } else if (k === steps - 1) {
        const a = first + 2 * k;
        indices.push(a, a + 1, a + 2);
      }
    }
  }
  return plain(positions, colours, indices);
}

/** A flower, one unit high: stalk, petals and heart. White petals take the colour of the instance. */
function flower() {
  const positions = [];
  const colours = [];
  const indices = [];
  const add = (points, colour) => {
    const first = positions.length / 3;
    for (const point of points) {
      positions.push(...point);
      colours.push(colour.r, colour.g, colour.b);
    }
    for (let i = 2; i < points.length; i++) {
      indices.push(first, first + i - 1, first + i);
    }
  };
  const green = new Color('#5b8a33');
  add([[-0.02, 0, 0], [0.02, 0, 0], [0.03, 0.9, 0]], green);
  for (let p = 0; p < 6; p++) {
    const a = (2 * Math.PI * p) / 6;
    const at = (r, da, y) => [r * Math.sin(a + da), y, r * Math.cos(a + da)];
    add([at(0.03, 0, 0.9), at(0.19, -0.36, 0.95), at(0.26, 0, 0.98), at(0.19, 0.36, 0.95)], new Color(1, 1, 1));
  }
  const heart = [];
  for (let p = 0; p < 7; p++) {
    heart.push([0.075 * Math.sin((2 * Math.PI * p) / 7), 0.965, 0.075 * Math.cos((2 * Math.PI * p) / 7)]);
  }
  add(heart, new Color('#f0b429'));
  return plain(positions, colours, indices);
}

function plain(positions, colours, indices) {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(new Float32Array(positions), 3));
  geometry.setAttribute('color', new BufferAttribute(new Float32Array(colours), 3));
  geometry.setAttribute('normal', new BufferAttribute(new Float32Array(positions.length).map((_, i) => (i % 3 === 1 ? 1 : 0)), 3));
  geometry.setIndex(indices);
  return geometry;
}

/** A tree of round puffs, or a coral of them; about one unit high. */
function tree(palette, random) {
  const parts = [];
  const trunk = new IcosahedronGeometry(0.09, 1).scale(0.8, 4.2, 0.8).translate(0, 0.3, 0);
  // Corals take one colour from foot to top.
  parts.push(tint(trunk, y => (palette.wet ? new Color(1, 1, 1).multiplyScalar(0.45 + 0.3 * y) : new Color(palette.trunk))));
  const puffs = palette.wet ? 7 : 6;
  for (let n = 0; n < puffs; n++) {
    const a = (2 * Math.PI * n) / puffs + random();
    const r = n === 0 ? 0 : 0.2 + 0.1 * random();
    const size = (n === 0 ? 0.36 : 0.2 + 0.12 * random()) * (palette.wet ? 0.6 : 1);
    const y = n === 0 ? 0.8 : 0.58 + 0.3 * random();
    const puff = new IcosahedronGeometry(size, 2);
    const p = puff.attributes.position;
    for (let i = 0; i < p.count; i++) {
      const push = 1 + 0.28 * (cloudy(p.getX(i) * 7 + n * 5 + 50, p.getY(i) * 7 + p.getZ(i) * 5 + 50, 2) - 0.5);
      p.setXYZ(i, p.getX(i) * push, p.getY(i) * push * 0.86, p.getZ(i) * push);
    }
    puff.computeVertexNormals();
    parts.push(tint(puff.translate(r * Math.sin(a), y, r * Math.cos(a)), y => new Color(1, 1, 1).multiplyScalar(0.62 + 0.5 * smoothstep(0.35, 1.15, y))));
  }
  return mergeGeometries(parts);
}

function tint(geometry, colourAt) {
  const p = geometry.attributes.position;
  const colours = new Float32Array(3 * p.count);
  for (let i = 0; i < p.count; i++) {
    colourAt(p.getY(i)).toArray(colours, 3 * i);
  }
  geometry.setAttribute('color', new BufferAttribute(colours, 3));
  geometry.deleteAttribute('uv');
  return geometry;
}

const isDry = (palette, x, z) => palette.wet || heightAt(x, z, false) > lake.level + 0.16;

function scatter(mesh, count, place) {
  const matrix = new Matrix4();
  const turn = new Quaternion();
  const position = new Vector3();
  const size = new Vector3();
  let at = 0;
  for (let tries = 0; at < count && tries < 6 * count; tries++) {
    const found = place();
    if (found) {
      position.set(found.x, found.y, found.z);
      turn.setFromAxisAngle(up, found.turn);
      size.set(found.width, found.height, found.width);
      mesh.setMatrixAt(at, matrix.compose(position, turn, size));
      if (found.colour) {
        mesh.setColorAt(at, found.colour);
      }
      at++;
    }
  }
  mesh.count = at;
  mesh.userData.whole = at;
  mesh.frustumCulled = false;
  return mesh;
}

/** All that grows on the land of a habitat. */
export function makePlants(palette, clock) {
  const random = sequence(palette.wet ? 11 : 7);
  const blade = palette.blade;
  const colour = new Color();
  const white = new Color(1, 1, 1);
  const wind = swaying(clock, palette.wet ? 0.22 : 0.11);

  const grass = scatter(new InstancedMesh(tuft(blade, random), wind, 15000), palette.wet ? 1500 : 15000, () => {
    const near = random() < 0.72;
    const r = near ? 14 * Math.sqrt(random()) : 14 + 21 * random();
    const angle = 2 * Math.PI * random();
    const x = r * Math.sin(angle);
    const z = r * Math.cos(angle);
    const thick = cloudy(x * 0.35 + 20, z * 0.35 + 4, 3);
    if (!isDry(palette, x, z) || random() > smoothstep(palette.wet ? 0.5 : 0.28, 0.62, thick) + (palette.wet ? 0 : 0.12)) {
      return null;
    }
    const height = blade.height * (0.55 + 0.9 * thick * random() + (near ? 0 : 0.25));
    const tone = groundColour(palette, x, z, colour).clone().lerp(white, 0.55).multiplyScalar(palette.wet ? 1 : 1.18);
    return { x, y: heightAt(x, z, palette.wet) - 0.01, z, turn: 6.3 * random(), height, width: height * (0.9 + 0.5 * random()), colour: tone };
  });
  grass.receiveShadow = true;

  const flowers = scatter(new InstancedMesh(flower(), swaying(clock, 0.08), 420), palette.wet ? 0 : 420, () => {
    const r = 2 + 24 * random() * random();
    const angle = 2 * Math.PI * random();
    const x = r * Math.sin(angle);
    const z = r * Math.cos(angle);
    const patch = cloudy(x * 0.22 + 70, z * 0.22 + 60, 2);
    if (!isDry(palette, x, z) || patch < 0.5) {
      return null;
    }
    const height = 0.15 + 0.1 * random();
    const kind = Math.floor(cloudy(x * 0.15, z * 0.15 + 120, 1) * 5 + random()) % palette.flowers.length;
    return { x, y: heightAt(x, z, palette.wet), z, turn: 6.3 * random(), height, width: height * 0.9, colour: new Color(palette.flowers[kind]) };
  });
  flowers.receiveShadow = true;

  const trees = scatter(new InstancedMesh(tree(palette, random), new MeshLambertMaterial({ vertexColors: true }), 420), palette.wet ? 160 : 420, () => {
    const r = palette.wet ? 5 + 26 * random() : 17 + 75 * Math.pow(random(), 0.8);
    const angle = 2 * Math.PI * random();
    const x = r * Math.sin(angle);
    const z = r * Math.cos(angle);
    if (!isDry(palette, x, z) || cloudy(x * 0.06 + 15, z * 0.06 + 44, 3) < (palette.wet ? 0.42 : 0.52) || (!palette.wet && Math.hypot(x - lake.x, z - lake.z) < lake.radius * 1.6)) {
      return null;
    }
    const height = palette.wet ? 0.5 + 0.9 * random() : 1.7 + 1.8 * random();
    const kind = Math.floor(random() * palette.trees.length);
    return { x, y: heightAt(x, z, palette.wet) - 0.05, z, turn: 6.3 * random(), height, width: height * (0.85 + 0.3 * random()), colour: new Color(palette.trees[kind]).offsetHSL(0.02 * (random() - 0.5), 0, 0.05 * (random() - 0.5)) };
  });
  trees.castShadow = false;
  return { grass, flowers, trees, all: [grass, flowers, trees], halfWidth };
}
