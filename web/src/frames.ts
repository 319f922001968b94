/**
 * Frames in which shapes hang: of sections, flaps and arrows. Each is twelve numbers, a matrix R (row after row)
 * and a position p: a point with offset o is drawn at p + R·o, in body axes.
 */

export const FRAME = 12;

/** Writes the rotation of the quaternion at q[from …] (scalar first), its angle times `factor`, to out[at …]. */
export function writeRotation(q: ArrayLike<number>, from: number, factor: number, out: Float64Array, at: number) {
  let x = q[from + 1];
  let y = q[from + 2];
  let z = q[from + 3];
  const vector = Math.sqrt(x * x + y * y + z * z);
  const size = Math.sqrt(q[from] * q[from] + vector * vector);
  let w = q[from] / size;
  let scale = 1 / size;
  if (factor !== 1 && vector > 0) {
    // Of q and −q, the same rotation, the one whose angle is at most π.
    const sign = w < 0 ? -1 : 1;
    const half = factor * Math.atan2(vector, sign * w * size);
    w = Math.cos(half);
    scale = (sign * Math.sin(half)) / vector;
  }
  x *= scale;
  y *= scale;
  z *= scale;
  out[at] = 1 - 2 * (y * y + z * z);
  out[at + 1] = 2 * (x * y - w * z);
  out[at + 2] = 2 * (x * z + w * y);
  out[at + 3] = 2 * (x * y + w * z);
  out[at + 4] = 1 - 2 * (x * x + z * z);
  out[at + 5] = 2 * (y * z - w * x);
  out[at + 6] = 2 * (x * z - w * y);
  out[at + 7] = 2 * (y * z + w * x);
  out[at + 8] = 1 - 2 * (x * x + y * y);
}

/** Writes R·offset + p of the frame at f[from …] to out[at …]. */
export function writePoint(f: Float64Array, from: number, o: ArrayLike<number>, out: Float64Array, at: number) {
  const x = o[0];
  const y = o[1];
  const z = o[2];
  out[at] = f[from] * x + f[from + 1] * y + f[from + 2] * z + f[from + 9];
  out[at + 1] = f[from + 3] * x + f[from + 4] * y + f[from + 5] * z + f[from + 10];
  out[at + 2] = f[from + 6] * x + f[from + 7] * y + f[from + 8] * z + f[from + 11];
}
