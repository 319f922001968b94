/** Frames that move against their section: flaps about their hinge, arrows with what they show. */
import { FRAME, writePoint } from "./frames";
import type { Engine, Strip, Vec } from "./scene";

const turn = new Float64Array(9);
const point = new Float64Array(3);

/** Writes the frame of a flap: R F, and the position that leaves the hinge where it is. */
export function writeFlap(strip: Strip, controls: Float64Array, f: Float64Array, to: number): void {
  const { hinge, axis, controls: gains } = strip.flap!;
  let angle = 0;
  for (let i = 0; i < gains.length; i++) angle += gains[i].gain * controls[gains[i].control];
  writeTurn(axis, angle, turn);
  const section = FRAME * strip.section;
  multiply(f, section, turn, f, to);
  const a = hinge[0];
  writePoint(f, section, a, point, 0);
  for (let i = 0; i < 3; i++) {
    const k = to + 3 * i;
    f[to + 9 + i] = point[i] - (f[k] * a[0] + f[k + 1] * a[1] + f[k + 2] * a[2]);
  }
}

/** Writes the frames of the shaft and the head of an engine's arrow. */
export function writeArrow(engine: Engine, thrust: number, f: Float64Array, to: number): void {
  const long = (thrust / engine.thrustScale) * engine.size;
  const isSeen = Math.abs(long) > 1e-3 * engine.size;
  const section = FRAME * engine.section;
  writeAlong(engine.direction, thrust < 0 ? -1 : 1, turn);
  for (const at of [to, to + FRAME]) multiply(f, section, turn, f, at);
  writePoint(f, section, engine.offset, point, 0);
  const half = 0.5 * engine.size;
  for (let i = 0; i < 3; i++) {
    const forwards = f[to + 3 * i];
    f[to + 9 + i] = point[i] + half * forwards;
    f[to + FRAME + 9 + i] = f[to + 9 + i] + Math.abs(long) * forwards;
    f[to + 3 * i] *= Math.abs(long);
  }
  if (!isSeen) hide(f, to);
}

function hide(f: Float64Array, to: number): void {
  for (let i = 0; i < 9; i++) f[to + i] = f[to + FRAME + i] = 0;
}

/** The rotation by an angle about a unit axis (Rodrigues). */
function writeTurn(axis: Vec, angle: number, out: Float64Array): void {
  const c = Math.cos(angle);
  const s = Math.sin(angle);
  const x = axis[0];
  const y = axis[1];
  const z = axis[2];
  out[0] = c + (1 - c) * x * x;
  out[1] = (1 - c) * x * y - s * z;
  out[2] = (1 - c) * x * z + s * y;
  out[3] = (1 - c) * x * y + s * z;
  out[4] = c + (1 - c) * y * y;
  out[5] = (1 - c) * y * z - s * x;
  out[6] = (1 - c) * x * z - s * y;
  out[7] = (1 - c) * y * z + s * x;
  out[8] = c + (1 - c) * z * z;
}

/** A rotation whose first column is `sign` times a unit vector. */
export function writeAlong(direction: ArrayLike<number>, sign: number, out: Float64Array): void {
  const x = sign * direction[0];
  const y = sign * direction[1];
  const z = sign * direction[2];
  // Second column: at right angles to the first, in the plane of the two axes it is least along.
  const flat = Math.abs(z) < 0.9;
  const a = flat ? -y : 0;
  const b = flat ? x : -z;
  const c = flat ? 0 : y;
  const size = Math.sqrt(a * a + b * b + c * c);
  out[0] = x;
  out[3] = y;
  out[6] = z;
  out[1] = a / size;
  out[4] = b / size;
  out[7] = c / size;
  out[2] = (y * c - z * b) / size;
  out[5] = (z * a - x * c) / size;
  out[8] = (x * b - y * a) / size;
}

/** Writes the product of two 3 × 3 matrices, the first at f[from …], to out[to …]. */
function multiply(f: Float64Array, from: number, m: Float64Array, out: Float64Array, to: number): void {
  for (let i = 0; i < 3; i++) {
    const k = from + 3 * i;
    for (let j = 0; j < 3; j++) out[to + 3 * i + j] = f[k] * m[j] + f[k + 1] * m[3 + j] + f[k + 2] * m[6 + j];
  }
}
