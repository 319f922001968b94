/** Strips as slices of an aerofoil, each with its flap if it has one. */
import type { Closing } from "./joints";
import type { Strip, Vec } from "./scene";
import { Shape, Tint, type Hold } from "./shape";
import { add, along, between, dot, minus, times, unit } from "./vectors";

/** Fractions of the chord where the skin has edges: of a strip without flap, of the part before the hinge and of the flap. */
export interface Edges {
  whole: number[];
  front: number[];
  back: number[];
}

/** For aircraft of few strips, which are seen from near. */
export const FINE: Edges = {
  whole: [0, 0.004, 0.015, 0.04, 0.09, 0.16, 0.25, 0.4, 0.6, 0.8, 1],
  front: [0, 0.005, 0.02, 0.05, 0.11, 0.2, 0.3, 0.5, 0.75, 1],
  back: [0, 0.5, 1],
};
/** For those of many: triangles are most of the work where the processor draws. */
export const COARSE: Edges = { whole: [0, 0.02, 0.09, 0.25, 0.6, 1], front: [0, 0.025, 0.11, 0.3, 0.6, 1], back: [0, 1] };
/** Of the span of a strip, left free at both ends, so that one sees where strips meet. */
const SEAM = 0.008;

/** Of these edges the first, the last and the first from here on make a coarse face. */
const THICKEST = 0.25;

/** One end of a strip: where its chord begins, the chord, and the hinge as a fraction of it. */
interface End {
  edge: Vec;
  chord: Vec;
  length: number;
  hinge: number;
  closing: Closing;
}

/** How a strip is drawn: the frame of its flap, how its ends are closed, where its skin has edges. */
export interface Drawing {
  flap: number | undefined;
  closings: [Closing, Closing];
  edges: Edges;
}

export function addStrip(shape: Shape, strip: Strip, owner: number, { flap, closings, edges }: Drawing): void {
  const skin: Hold = { frame: strip.section, owner, tint: Tint.skin };
  const ends = [endOf(strip, SEAM, closings[0]), endOf(strip, 1 - SEAM, closings[1])];
  if (flap === undefined) return addPart(shape, strip, ends, skin, edges.whole, (_, share) => share);
  const moving: Hold = { frame: flap, owner, tint: Tint.flap };
  const isFlapAlone = ends.every((end) => end.hinge < 0.02);
  if (isFlapAlone) return addPart(shape, strip, ends, moving, edges.whole, (_, share) => share);
  addPart(shape, strip, ends, skin, edges.front, (end, share) => share * end.hinge);
  addPart(shape, strip, ends, moving, edges.back, (end, share) => end.hinge + share * (1 - end.hinge));
}

function endOf(strip: Strip, share: number, closing: Closing): End {
  const [leadingIn, leadingOut, trailingOut, trailingIn] = strip.corners;
  const edge = between(leadingIn, leadingOut, share);
  const chord = minus(between(trailingIn, trailingOut, share), edge);
  const length = Math.sqrt(dot(chord, chord)) || 1e-9;
  let hinge = 1;
  if (strip.flap) {
    const point = between(strip.flap.hinge[0], strip.flap.hinge[1], share);
    hinge = Math.min(Math.max(dot(minus(point, edge), chord) / length ** 2, 0), 1);
  }
  return { edge, chord, length, hinge, closing };
}

type Place = (end: End, share: number) => number;

/** Adds the skin between the given shares of a part, and the faces that close it. */
function addPart(shape: Shape, strip: Strip, ends: End[], hold: Hold, shares: number[], place: Place): void {
  const upper = ends.map((end) => shares.map((share) => skinPoint(strip, end, place(end, share), 1)));
  const lower = ends.map((end) => shares.map((share) => skinPoint(strip, end, place(end, share), -1)));
  for (const side of [upper, lower]) {
    const rows = side.map((row) => row.map((point) => shape.vertex(hold, point.offset, point.normal)));
    for (let i = 1; i < shares.length; i++) {
      shape.quad(rows[0][i - 1], rows[1][i - 1], rows[1][i], rows[0][i]);
    }
  }
  const outwards = unit(minus(ends[1].edge, ends[0].edge), [0, 1, 0]);
  const middle = shares.findIndex((share) => share >= THICKEST);
  ends.forEach((end, side) => {
    const { closing } = end;
    if (closing === "none") return;
    const isKept = (_: SkinPoint, i: number) => closing === "whole" || i === 0 || i === middle || i === shares.length - 1;
    const [over, under] = [upper, lower].map((skin) => skin[side].filter(isKept));
    // At the leading edge both skins begin at one point.
    const own = place(end, 0) > 0 ? 0 : 1;
    const around = [...over, ...under.slice(own).reverse()].map((point) => point.offset);
    shape.face(hold, times(side === 0 ? -1 : 1, outwards), around);
  });
  const back = unit(ends[0].chord);
  // The skins of a whole aerofoil meet at both its edges.
  if (place(ends[0], 1) < 1 - 1e-9) closeAt(shape, hold, back, upper, lower, shares.length - 1);
  if (place(ends[0], 0) > 0) closeAt(shape, hold, times(-1, back), upper, lower, 0);
}

interface SkinPoint {
  offset: Vec;
  normal: Vec;
}

function closeAt(shape: Shape, hold: Hold, normal: Vec, upper: SkinPoint[][], lower: SkinPoint[][], i: number) {
  shape.face(hold, normal, [upper[0][i], upper[1][i], lower[1][i], lower[0][i]].map((point) => point.offset));
}

/** The point of the upper (1) or lower (−1) skin at a fraction of the chord, and its normal. */
function skinPoint(strip: Strip, end: End, x: number, side: number): SkinPoint {
  const half = strip.thickness * halfThickness(x);
  const line = along(end.edge, x, end.chord);
  const offset = along(line, side * half * end.length, strip.normal);
  const backwards = times(1 / end.length, end.chord);
  if (x < 1e-6) return { offset, normal: times(-1, backwards) };
  const slope = strip.thickness * thicknessSlope(x);
  return { offset, normal: unit(add(times(side, strip.normal), times(-slope, backwards))) };
}

/** Half the thickness of a NACA four-digit aerofoil with a sharp trailing edge, of its thickness. */
function halfThickness(x: number): number {
  return 5 * (0.2969 * Math.sqrt(x) + x * (-0.126 + x * (-0.3516 + x * (0.2843 - x * 0.1036))));
}

function thicknessSlope(x: number): number {
  return 5 * (0.14845 / Math.sqrt(x) - 0.126 + x * (-0.7032 + x * (0.8529 - x * 0.4144)));
}
