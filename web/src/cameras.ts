/** Cameras: each looks at a point of the aircraft from a direction and a distance, in axes that move with it. */
import { PerspectiveCamera } from "three";
import type { Airframe } from "./airframe";
import type { Motion } from "./motion";
import type { Scene, Vec } from "./scene";
import { add, minus, times } from "./vectors";

export const cameraNames = ["chase", "wing tip", "side", "top", "free"] as const;
export type CameraName = (typeof cameraNames)[number];

interface Aim {
  /** Axes that turn with the (smoothed) heading and stay level, or with the body. */
  axes: "heading" | "body";
  /** What is looked at, from O, body axes, m. */
  target: Vec;
  /** From the target to the eye: angle from straight ahead towards the right, angle upwards, rad; distance, m. */
  azimuth: number;
  elevation: number;
  distance: number;
}

const DEGREE = Math.PI / 180;
/** Times its own height a show must fit into the picture, which at its usual distance is about as tall as the aircraft is large. */
const TALLEST = 1.6;

export class Cameras {
  readonly camera = new PerspectiveCamera(34, 1, 0.1, 1000);
  name: CameraName = "chase";
  private aim: Aim;
  private middle: Vec;
  /** By how much strips reach beyond the sections: to low and to high coordinates, m. */
  private readonly margins: [Vec, Vec];
  private readonly tip: Vec;
  private readonly size: number;
  /** Distance at which the show fits, in parts of that of the undeformed aircraft. */
  private room = 1;
  private readonly turn = new Float64Array(9);
  private readonly basis = new Float64Array(9);
  private readonly target = new Float64Array(3);

  constructor(scene: Scene) {
    this.size = scene.size;
    this.margins = marginsOf(scene);
    this.middle = middleOf(scene.sections);
    this.tip = scene.sections.reduce((tip, at) => (at[1] > tip[1] + 1e-9 ? at : tip), this.middle);
    this.aim = this.preset("chase");
    this.camera.near = 0.01 * this.size;
    this.camera.far = 600 * this.size;
    this.camera.matrixAutoUpdate = false;
  }

  /** Makes room for a show; whoever has turned the view keeps it. */
  frame(motion: Motion): void {
    const [low, high] = motion.box().map((corner, i) => add(corner, this.margins[i]));
    this.middle = middleOf([low, high]);
    this.room = Math.max(1, (TALLEST * (high[2] - low[2])) / this.size);
    if (this.name !== "free") this.aim = this.preset(this.name);
  }

  choose(name: CameraName): void {
    if (name === "free") this.free();
    else this.aim = this.preset(name);
    this.name = name;
  }

  reset(): void {
    this.choose("chase");
  }

  orbit(right: number, up: number): void {
    if (this.name !== "free") this.free();
    this.aim.azimuth -= right;
    const elevation = this.aim.elevation + up;
    this.aim.elevation = Math.min(Math.max(elevation, -89.9 * DEGREE), 89.9 * DEGREE);
  }

  /** Changes the distance by a factor. */
  zoom(factor: number): void {
    const distance = this.aim.distance * factor;
    this.aim.distance = Math.min(Math.max(distance, 0.05 * this.size), 40 * this.size);
  }

  /** Moves the target over the picture, by shares of its height. */
  pan(right: number, down: number): void {
    if (this.name !== "free") this.free();
    const span = 2 * this.aim.distance * Math.tan((this.camera.fov / 2) * DEGREE);
    for (let i = 0; i < 3; i++) {
      this.aim.target[i] += span * (down * this.basis[3 * i + 1] - right * this.basis[3 * i]);
    }
  }

  setAspect(aspect: number): void {
    this.camera.aspect = aspect;
    this.camera.updateProjectionMatrix();
  }

