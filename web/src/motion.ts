/** A show opened for drawing: its tables, and where its heading points over time. */
import type { Chart, Scene, Show, Vec } from "./scene";
import { Scale } from "./scale";
import { Table } from "./table";

/** Frames that say how much room a show takes. */
const LOOKED_AT = 17;

export class Motion {
  readonly show: Show;
  readonly poses: Table;
  readonly body: Table;
  readonly controls: Table;
  readonly thrust: Table;
  readonly colours: Table[];
  readonly scales: Scale[];
  readonly wind: Table | undefined;
  /** Of each frame, rad from north, smoothed so that a camera that follows it is calm. */
  private readonly headings: Float64Array;
  /** How deep the plane of the grid lies, earth axes, m. */
  readonly ground: number;
  private readonly place = new Float64Array(7);

  constructor(
    show: Show,
    private readonly data: ArrayBuffer,
    size: number,
  ) {
    this.show = show;
    this.poses = new Table(show.poses, data);
    this.body = new Table(show.body, data);
    this.controls = new Table(show.controls, data);
    this.thrust = new Table(show.thrust, data);
    this.colours = show.colours.map((colour) => new Table(colour.values, data));
    this.scales = show.colours.map((colour) => new Scale(colour));
    this.wind = show.wind && new Table(show.wind.outputs, data);
    this.headings = this.smoothHeadings();
    this.ground = this.planeBelow(size);
  }

  get end(): number {
    return this.show.start + (this.show.count - 1) * this.show.step;
  }

  /** Whether it repeats without a jump; a root in flight decays or grows. */
  get isPeriodic(): boolean {
    return this.show.loops && this.show.kind !== "root" && this.end > this.show.start;
  }

  /** The frame at a time, with a fraction between frames. */
  frameAt(time: number): number {
    if (this.show.count < 2) return 0;
    const frame = (time - this.show.start) / this.show.step;
    const nearest = Math.round(frame);
    const isStored = Math.abs(frame - nearest) < 1e-6;
    return Math.min(Math.max(isStored ? nearest : frame, 0), this.show.count - 1);
  }

  /** Corners of a box around all sections, body axes, at some frames of the show. */
  box(): [Vec, Vec] {
    const low: Vec = [Infinity, Infinity, Infinity];
    const high: Vec = [-Infinity, -Infinity, -Infinity];
    const row = new Float64Array(this.poses.columns);
    for (let k = 0; k < LOOKED_AT; k++) {
      this.poses.row(Math.round((k * (this.show.count - 1)) / (LOOKED_AT - 1)), row);
      for (let i = 0; i < row.length; i += 7) {
        for (let axis = 0; axis < 3; axis++) {
          low[axis] = Math.min(low[axis], row[i + axis]);
          high[axis] = Math.max(high[axis], row[i + axis]);
        }
      }
    }
    return [low, high];
  }

  /** All values of a chart, one a frame. */
  seriesOf(chart: Chart): Float64Array {
    return new Table(chart.values, this.data).series();
  }

  headingAt(frame: number): number {
    const before = Math.floor(frame);
    const after = Math.min(before + 1, this.headings.length - 1);
    return this.headings[before] + (frame - before) * (this.headings[after] - this.headings[before]);
  }

  /**
   * The earth (0) where the flight comes near it. Else a plane of its own under the lowest point: from the height of
   * airliners one sees no motion over the earth.
   */
  private planeBelow(size: number): number {
    let lowest = -Infinity;
    for (let i = 0; i < this.show.count; i++) {
      this.body.row(i, this.place);
      lowest = Math.max(lowest, this.place[2]);
    }
    const plane = Math.ceil(lowest + 0.7 * size);
    return lowest <= 0 && plane > -size ? 0 : plane;
  }

  /** Means over two seconds to both sides of where the nose points; over all frames where the show repeats. */
  private smoothHeadings(): Float64Array {
    const { count, step, loops } = this.show;
    const raw = new Float64Array(count);
    for (let i = 0; i < count; i++) {
      this.body.row(i, this.place);
      const [, , , w, x, y, z] = this.place;
      const turn = Math.atan2(2 * (x * y + w * z), 1 - 2 * (y * y + z * z));
      const jump = i > 0 ? Math.round((raw[i - 1] - turn) / (2 * Math.PI)) : 0;
      raw[i] = turn + 2 * Math.PI * jump;
    }
    const sums = new Float64Array(count + 1);
    for (let i = 0; i < count; i++) sums[i + 1] = sums[i] + raw[i];
    const reach = loops || step <= 0 ? count : Math.ceil(2 / step);
    return raw.map((_, i) => {
      const from = Math.max(i - reach, 0);
      const to = Math.min(i + reach + 1, count);
      return (sums[to] - sums[from]) / (to - from);
    });
  }
}

/** The shows of a scene, each opened when it is first wanted. */
export class Motions {
  private readonly open = new Map<string, Motion>();

  constructor(
    private readonly scene: Scene,
    private readonly data: ArrayBuffer,
  ) {}

  of(name: string): Motion | undefined {
    const show = this.scene.shows.find((one) => one.name === name);
    if (!show) return undefined;
    const known = this.open.get(name);
    if (known) return known;
    const motion = new Motion(show, this.data, this.scene.size);
    this.open.set(name, motion);
    return motion;
  }
}
