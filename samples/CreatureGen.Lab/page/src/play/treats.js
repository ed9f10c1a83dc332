import { BufferGeometry, CylinderGeometry, Float32BufferAttribute, Group, IcosahedronGeometry, Mesh, MeshLambertMaterial, MeshStandardMaterial, Points, ShaderMaterial, Vector3 } from 'three';

const fallSeconds = 0.5;
const heartSeconds = 1.7;
const bites = 3;

/** A fruit that falls from above, lies there, and gets less with every bite. */
class Fruit {
  constructor(place, size) {
    this.group = new Group();
    const apple = new Mesh(new IcosahedronGeometry(0.5, 3), new MeshStandardMaterial({ color: '#e5402f', roughness: 0.3, emissive: '#6a0d08', emissiveIntensity: 0.5 }));
    const p = apple.geometry.attributes.position;
    for (let i = 0; i < p.count; i++) {
      const [x, y, z] = [p.getX(i), p.getY(i), p.getZ(i)];
      const dent = 0.2 * Math.exp(-9 * (x * x + z * z)) * Math.sign(y);
      p.setY(i, 0.92 * y - dent);
    }
    apple.geometry.computeVertexNormals();
    const stalk = new Mesh(new CylinderGeometry(0.03, 0.045, 0.34, 6).rotateZ(0.25).translate(-0.03, 0.45, 0), new MeshLambertMaterial({ color: '#5d4326' }));
    const leaf = new Mesh(new IcosahedronGeometry(0.16, 1).scale(1.4, 0.25, 0.7).rotateZ(0.5).translate(0.18, 0.52, 0), new MeshLambertMaterial({ color: '#6aa83d' }));
    apple.castShadow = true;
    this.group.add(apple, stalk, leaf);
    this.place = place;
    this.size = size;
    this.age = 0;
    this.left = bites;
  }

  bite() {
    this.left = Math.max(1, this.left - 1);
  }

  get bitten() {
    return this.left < bites;
  }

  update(seconds) {
    this.age += seconds;
    const t = Math.min(1, this.age / fallSeconds);
    const bounce = t < 1 ? (1 - t * t) * 3 : 0.25 * Math.abs(Math.sin(7 * (this.age - fallSeconds))) * Math.exp(-6 * (this.age - fallSeconds));
    const whole = this.size * (0.4 + (0.6 * this.left) / bites);
    this.group.scale.setScalar(whole);
    this.group.position.copy(this.place).add(new Vector3(0, (0.5 + bounce) * whole, 0));
    return true;
  }
}

const heartVertex = `
attribute vec3 way;
uniform float age, pixels;
void main() {
  vec4 at = modelViewMatrix * vec4(position + way * (1.0 - exp(-2.2 * age)) + vec3(0.05 * sin(age * 5.0 + way.x * 40.0), 0.0, 0.0) * length(way), 1.0);
  gl_Position = projectionMatrix * at;
  gl_PointSize = pixels * length(way) / -at.z * (0.5 + min(1.0, age * 6.0));
}`;
const heartFragment = `
uniform float left;
void main() {
  vec2 p = gl_PointCoord * 2.0 - 1.0;
  p.y = -p.y * 1.15 + 0.2;
  p.x *= 1.15;
  float a = p.x * p.x + p.y * p.y - 0.55;
  float inside = a * a * a - p.x * p.x * p.y * p.y * p.y;
  if (inside > 0.0) discard;
  gl_FragColor = vec4(mix(vec3(0.93, 0.22, 0.34), vec3(1.0, 0.62, 0.66), smoothstep(-0.02, -0.16, inside) * 0.5), left);
}`;

/** Hearts that rise and fade. */
class Hearts {
  constructor(place, size, pixels) {
    const count = 9;
    const places = [];
    const ways = [];
    for (let n = 0; n < count; n++) {
      const angle = 2.4 * n;
      places.push(0.12 * size * Math.sin(angle), 0, 0.12 * size * Math.cos(angle));
      ways.push(0.35 * size * Math.sin(angle), size * (0.55 + 0.09 * n), 0.35 * size * Math.cos(angle));
    }
    const geometry = new BufferGeometry().setAttribute('position', new Float32BufferAttribute(places, 3)).setAttribute('way', new Float32BufferAttribute(ways, 3));
    this.uniforms = { age: { value: 0 }, left: { value: 1 }, pixels: { value: 0.22 * pixels } };
    this.group = new Points(geometry, new ShaderMaterial({ vertexShader: heartVertex, fragmentShader: heartFragment, uniforms: this.uniforms, transparent: true, depthTest: false }));
    this.group.frustumCulled = false;
    this.group.renderOrder = 9;
    this.group.position.copy(place);
  }

  update(seconds) {
    this.uniforms.age.value += seconds;
    const share = this.uniforms.age.value / heartSeconds;
    this.uniforms.left.value = Math.min(1, 3 * (1 - share));
    return share < 1;
  }
}

/** Fruit that lies about, and hearts. */
export class Treats {
  #things = new Set();

  constructor(scene) {
    this.scene = scene;
    this.fruit = null;
  }

  /** Lets a fruit fall, in place of the one before. */
  drop(place, size) {
    this.clear();
    this.fruit = new Fruit(place, size);
    this.#add(this.fruit);
  }

  hearts(place, size, pixels) {
    this.#add(new Hearts(place, size, pixels));
  }

  bite() {
    this.fruit?.bite();
  }

  clear() {
    if (this.fruit) {
      this.#remove(this.fruit);
      this.fruit = null;
    }
  }

  update(seconds) {
    for (const thing of this.#things) {
      if (!thing.update(seconds)) {
        this.#remove(thing);
        this.fruit = thing === this.fruit ? null : this.fruit;
      }
    }
  }

  #add(thing) {
    this.#things.add(thing);
    this.scene.add(thing.group);
  }

  #remove(thing) {
    this.#things.delete(thing);
    thing.group.removeFromParent();
    thing.group.traverse(part => {
      part.geometry?.dispose();
      part.material?.dispose();
    });
  }
}
