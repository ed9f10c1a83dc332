import { Raycaster, Vector2, Vector3 } from 'three';

const clickPixels = 6;
const twiceMilliseconds = 320;
const flickSpeed = 0.75;
const flickPixels = 40;

/**
 * What fingers, mouse and keys do on the stage, as events: `look`, `pick` (another creature), `pet` (the chosen one), `send` (the ground, twice), `push` (a flick over the chosen one), and `grip`, `pull`, `release`, `hover`
 * while `shaping` is on.
 */
export class Pointer extends EventTarget {
  #pointers = new Map();
  #ray = new Raycaster();
  #spread = 0;
  #grip = null;
  #tap = { at: -Infinity, x: 0, y: 0 };

  constructor(canvas, orbit, world, herd, touch) {
    super();
    Object.assign(this, { canvas, orbit, world, herd, touch });
    this.shaping = false;
    canvas.addEventListener('pointerdown', event => this.#down(event));
    canvas.addEventListener('pointermove', event => this.#move(event));
    canvas.addEventListener('pointerup', event => this.#up(event));
    canvas.addEventListener('pointercancel', event => { this.#pointers.delete(event.pointerId); this.#release(true); });
    canvas.addEventListener('pointerleave', () => this.#tell('look', null));
    canvas.addEventListener('wheel', event => {
      event.preventDefault();
      orbit.zoom(Math.exp(event.deltaY * 0.0011));
    }, { passive: false });
    canvas.addEventListener('keydown', event => {
      const turns = { ArrowLeft: [-0.12, 0], ArrowRight: [0.12, 0], ArrowUp: [0, 0.07], ArrowDown: [0, -0.07] }[event.key];
      if (turns) {
        event.preventDefault();
        orbit.turn(...turns);
      } else if (event.key === '+' || event.key === '-') {
        orbit.zoom(event.key === '+' ? 0.88 : 1.14);
      }
    });
    addEventListener('keydown', event => {
      if (event.key === 'Escape') {
        this.#release(true);
      }
    });
  }

  #down(event) {
    this.canvas.setPointerCapture(event.pointerId);
    const hit = this.#pointers.size === 0 ? this.#body(event) : null;
    this.#pointers.set(event.pointerId, { x: event.clientX, y: event.clientY, startX: event.clientX, startY: event.clientY, since: event.timeStamp, hit });
    this.#spread = this.#distance();
    if (this.#pointers.size > 1) {
      this.#release(true);
    } else if (hit && this.shaping) {
      this.#grip = { id: event.pointerId, begun: false, hit };
    }
  }

  #move(event) {
    const pointer = this.#pointers.get(event.pointerId);
    if (!pointer) {
      this.#aim(event);
      this.#tell('look', this.#ray.ray.origin.clone().addScaledVector(this.#ray.ray.direction, 0.6 * this.orbit.distance));
      if (event.pointerType === 'mouse') {
        this.#tell('hover', this.#body(event));
      }
      return;
    }
    const [dx, dy] = [event.clientX - pointer.startX, event.clientY - pointer.startY];
    if (this.#grip) {
      if (!this.#grip.begun && Math.hypot(dx, dy) >= clickPixels) {
        this.#grip.begun = true;
        this.#tell('grip', { ...this.#grip.hit, dx, dy });
      }
      if (this.#grip.begun) {
        this.#tell('pull', { dx, dy, x: event.clientX, y: event.clientY });
      }
    } else if (this.#pointers.size === 1 && !pointer.hit) {
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
    if (this.#grip?.begun) {
      this.#release(false);
      return;
    }
    this.#grip = null;
    if (!pointer) {
      return;
    }
    const [dx, dy] = [event.clientX - pointer.startX, event.clientY - pointer.startY];
    const far = Math.hypot(dx, dy);
    if (far < clickPixels) {
      this.#tapped(event, pointer.hit);
    } else if (pointer.hit && far > flickPixels) {
      this.#flick(pointer.hit, dx, dy, far / Math.max(event.timeStamp - pointer.since, 1));
    }
  }

  #tapped(event, hit) {
    const twice = event.timeStamp - this.#tap.at < twiceMilliseconds && Math.hypot(event.clientX - this.#tap.x, event.clientY - this.#tap.y) < 30;
    this.#tap = { at: twice ? -Infinity : event.timeStamp, x: event.clientX, y: event.clientY };
    const member = hit ? null : this.#member(event);
    if (hit) {
      this.#tell('pet', hit);
    } else if (member) {
      this.#tell('pick', member);
    } else if (twice) {
      const place = this.#ground(event);
      if (place) {
        this.#tell('send', place);
      }
    }
  }

  /** A stroke over the body: along the ground, the way that the finger went. */
  #flick(hit, dx, dy, speed) {
    if (speed > flickSpeed) {
      const { azimuth } = this.orbit;
      const [right, away] = [dx, -dy];
      const x = right * Math.cos(azimuth) - away * Math.sin(azimuth);
      const z = -right * Math.sin(azimuth) - away * Math.cos(azimuth);
      this.#tell('push', { ...hit, x, z, strength: Math.min(1.1, 0.22 + 0.2 * speed) });
    }
  }

  #release(takenBack) {
    if (this.#grip?.begun) {
      this.#tell('release', takenBack);
    }
    this.#grip = null;
  }

  #distance() {
    const [a, b] = [...this.#pointers.values()];
    return a && b ? Math.hypot(a.x - b.x, a.y - b.y) : 0;
  }

  #aim(event) {
    this.#ray.setFromCamera(new Vector2((2 * event.clientX) / innerWidth - 1, 1 - (2 * event.clientY) / innerHeight), this.orbit.camera);
  }

  /** Where the pointer is on the chosen creature. Fingers are thicker than arrows. */
  #body(event) {
    this.#aim(event);
    const pixel = (2 * this.orbit.distance * Math.tan((this.orbit.camera.fov * Math.PI) / 360)) / innerHeight;
    return this.touch.hit(this.#ray.ray, pixel * (event.pointerType === 'mouse' ? 5 : 14));
  }

  /** Whose body is under the pointer, of the others. */
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
      if (member.slot !== this.herd.eye && away < 0.42 * Math.max(member.facts.length, member.facts.height) && far < nearest) {
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
