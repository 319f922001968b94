/** Vectors of three numbers, for shapes that are built once. */
import type { Vec } from "./scene";

export const add = (a: Vec, b: Vec): Vec => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
export const minus = (a: Vec, b: Vec): Vec => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
export const times = (k: number, a: Vec): Vec => [k * a[0], k * a[1], k * a[2]];
export const dot = (a: Vec, b: Vec): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const length = (a: Vec): number => Math.sqrt(dot(a, a));
/** a + k·b */
export const along = (a: Vec, k: number, b: Vec): Vec => add(a, times(k, b));
/** The point at `share` of the way from a to b. */
export const between = (a: Vec, b: Vec, share: number): Vec => along(a, share, minus(b, a));
export const cross = (a: Vec, b: Vec): Vec => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];

/** The unit vector; `otherwise` where there is none. */
export function unit(a: Vec, otherwise: Vec = [1, 0, 0]): Vec {
  const size = length(a);
  return size > 1e-12 ? times(1 / size, a) : otherwise;
}

/** Some unit vector at right angles to the unit vector `a`, as near to `wish` as it can be. */
export function across(a: Vec, wish: Vec): Vec {
  const rest = along(wish, -dot(a, wish), a);
  if (length(rest) > 1e-3) return unit(rest);
  const other: Vec = Math.abs(a[0]) < 0.9 ? [1, 0, 0] : [0, 1, 0];
  return unit(along(other, -dot(a, other), a));
}
