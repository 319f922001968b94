/** Sky, horizon and a grid over the ground: a dome around the camera, and lines on a plane. */
import {
  BufferGeometry,
  Color,
  DoubleSide,
  Float32BufferAttribute,
  Group,
  LineSegments,
  Mesh,
  ShaderMaterial,
  Vector2,
  Vector3,
  type PerspectiveCamera,
} from "three";
import type { Theme } from "./theme";

// Colours are found at vertices and blended between them, which costs little where the processor draws pixels.
const domeVertex = /* glsl */ `
uniform vec3 zenith, sky, horizon, ground;
uniform vec3 eye;
uniform float radius;
varying vec3 colour;
void main() {
  float up = -position.z;
  vec3 over = mix(mix(horizon, sky, clamp(6.0 * up, 0.0, 1.0)), zenith, clamp(1.3 * up - 0.1, 0.0, 1.0));
  vec3 under = mix(horizon, ground, clamp(-5.0 * up, 0.0, 1.0));
  colour = up > 0.0 ? over : under;
  gl_Position = projectionMatrix * (viewMatrix * vec4(eye + radius * position, 1.0));
}`;
const domeFragment = /* glsl */ `
varying vec3 colour;
void main() { gl_FragColor = vec4(colour, 1.0); }`;

const lineVertex = /* glsl */ `
uniform vec3 eye;
uniform vec2 middle;
uniform float cell, depth, reach, nearest;
attribute vec2 other;
varying vec2 away;
vec4 place(vec2 at) { return projectionMatrix * (viewMatrix * vec4(at, depth, 1.0)); }
void main() {
  vec2 at = middle + cell * position.xy;
  vec2 end = middle + cell * other;
  float ahead = place(at).w;
  float behind = nearest - ahead;
  // A line from behind the eye begins before it: where the processor draws pixels, such lines are lost else.
  if (behind > 0.0) at = mix(at, end, clamp(behind / max(place(end).w - ahead, 1e-6), 0.0, 1.0));
  away = (at - eye.xy) / reach;
  gl_Position = place(at);
}`;
const lineFragment = /* glsl */ `
uniform vec3 line;
uniform float strength;
varying vec2 away;
void main() {
  float seen = max(1.0 - length(away), 0.0);
  gl_FragColor = vec4(line, strength * seen * seen);
}`;

/** Lines to each side of the middle. */
const LINES = 16;

export class Backdrop {
  readonly group = new Group();
  readonly cell: number;
  /** What the picture is cleared with. */
  readonly ground = new Color();
  private readonly dome: ShaderMaterial;
  private readonly grids: { cell: number; material: ShaderMaterial }[];

  constructor(size: number) {
    this.cell = roundLength(size / 2);
    this.dome = new ShaderMaterial({
      vertexShader: domeVertex,
      fragmentShader: domeFragment,
      side: DoubleSide,
      depthTest: false,
      depthWrite: false,
      uniforms: {
        eye: { value: new Vector3() },
        radius: { value: 100 * size },
        ...Object.fromEntries(NAMES.map((name) => [name, { value: new Color() }])),
      },
    });
    this.grids = [1, 10].map((factor) => gridOf(factor * this.cell, 0.05 * size));
    const lines = lineGeometry();
    const dome = new Mesh(domeGeometry(), this.dome);
    dome.renderOrder = -2;
    this.group.add(dome, ...this.grids.map(({ material }) => new LineSegments(lines, material)));
    for (const part of this.group.children) part.frustumCulled = false;
  }

  setTheme(theme: Theme): void {
    for (const name of NAMES) this.dome.uniforms[name].value.set(theme[name]);
    this.ground.set(theme.ground);
    for (const { material } of this.grids) material.uniforms.line.value.set(theme.line);
  }

  /** `origin` is what the camera's position counts from and `ground` how deep the plane is, both in earth axes. */
  place(camera: PerspectiveCamera, origin: Float64Array, ground: number): void {
    const m = camera.matrixWorld.elements;
    this.dome.uniforms.eye.value.set(m[12], m[13], m[14]);
    for (let g = 0; g < this.grids.length; g++) {
      const { cell, material } = this.grids[g];
      const { uniforms } = material;
      uniforms.eye.value.set(m[12], m[13], m[14]);
      uniforms.depth.value = ground - origin[2];
      // The grid goes along with the camera, by whole cells.
      const north = Math.round((origin[0] + m[12]) / cell) * cell - origin[0];
      const east = Math.round((origin[1] + m[13]) / cell) * cell - origin[1];
      uniforms.middle.value.set(north, east);
    }
  }
}

const NAMES = ["zenith", "sky", "horizon", "ground"] as const;

/** `nearest` is how far ahead of the eye lines begin, m. */
function gridOf(cell: number, nearest: number): { cell: number; material: ShaderMaterial } {
  const material = new ShaderMaterial({
    vertexShader: lineVertex,
    fragmentShader: lineFragment,
    transparent: true,
    depthWrite: false,
    uniforms: {
      eye: { value: new Vector3() },
      middle: { value: new Vector2() },
      cell: { value: cell },
      depth: { value: 0 },
      nearest: { value: nearest },
      reach: { value: (LINES - 1) * cell },
      line: { value: new Color() },
      strength: { value: 0.9 },
    },
  });
  return { cell, material };
}

/** Lines a unit apart in both directions; each end knows the other. */
function lineGeometry(): BufferGeometry {
  const points: number[] = [];
  const others: number[] = [];
  for (let k = -LINES; k <= LINES; k++) {
    points.push(k, -LINES, 0, k, LINES, 0, -LINES, k, 0, LINES, k, 0);
    others.push(k, LINES, k, -LINES, LINES, k, -LINES, k);
  }
  const geometry = new BufferGeometry().setAttribute("position", new Float32BufferAttribute(points, 3));
  return geometry.setAttribute("other", new Float32BufferAttribute(others, 2));
}

/**
 * Elevations of the rows of the dome, degrees: where the course of the colours bends. Below the lowest all is ground, with which the
 * picture begins: where the processor draws pixels, to clear them costs next to nothing.
 */
const ROWS = [-11.54, 0, 9.6, 25, 57, 90];
const AROUND = 18;

function domeGeometry(): BufferGeometry {
  const points = ROWS.flatMap((degrees) => {
    const elevation = (degrees * Math.PI) / 180;
    return Array.from({ length: AROUND }, (_, k) => {
      const azimuth = (2 * Math.PI * k) / AROUND;
      const flat = Math.cos(elevation);
      return [flat * Math.cos(azimuth), flat * Math.sin(azimuth), -Math.sin(elevation)];
    }).flat();
  });
  const triangles = ROWS.slice(1).flatMap((_, row) =>
    Array.from({ length: AROUND }, (_, k) => {
      const [a, b] = [row * AROUND + k, row * AROUND + ((k + 1) % AROUND)];
      return [a, b, b + AROUND, a, b + AROUND, a + AROUND];
    }).flat(),
  );
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new Float32BufferAttribute(points, 3));
  geometry.setIndex(triangles);
  return geometry;
}

/** 1, 2 or 5 times a power of ten, at or below a length. */
function roundLength(length: number): number {
  const power = 10 ** Math.floor(Math.log10(length));
  const share = length / power;
  return power * (share >= 5 ? 5 : share >= 2 ? 2 : 1);
}
