/**
 * What `flexair view` writes into the page: the scene, as JSON, and the numbers that it points to.
 *
 * All numbers are SI, angles in rad. Body axes: x forward, y to the right, z down; earth axes: north, east, down.
 * The page does no physics: it draws poses that the library computed. web/README.md says how the command fills
 * the template in.
 */

export type Vec = [number, number, number];

export interface Scene {
  format: 1;
  title: string;
  aircraft: string;
  /** Lines for people: warnings, what was assumed. */
  notes: string[];
  /** In a wind tunnel: O stays, nothing moves past. */
  clamped: boolean;
  /** Largest extent of the airframe, m. */
  size: number;
  /** Where each section is on the undeformed aircraft (jig shape), body axes. */
  sections: Vec[];
  strips: Strip[];
  bodies: Body[];
  engines: Engine[];
  stations: { name: string; section: number; offset: Vec }[];
  cuts: { name: string; section: number; offset: Vec; normal: Vec }[];
  controls: { name: string }[];
  /** At least one; the first is shown at the start. */
  shows: Show[];
}

/**
 * Geometry hangs on sections by offsets in body axes of the undeformed aircraft: it is drawn at p + R·offset in
 * body axes, with p and R the section's present position and rotation (identity where nothing is deformed).
 */
export interface Strip {
  component: string;
  /** From 1, unique over all strips. */
  number: number;
  section: number;
  /** Leading edge inboard, leading edge outboard, trailing edge outboard, trailing edge inboard. */
  corners: [Vec, Vec, Vec, Vec];
  /** Unit vector towards the suction side: upwards of a wing. */
  normal: Vec;
  /** Of the chord. */
  thickness: number;
  flap?: {
    /** Offsets of the hinge, inboard and outboard. */
    hinge: [Vec, Vec];
    /** Unit vector; the right-handed rotation about it is the positive angle. */
    axis: Vec;
    /** The angle is Σ gain · control. */
    controls: { control: number; gain: number }[];
  };
}

export interface Body {
  component: string;
  /** In order along the beam; horizontal and vertical radius. */
  rings: { section: number; offset: Vec; radius: [number, number] }[];
}

export interface Engine {
  name: string;
  section: number;
  offset: Vec;
  /** Of the thrust, unit. */
  direction: Vec;
  /** m */
  size: number;
  /** Thrust that is drawn as an arrow as long as `size`, N. */
  thrustScale: number;
}

export interface Show {
  kind: "flight" | "mode" | "trim" | "root";
  /** Unique, for the menu. */
  name: string;
  /** Of fidelity. */
  level: string;
  /** Label and text: frequency, damping, family, what moves … */
  facts: [string, string][];
  /** Frame i is at start + i·step, s. */
  start: number;
  step: number;
  count: number;
  /** Starts again after the last frame, which equals the first, but for roots: their last moment stands for a while. */
  loops: boolean;
  /** 7 columns a section: position in body axes, quaternion with the scalar first. */
  poses: Matrix;
  /** 7 columns: position of O in earth axes, quaternion that turns body axes into earth axes. */
  body: Matrix;
  /** Angle of each control. */
  controls: Matrix;
  /** Of each engine, N. */
  thrust: Matrix;
  colours: Colour[];
  charts: Chart[];
  /** Velocity of the air at O, earth axes, m/s. */
  wind?: { outputs: Matrix };
  gust?: Gust;
  /** Name of the show that is drawn as a ghost beside this one, at the same times. */
  ghost?: string;
}

/** A gust field that is frozen in the air. */
export interface Gust {
  /** Unit vector in earth axes along which the velocity varies. */
  along: Vec;
  /** Distances along it from where O begins, m. */
  start: number;
  end: number;
  /** Of the velocity, earth axes, unit. */
  direction: Vec;
  /** Velocity at equal distances from start to end, m/s. */
  profile: number[];
  /** Velocity with which the air carries the field over the earth, m/s; at rest where it is missing. */
  drift?: Vec;
  text: string;
}

export interface Chart {
  name: string;
  unit: string;
  label: string;
  /** One column. */
  values: Matrix;
}

export interface Colour {
  name: string;
  label: string;
  unit: string;
  /** What has a column each. */
  on: "strips" | "sections";
  min: number;
  max: number;
  values: Matrix;
}

/**
 * A matrix of low rank: value[row][column] = mean[column] + Σ_r coefficient[row][r] · basis[r][column].
 * Blocks of the data begin at multiples of 4 bytes and are little-endian.
 */
export interface Matrix {
  rows: number;
  columns: number;
  rank: number;
  /** Offset in bytes of `columns` float32. */
  mean: number;
  /** Offset of rank × columns int16, row after row; value = int16 · scale. */
  basis: number;
  basisScale: number[];
  /** Offset of rows × rank int16, row after row. */
  coefficients: number;
  coefficientScale: number[];
}
