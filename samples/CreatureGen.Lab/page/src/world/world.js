import { Color, DirectionalLight, Fog, Group, HemisphereLight, Points, PointsMaterial, BufferGeometry, BufferAttribute, Scene, Vector3 } from 'three';
import { makeGround } from './ground.js';
import { makePlants } from './plants.js';
import { makeLake } from './water.js';
import { makeSky } from './sky.js';
import { heightAt, heightField, lake } from './terrain.js';
import { sequence } from './noise.js';
import * as palettes from './palettes.js';
import { wantsStillness } from '../view/stillness.js';

const sunWay = new Vector3(0.62, 0.62, 0.48).normalize();

/** Where creatures live: the meadow or the sea, made when it is first needed, as large as the creature that is looked at asks for. */
export class World {
  #habitats = new Map();
  #clock = { value: 0 };

  constructor() {
    this.scene = new Scene();
    this.scale = 1;
    this.sun = new DirectionalLight();
    this.sun.castShadow = true;
    this.sun.shadow.mapSize.set(2048, 2048);
    this.sun.shadow.radius = 5;
    this.sun.shadow.blurSamples = 12;
    this.fill = new HemisphereLight();
    this.scene.add(this.sun, this.sun.target, this.fill);
    this.scene.fog = new Fog('#ffffff', 1, 2);
    this.show('meadow', 1);
  }

  /** Shows a habitat at a scale: metres of one of its units. */
  show(name, scale) {
    const palette = palettes[name];
    let habitat = this.#habitats.get(name);
    if (!habitat) {
      habitat = this.#make(palette);
      this.#habitats.set(name, habitat);
      this.scene.add(habitat.group, habitat.sky);
    }
    for (const [other, { group, sky }] of this.#habitats) {
      group.visible = sky.visible = other === name;
    }
    this.name = name;
    this.palette = palette;
    this.plants = habitat.plants;
    this.scale = scale;
    habitat.group.scale.setScalar(scale);
    if (habitat.water) {
      habitat.water.material.uniforms.unit.value = scale;
    }
    this.scene.fog.color.set(palette.haze);
    this.scene.fog.near = palette.hazeNear * scale;
    this.scene.fog.far = palette.hazeFar * scale;
    this.sun.color.set(palette.sun);
    this.sun.intensity = palette.sunPower;
    this.fill.color.set(palette.shade);
    this.fill.groundColor.set(palette.bounce);
    this.fill.intensity = palette.fill;
    const camera = this.sun.shadow.camera;
    const half = 3.4 * scale;
    Object.assign(camera, { left: -half, right: half, top: half, bottom: -half, near: scale, far: 40 * scale });
    camera.updateProjectionMatrix();
    this.sun.shadow.normalBias = 0.016 * scale;
    this.sun.shadow.bias = -0.0004;
  }

  /** Seconds that wind and water have known. */
  get time() {
    return this.#clock.value;
  }

  /** Height of the land at a place, metres. */
  heightAt(x, z) {
    return this.scale * heightAt(x / this.scale, z / this.scale, this.palette.wet);
  }

  /** Height of the water's surface, metres; without end in the sea. */
  get waterLevel() {
    return this.palette.wet ? Infinity : lake.level * this.scale;
  }

  /** The land as the library takes it. */
  heightField() {
    return heightField(this.palette.wet, this.scale);
  }

  /** Time goes on, and the sun follows what is looked at. */
  update(seconds, focus) {
    this.#clock.value += wantsStillness() ? 0 : seconds;
    this.sun.target.position.copy(focus);
    this.sun.position.copy(focus).addScaledVector(sunWay, 18 * this.scale);
  }

  /** Fewer plants where drawing is slow. */
  thin(share) {
    for (const plants of [...this.#habitats.values()].map(habitat => habitat.plants)) {
      for (const mesh of plants.all) {
        mesh.count = Math.floor(mesh.userData.whole * share);
      }
    }
    this.share = share;
  }

  #make(palette) {
    const group = new Group();
    const plants = makePlants(palette, this.#clock);
    group.add(...makeGround(palette), ...plants.all, motes(palette, this.#clock));
    let water = null;
    if (!palette.wet) {
      water = makeLake(palette, sunWay, this.#clock);
      group.add(water);
    }
    return { group, plants, water, sky: makeSky(palette, sunWay, this.#clock) };
  }
}

/** Pollen in the air, plankton in the sea. */
function motes(palette, clock) {
  const random = sequence(3);
  const count = palette.wet ? 500 : 160;
  const places = new Float32Array(3 * count);
  for (let i = 0; i < count; i++) {
    const r = 1.2 + 10 * Math.sqrt(random());
    const angle = 2 * Math.PI * random();
    places.set([r * Math.sin(angle), 0.2 + 4 * random(), r * Math.cos(angle)], 3 * i);
  }
  const geometry = new BufferGeometry().setAttribute('position', new BufferAttribute(places, 3));
  const points = new Points(geometry, new PointsMaterial({ color: new Color(palette.wet ? '#d8fbff' : '#fffbe0'), size: 1.6, sizeAttenuation: false, transparent: true, opacity: palette.wet ? 0.5 : 0.6, depthWrite: false }));
  points.onBeforeRender = () => {
    const t = clock.value;
    points.position.set(0.4 * Math.sin(t * 0.2), 0.25 * Math.sin(t * 0.33), 0.4 * Math.cos(t * 0.17));
  };
  return points;
}
