/** Charts of outputs over time: linked, with a line at the present moment; a click or drag in one seeks. */
import uPlot from "uplot";
import { make, say } from "./elements";
import { axisText, fixed, number, withUnit } from "./numbers";
import type { Chart } from "./scene";
import { themes } from "./theme";
import type { Viewer } from "./viewer";

const HEIGHT = 115;
/** Beside the plotting area, pixels. */
const LEFT = 58;
const RIGHT = 8;

interface Drawn {
  chart: Chart;
  values: Float64Array;
  plot: uPlot;
  now: HTMLElement;
  there: HTMLElement;
}

export class Charts {
  private drawn: Drawn[] = [];
  private times = new Float64Array(0);
  private made = "";
  /** Of the present moment, through all charts: one line costs a browser less than one in each. */
  private readonly line = make("i");
  private width = 0;

  constructor(
    private readonly holder: HTMLElement,
    private readonly viewer: Viewer,
  ) {
    this.line.className = "now";
    new ResizeObserver(() => this.resize()).observe(holder);
  }

  /** Makes the charts of the present show in the present theme. */
  refresh(): void {
    const { motion, theme } = this.viewer;
    const wanted = `${motion.show.name}\n${theme}`;
    if (wanted === this.made) return;
    this.made = wanted;
    for (const { plot } of this.drawn) plot.destroy();
    this.line.hidden = motion.show.count < 2 || motion.show.charts.length === 0;
    this.holder.replaceChildren(this.line);
    const { start, step, count } = motion.show;
    this.times = Float64Array.from({ length: count }, (_, i) => start + i * step);
    this.drawn = count < 2 ? [] : motion.show.charts.map((chart) => this.draw(chart));
  }

  /** Moves the line of the present moment; done in every frame. */
  place(): void {
    const { motion, clock } = this.viewer;
    const share = (clock.time - motion.show.start) / (motion.end - motion.show.start || 1);
    const width = this.width - LEFT - RIGHT;
    this.line.style.transform = `translateX(${LEFT + share * width}px)`;
  }

  /** Says the values of the present moment. */
  tell(): void {
    const frame = this.viewer.frame;
    for (const { values, now, chart } of this.drawn) {
      const before = Math.floor(frame);
      const after = Math.min(before + 1, values.length - 1);
      const value = values[before] + (frame - before) * (values[after] - values[before]);
      say(now, withUnit(value, chart.unit));
    }
  }

  private resize(): void {
    const width = (this.width = this.holder.clientWidth);
    if (width > 0) for (const { plot } of this.drawn) plot.setSize({ width, height: HEIGHT });
    this.place();
  }

  private draw(chart: Chart): Drawn {
    const values = this.viewer.motion.seriesOf(chart);
    const box = make("div");
    box.className = "chart";
    const head = make("div");
    head.className = "chart-head";
    const name = make("b", chart.label || chart.name);
    name.title = chart.name;
    const there = make("output");
    there.className = "there";
    const now = make("output");
    head.append(name, there, now);
    box.append(head);
    this.holder.append(box);
    const plot = new uPlot(this.options(values, there), [this.times, values], box);
    this.seekByPointer(plot);
    return { chart, values, plot, now, there };
  }

  private options(values: Float64Array, there: HTMLElement): uPlot.Options {
    const { axis, grid, curve } = themes[this.viewer.theme];
    const lines = { stroke: axis, grid: { stroke: grid, width: 1 }, ticks: { show: false }, font: "11px system-ui, sans-serif" };
    return {
      width: Math.max(this.width, 100),
      height: HEIGHT,
      padding: [6, RIGHT, 0, 0],
      legend: { show: false },
      cursor: { drag: { setScale: false, x: false, y: false }, sync: { key: "flexair" }, y: false, points: { size: 6 } },
      scales: { x: { time: false, range: (_, low, high) => [low, high] }, y: { range: (_, low, high) => rangeAround(low, high) } },
      series: [{}, { stroke: curve, width: 1.3, pxAlign: 0, points: { show: false } }],
      axes: [
        { ...lines, size: 25, space: 50, gap: 5 },
        { ...lines, size: LEFT, space: 22, gap: 3, values: (_, splits) => splits.map(axisText) },
      ],
      hooks: { setCursor: [(plot) => this.tellThere(plot, values, there)] },
    };
  }

  /** Says time and value under the pointer, in each chart. */
  private tellThere(plot: uPlot, values: Float64Array, there: HTMLElement): void {
    const at = plot.cursor.idx;
    const isOver = at !== null && at !== undefined && (plot.cursor.left ?? -1) >= 0;
    say(there, isOver ? `${fixed(this.times[at], 2)} s: ${number(values[at])}` : "");
  }

  private seekByPointer(plot: uPlot): void {
    const seek = (event: PointerEvent) => {
      const box = plot.over.getBoundingClientRect();
      const { motion } = this.viewer;
      const share = (event.clientX - box.left) / box.width;
      this.viewer.seek(motion.show.start + share * (motion.end - motion.show.start));
    };
    plot.over.addEventListener("pointerdown", (event) => {
      if (event.button !== 0) return;
      plot.over.setPointerCapture(event.pointerId);
      seek(event);
    });
    plot.over.addEventListener("pointermove", (event) => {
      if (plot.over.hasPointerCapture(event.pointerId)) seek(event);
    });
  }
}

/** A range with some room; where nothing changes, around the value. */
function rangeAround(low: number, high: number): uPlot.Range.MinMax {
  if (low < high) return uPlot.rangeNum(low, high, 0.1, true);
  const room = Math.abs(low) || 1;
  return [low - room, low + room];
}
