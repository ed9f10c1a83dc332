import { CircleGeometry, Color, Mesh, ShaderMaterial, UniformsLib, UniformsUtils } from 'three';
import { lake } from './terrain.js';

const vertex = `
varying vec3 place;
#include <fog_pars_vertex>
void main() {
  place = (modelMatrix * vec4(position, 1.0)).xyz;
  vec4 mvPosition = viewMatrix * vec4(place, 1.0);
  gl_Position = projectionMatrix * mvPosition;
  #include <fog_vertex>
}`;

const fragment = `
varying vec3 place;
uniform vec3 shallow, deep, sky, zenith, sunColour, sunWay;
uniform float time, unit;
#include <fog_pars_fragment>
float wave(vec2 p, vec2 d, float f, float s) { return cos(dot(p, d) * f + time * s) * f; }
void main() {
  vec2 p = place.xz / unit;
  vec2 slope = vec2(0.0);
  slope += vec2(0.8, 0.6) * wave(p, vec2(0.8, 0.6), 2.1, 1.1) + vec2(-0.5, 0.87) * wave(p, vec2(-0.5, 0.87), 3.4, 1.5);
  slope += vec2(0.3, -0.95) * wave(p, vec2(0.3, -0.95), 6.3, 2.1) + vec2(-0.9, -0.4) * wave(p, vec2(-0.9, -0.4), 11.0, 2.9);
  vec3 normal = normalize(vec3(-slope.x * 0.0028, 1.0, -slope.y * 0.0028));
  vec3 eye = normalize(cameraPosition - place);
  float facing = max(dot(normal, eye), 0.0);
  float fresnel = 0.04 + 0.96 * pow(1.0 - facing, 4.0);
  vec3 mirrored = reflect(-eye, normal);
  vec3 reflection = mix(sky, zenith, smoothstep(0.0, 0.7, mirrored.y));
  vec3 colour = mix(mix(deep, shallow, facing * 0.6), reflection, fresnel);
  colour += sunColour * pow(max(dot(mirrored, sunWay), 0.0), 420.0) * 2.2;
  gl_FragColor = vec4(colour, 0.93);
  #include <tonemapping_fragment>
  #include <colorspace_fragment>
  #include <fog_fragment>
}`;

/** The lake. */
export function makeLake(palette, sunWay, clock) {
  const uniforms = UniformsUtils.merge([
    UniformsLib.fog,
    {
      shallow: { value: new Color('#4aa6a2') },
      deep: { value: new Color('#1d5f7f') },
      sky: { value: new Color(palette.sky) },
      zenith: { value: new Color(palette.zenith) },
      sunColour: { value: new Color(palette.sun) },
      unit: { value: 1 },
    },
  ]);
  uniforms.sunWay = { value: sunWay };
  uniforms.time = clock;
  const surface = new Mesh(new CircleGeometry(lake.radius * 2.4, 48).rotateX(-Math.PI / 2), new ShaderMaterial({ vertexShader: vertex, fragmentShader: fragment, uniforms, transparent: true, fog: true }));
  surface.position.set(lake.x, lake.level, lake.z);
  surface.scale.set(1.15, 1, 1);
  return surface;
}
