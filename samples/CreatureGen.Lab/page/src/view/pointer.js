import { Raycaster, Vector2, Vector3 } from 'three';

const clickPixels = 6;

/** What fingers, mouse and keys do on the stage, as events: `turn`, `zoom`, `look`, `pick`, `send`. */
export class Pointer extends EventTarget {
  #pointers = new Map();
  #ray = new Raycaster();
  #spread = 0;

  constructor(canvas, orbit, world, herd) {
    super();
    Object.assign(this, { canvas, orbit, world, herd });
    canvas.addEventListener('pointerdown', event => this.#down(event));
    canvas.addEventListener('pointermove', event => this.#move(event));
    canvas.addEventListener('pointerup', event => this.#up(event));
    canvas.addEventListener('pointercancel', event => this.#pointers.delete(event.pointerId));
    canvas.addEventListener('pointerleave', () => this.#tell('look', null));
    canvas.addEventListener('wheel', event => {
      event.preventDefault();
      orbit.zoom(Math.exp(event.deltaY * 0.0011));
    }, { passive: false });
    canvas.addEventListener('dblclick', event => {
      const place = this.#ground(event);
      if (place && !this.#member(event)) {
        this.#tell('send', place);
      }
    });
    canvas.addEventListener('keydown', event => {
      const turns = { ArrowLeft: [-0.12, 0], ArrowRight: [0.12, 0], ArrowUp: [0, 0.07], ArrowDown: [0, -0.07] }[event.key];
      if (turns) {
        event.preventDefault();
        orbit.turn(...turns);
      } else if (event.key === '+' || event.key === '-') {
        orbit.zoom(event.key === '+' ? 0.88 : 1.14);
      }
    });
  }

  #down(event) {
    this.canvas.setPointerCapture(event.pointerId);
    this.#pointers.set(event.pointerId, { x: event.clientX, y: event.clientY, startX: event.clientX, startY: event.clientY });
    this.#spread = this.#distance();
  }

  #move(event) {
    const pointer = this.#pointers.get(event.pointerId);
    if (!pointer) {
      this.#aim(event);
      this.#tell('look', this.#ray.ray.origin.clone().addScaledVector(this.#ray.ray.direction, 0.6 * this.orbit.distance));
      return;
    }
    if (this.#pointers.size === 1) {
      this.orbit.turn((event.clientX - pointer.x) * 0.006, (event.clientY - pointer.y) * 0.004);
    }
    pointer.x = event.clientX;
    pointer.y = event.clientY;
    if (this.#pointers.size === 2) {
      const spread = this.#distance();
      this.orbit.zoom(this.#spread / Math.max(spread, 1));
      this.#spread = spread;
    }
  }

  #up(event) {
    const pointer = this.#pointers.get(event.pointerId);
    this.#pointers.delete(event.pointerId);
    if (pointer && Math.hypot(event.clientX - pointer.startX, event.clientY - pointer.startY) < clickPixels) {
      const member = this.#member(event);
      if (member) {
        this.#tell('pick', member);
      }
    }
  }

  #distance() {
    const [a, b] = [...this.#pointers.values()];
    return a && b ? Math.hypot(a.x - b.x, a.y - b.y) : 0;
  }

  #aim(event) {
    this.#ray.setFromCamera(new Vector2((2 * event.clientX) / innerWidth - 1, 1 - (2 * event.clientY) / innerHeight), this.orbit.camera);
  }

  /** Whose body is under the pointer. */
  #member(event) {
    this.#aim(event);
    let best = null;
    let nearest = Infinity;
    const centre = new Vector3();
    for (const member of this.herd.members.values()) {
      centre.copy(member.body.group.position);
      centre.y += 0.45 * member.facts.height;
      const away = this.#ray.ray.distanceToPoint(centre);
      const far = centre.distanceTo(this.#ray.ray.origin);
      if (away < 0.42 * Math.max(member.facts.length, member.facts.height) && far < nearest) {
        nearest = far;
        best = member;
      }
    }
    return best;
  }

  /** Where the pointer meets the land. */
  #ground(event) {
    this.#aim(event);
    const { origin, direction } = this.#ray.ray;
    const step = 0.15 * this.world.scale;
    for (let t = 0; t < 60 * this.world.scale; t += step) {
      const x = origin.x + direction.x * t;
      const z = origin.z + direction.z * t;
      if (origin.y + direction.y * t < this.world.heightAt(x, z)) {
        return { x, z };
      }
    }
    return null;
  }

  #tell(name, detail) {
    this.dispatchEvent(new CustomEvent(name, { detail }));
  }
}
