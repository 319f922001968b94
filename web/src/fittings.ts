/** Engines, arrows, markers of stations and cut sections. */
import type { Engine, Vec } from "./scene";
import { Shape, Tint, type Hold } from "./shape";
import { across, add, along, cross, times, unit } from "./vectors";

const AROUND = 20;

/** Radius of a nacelle along it, from its inlet: [share of its length, share of its length as radius]. */
const NACELLE: [number, number][] = [
  [0, 0.2],
  [0.03, 0.225],
  [0.12, 0.25],
  [0.35, 0.26],
  [0.7, 0.22],
  [1, 0.14],
];

export function addEngine(shape: Shape, engine: Engine, owner: number): void {
  const hold: Hold = { frame: engine.section, owner, tint: Tint.engine };
  const front = along(engine.offset, engine.size / 2, engine.direction);
  addTurned(shape, hold, front, times(-1, engine.direction), engine.size, NACELLE);
  const rim = circle(front, engine.direction, 0.2 * engine.size);
  shape.face({ ...hold, tint: Tint.inlet }, engine.direction, rim);
  const exit = circle(along(engine.offset, -engine.size / 2, engine.direction), engine.direction, 0.14 * engine.size);
  shape.face({ ...hold, tint: Tint.inlet }, times(-1, engine.direction), exit);
}

/** An arrow along x: a shaft of length 1 in the first frame, a head in the second; `width` is the head's, m. */
export function addArrow(shape: Shape, shaft: Hold, head: Hold, width: number): void {
  const x: Vec = [1, 0, 0];
  addTurned(shape, shaft, [0, 0, 0], x, 1, [
    [0, 0.18 * width],
    [1, 0.18 * width],
  ]);
  addTurned(shape, head, [0, 0, 0], x, 1.4 * width, [
    [0, 0.5 / 1.4],
    [1, 0],
  ]);
  shape.face(head, [-1, 0, 0], circle([0, 0, 0], x, 0.5 * width));
}

/** A small octahedron. */
export function addMarker(shape: Shape, hold: Hold, centre: Vec, radius: number): void {
  for (const sx of [1, -1]) {
    for (const sy of [1, -1]) {
      for (const sz of [1, -1]) {
        const tips: Vec[] = [
          [sx * radius, 0, 0],
          [0, sy * radius, 0],
          [0, 0, sz * radius],
        ];
        const corners = tips.map((tip) => add(centre, tip));
        shape.face(hold, unit([sx, sy, sz]), corners);
      }
    }
  }
}

/** A ring around a cut section. */
export function addCut(shape: Shape, hold: Hold, centre: Vec, normal: Vec, radius: number): void {
  const outer = circle(centre, normal, radius).map((point) => shape.vertex(hold, point, normal));
  const inner = circle(centre, normal, 0.86 * radius).map((point) => shape.vertex(hold, point, normal));
  for (let k = 0; k < AROUND; k++) {
    const next = (k + 1) % AROUND;
    shape.quad(outer[k], outer[next], inner[next], inner[k]);
  }
}

/** A surface of revolution about `axis` from `start`: [share of the length, radius as a share of it] along it. */
function addTurned(shape: Shape, hold: Hold, start: Vec, axis: Vec, long: number, profile: [number, number][]) {
  const rows = profile.map(([share, radius], i) => {
    const [before, after] = [profile[Math.max(i - 1, 0)], profile[Math.min(i + 1, profile.length - 1)]];
    const slope = (after[1] - before[1]) / (after[0] - before[0]);
    const centre = along(start, share * long, axis);
    return directions(axis).map((out) => {
      return shape.vertex(hold, along(centre, radius * long, out), unit(along(out, -slope, axis)));
    });
  });
  for (let i = 1; i < rows.length; i++) {
    for (let k = 0; k < AROUND; k++) {
      const next = (k + 1) % AROUND;
      shape.quad(rows[i - 1][k], rows[i - 1][next], rows[i][next], rows[i][k]);
    }
  }
}

function circle(centre: Vec, axis: Vec, radius: number): Vec[] {
  return directions(axis).map((out) => along(centre, radius, out));
}

/** Unit vectors at right angles to `axis`, around it. */
function directions(axis: Vec): Vec[] {
  const first = across(axis, [0, 0, 1]);
  const second = cross(axis, first);
  return Array.from({ length: AROUND }, (_, k) => {
    const angle = (2 * Math.PI * k) / AROUND;
    return add(times(Math.cos(angle), first), times(Math.sin(angle), second));
  });
}
