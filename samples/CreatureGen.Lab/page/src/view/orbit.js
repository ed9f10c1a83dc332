import { PerspectiveCamera, Vector3 } from 'three';

const softness = 5;

/** The eye: turns about what it looks at, follows it softly, and never goes below the land. */
export class Orbit {
  constructor() {
    this.camera = new PerspectiveCamera(32, 1, 0.05, 400);
    this.focus = new Vector3();
    this.goal = new Vector3();
    this.azimuth = 0.62;
    this.elevation = 0.12;
    this.distance = 5;
    this.wantedDistance = 5;
    this.drift = 0;
  }

  /** Frames something of a size, seen from an angle. */
  frame(centre, size, distance) {
    this.goal.copy(centre);
    this.wantedDistance = distance;
    this.size = size;
  }

  jump() {
    this.focus.copy(this.goal);
    this.distance = this.wantedDistance;
  }

  turn(dx, dy) {
    this.azimuth -= dx;
    this.elevation = Math.min(1.25, Math.max(-0.12, this.elevation + dy));
  }

  zoom(factor) {
    this.wantedDistance = Math.min(this.size * 14, Math.max(this.size * 1.1, this.wantedDistance * factor));
  }

  update(seconds, world) {
    const share = 1 - Math.exp(-softness * seconds);
    this.focus.lerp(this.goal, share);
    this.distance += (this.wantedDistance - this.distance) * share;
    this.azimuth += this.drift * seconds;
    const { camera, focus } = this;
    const level = Math.cos(this.elevation) * this.distance;
    camera.position.set(focus.x + level * Math.sin(this.azimuth), focus.y + this.distance * Math.sin(this.elevation), focus.z + level * Math.cos(this.azimuth));
    const lowest = world.heightAt(camera.position.x, camera.position.z) + 0.16 * world.scale;
    camera.position.y = Math.max(camera.position.y, lowest);
    camera.near = 0.02 * world.scale;
    camera.far = 260 * world.scale;
    camera.lookAt(focus);
  }

  /** Fits the picture into the part of the window that no panel covers. */
  fit(width, height, covered) {
    const { camera } = this;
    camera.aspect = width / height;
    camera.fov = width < height ? 46 : 32;
    camera.setViewOffset(width, height, covered.right / 2, covered.bottom / 2, width, height);
    camera.updateProjectionMatrix();
  }
}
