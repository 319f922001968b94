/** Bodies, lofted from their rings. */
import type { Body, Vec } from "./scene";
import { Shape, Tint } from "./shape";
import { across, add, along, cross, length, minus, times, unit } from "./vectors";

const AROUND = 24;

export function addBody(shape: Shape, body: Body, sections: Vec[]): void {
  const centres = body.rings.map((ring) => add(sections[ring.section], ring.offset));
  const rings = body.rings.map((_, i) => addRing(shape, body, sections, centres, i));
  for (let i = 1; i < rings.length; i++) {
    for (let k = 0; k < AROUND; k++) {
      shape.quad(rings[i - 1][k], rings[i - 1][k + 1], rings[i][k + 1], rings[i][k]);
    }
  }
  const last = rings.length - 1;
  if (last < 1) return;
  close(shape, body, rings[0], 0, unit(minus(centres[0], centres[1])));
  close(shape, body, rings[last], last, unit(minus(centres[last], centres[last - 1])));
}

/** Adds the vertices around a ring, the first again at the end. */
function addRing(shape: Shape, body: Body, sections: Vec[], centres: Vec[], i: number): number[] {
  const before = Math.max(i - 1, 0);
  const after = Math.min(i + 1, centres.length - 1);
  const step = minus(centres[after], centres[before]);
  const beam = unit(step);
  const vertical = across(beam, [0, 0, 1]);
  const horizontal = cross(vertical, beam);
  const mean = (ring: number) => (body.rings[ring].radius[0] + body.rings[ring].radius[1]) / 2;
  const slope = (mean(after) - mean(before)) / (length(step) || 1);
  const { section, offset, radius } = body.rings[i];
  const hold = { frame: section, owner: section, tint: Tint.body, base: sections[section] };
  return Array.from({ length: AROUND + 1 }, (_, k) => {
    const angle = (2 * Math.PI * (k % AROUND)) / AROUND;
    const [c, s] = [Math.cos(angle), Math.sin(angle)];
    const out = add(times(c * radius[0], horizontal), times(s * radius[1], vertical));
    const isPoint = radius[0] === 0 || radius[1] === 0;
    const [a, b] = isPoint ? [1, 1] : [radius[1], radius[0]];
    const round = unit(add(times(c * a, horizontal), times(s * b, vertical)));
    return shape.vertex(hold, add(offset, out), unit(along(round, -slope, beam)));
  });
}

function close(shape: Shape, body: Body, ring: number[], i: number, outwards: Vec): void {
  const { section } = body.rings[i];
  const corners = ring.slice(0, AROUND).map((v) => shape.offsets.slice(3 * v, 3 * v + 3) as Vec);
  shape.face({ frame: section, owner: section, tint: Tint.body }, outwards, corners);
}