  /** Puts the camera where it belongs; positions count from O, earth axes. */
  place(airframe: Airframe, heading: number): void {
    const { aim, basis, turn, target } = this;
    for (let i = 0; i < 3; i++) target[i] = aim.target[i];
    if (aim.axes === "body") {
      for (let i = 0; i < 9; i++) turn[i] = airframe.place[3 + i];
    } else {
      writeHeading(heading, turn);
    }
    rotate(turn, target);
    writeAim(aim, basis);
    const m = this.camera.matrix.elements;
    for (let column = 0; column < 3; column++) {
      for (let row = 0; row < 3; row++) {
        let sum = 0;
        for (let k = 0; k < 3; k++) sum += turn[3 * row + k] * basis[3 * k + column];
        m[4 * column + row] = sum;
      }
    }
    // In a narrow picture, further away: the wing is wider than the aircraft is tall.
    const distance = aim.distance * Math.max(1, 1.3 / this.camera.aspect);
    for (let i = 0; i < 3; i++) m[12 + i] = target[i] + distance * m[8 + i];
    this.camera.updateMatrixWorld(true);
  }

  /** The present view, as one that can be turned. */
  private free(): void {
    this.name = "free";
    const isLevel = this.aim.axes === "heading";
    this.aim = isLevel ? { ...this.aim, target: [...this.aim.target] } : this.preset("free");
  }

  private preset(name: CameraName): Aim {
    const { size, middle, tip, room } = this;
    const level = { axes: "heading" as const, target: [...middle] as Vec };
    switch (name) {
      case "side":
        return { ...level, azimuth: 90 * DEGREE, elevation: 4 * DEGREE, distance: 1.75 * size * room };
      case "top":
        return { ...level, azimuth: 180 * DEGREE, elevation: 90 * DEGREE, distance: 2 * size };
      case "wing tip": {
        const target: Vec = [tip[0], 0.8 * tip[1] + 0.2 * middle[1], tip[2]];
        return { axes: "body", target, azimuth: -112 * DEGREE, elevation: 13 * DEGREE, distance: 0.4 * size };
      }
      case "free":
        return { ...level, azimuth: -145 * DEGREE, elevation: 22 * DEGREE, distance: 1.6 * size * room };
      case "chase":
        return { ...level, azimuth: -155 * DEGREE, elevation: 11 * DEGREE, distance: 1.65 * size * room };
    }
  }
}

function boxOf(points: Vec[]): [Vec, Vec] {
  const low = points.reduce((a, b) => [Math.min(a[0], b[0]), Math.min(a[1], b[1]), Math.min(a[2], b[2])]);
  const high = points.reduce((a, b) => [Math.max(a[0], b[0]), Math.max(a[1], b[1]), Math.max(a[2], b[2])]);
  return [low, high];
}

function middleOf(points: Vec[]): Vec {
  const [low, high] = boxOf(points);
  return times(0.5, add(low, high));
}

function marginsOf({ sections, strips }: Scene): [Vec, Vec] {
  const corners = strips.flatMap(({ section, corners }) => corners.map((corner) => add(sections[section], corner)));
  const bare = boxOf(sections);
  const [low, high] = boxOf([...sections, ...corners]);
  return [minus(low, bare[0]), minus(high, bare[1])];
}

function writeHeading(heading: number, out: Float64Array): void {
  out.fill(0);
  out[0] = out[4] = Math.cos(heading);
  out[3] = Math.sin(heading);
  out[1] = -out[3];
  out[8] = 1;
}

/** Writes the camera's axes as columns: to the right, up, and from the target to the eye. */
function writeAim({ azimuth, elevation }: Aim, out: Float64Array): void {
  const ca = Math.cos(azimuth);
  const sa = Math.sin(azimuth);
  const ce = Math.cos(elevation);
  const se = Math.sin(elevation);
  out[2] = ce * ca;
  out[5] = ce * sa;
  out[8] = -se;
  out[1] = -se * ca;
  out[4] = -se * sa;
  out[7] = -ce;
  out[0] = sa;
  out[3] = -ca;
  out[6] = 0;
}

function rotate(m: Float64Array, v: Float64Array): void {
  const x = v[0];
  const y = v[1];
  const z = v[2];
  for (let i = 0; i < 3; i++) v[i] = m[3 * i] * x + m[3 * i + 1] * y + m[3 * i + 2] * z;
}
