import { BackSide, Color, Mesh, ShaderMaterial, SphereGeometry } from 'three';

const vertex = `
varying vec3 way;
void main() {
  way = position;
  vec4 at = projectionMatrix * mat4(mat3(modelViewMatrix)) * vec4(position, 1.0);
  gl_Position = at.xyww;
}`;

const fragment = `
varying vec3 way;
uniform vec3 zenith, sky, horizon, sunColour, sunWay;
uniform float time, wet;
float hash(vec2 p) { p = fract(p * vec2(123.34, 456.21)); p += dot(p, p + 45.32); return fract(p.x * p.y); }
float noise(vec2 p) {
  vec2 i = floor(p), f = fract(p);
  f = f * f * (3.0 - 2.0 * f);
  return mix(mix(hash(i), hash(i + vec2(1, 0)), f.x), mix(hash(i + vec2(0, 1)), hash(i + vec2(1, 1)), f.x), f.y);
}
float cloudy(vec2 p) {
  float sum = 0.0, weight = 0.5;
  for (int o = 0; o < 5; o++) { sum += weight * noise(p); p = p * 2.03 + 7.1; weight *= 0.5; }
  return sum;
}
void main() {
  vec3 d = normalize(way);
  float up = max(d.y, 0.0);
  vec3 colour = mix(horizon, sky, smoothstep(0.0, 0.22, up));
  colour = mix(colour, zenith, smoothstep(0.12, 0.85, up));
  float toSun = max(dot(d, sunWay), 0.0);
  if (wet < 0.5) {
    vec2 p = d.xz / (up + 0.16) * 0.72 + vec2(time * 0.004, 0.0);
    float cover = cloudy(p);
    float cloud = smoothstep(0.50, 0.74, cover) * smoothstep(0.02, 0.2, up);
    float lit = smoothstep(0.0, 0.35, cloudy(p + sunWay.xz * 0.13) - cover + 0.22);
    vec3 white = mix(vec3(0.80, 0.86, 0.93), vec3(1.0, 0.99, 0.96), lit);
    colour = mix(colour, white, cloud * 0.92);
    colour += sunColour * (pow(toSun, 900.0) * 3.0 + pow(toSun, 24.0) * 0.16 + pow(toSun, 5.0) * 0.07);
  } else {
    float rays = noise(vec2(atan(d.x, d.z) * 9.0 + time * 0.05, time * 0.11)) * noise(vec2(atan(d.x, d.z) * 23.0 - time * 0.07, 3.0));
    colour += vec3(0.55, 0.8, 0.8) * rays * smoothstep(0.05, 0.9, up) * 0.6;
    colour += vec3(0.8, 0.95, 0.95) * pow(toSun, 7.0) * 0.5;
  }
  gl_FragColor = vec4(colour, 1.0);
  #include <colorspace_fragment>
}`;

/** The sky as a dome that goes with the eye. */
export function makeSky(palette, sunWay, clock) {
  const uniforms = {
    zenith: { value: new Color(palette.zenith) },
    sky: { value: new Color(palette.sky) },
    horizon: { value: new Color(palette.horizon) },
    sunColour: { value: new Color(palette.sun) },
    sunWay: { value: sunWay },
    wet: { value: palette.wet ? 1 : 0 },
    time: clock,
  };
  const dome = new Mesh(new SphereGeometry(1, 48, 24), new ShaderMaterial({ vertexShader: vertex, fragmentShader: fragment, uniforms, side: BackSide, depthWrite: false, fog: false, toneMapped: false }));
  dome.frustumCulled = false;
  dome.renderOrder = -1;
  return dome;
}
