/** The scale of colours: which colour a value has. */
import type { Colour } from "./scene";
import { packed } from "./theme";

/** From low to high; viridis. */
const ONE_WAY = ["#440154", "#472d7b", "#3b528b", "#2c728e", "#21918c", "#28ae80", "#5ec962", "#addc30", "#fde725"];
/** From negative through nothing to positive. */
const TWO_WAYS = ["#17468f", "#3a80bd", "#86b9db", "#d9e4ec", "#f3f1ec", "#f6d9c2", "#e9946c", "#cc4a3a", "#8c1029"];
const STEPS = 256;

export class Scale {
  readonly low: number;
  readonly high: number;
  readonly colours: string[];
  private readonly table: Uint32Array;

  /** Values of both signs get a scale in two ways whose middle is 0. */
  constructor(colour: Colour) {
    const isTwoWays = colour.min < 0 && colour.max > 0;
    const bound = Math.max(-colour.min, colour.max);
    this.low = isTwoWays ? -bound : colour.min;
    this.high = isTwoWays ? bound : Math.max(colour.max, colour.min + Number.MIN_VALUE);
    if (this.high === this.low) this.high = this.low + 1;
    this.colours = isTwoWays ? TWO_WAYS : ONE_WAY;
    this.table = Uint32Array.from({ length: STEPS }, (_, i) => packed(blend(this.colours, i / (STEPS - 1))));
  }

  /** The packed colour of a value. */
  of(value: number): number {
    const share = (value - this.low) / (this.high - this.low);
    const step = Math.round(share * (STEPS - 1));
    return this.table[Math.min(Math.max(step, 0), STEPS - 1)];
  }
}

function blend(colours: string[], share: number): string {
  const at = share * (colours.length - 1);
  const i = Math.min(Math.floor(at), colours.length - 2);
  const part = (from: number) => {
    const [a, b] = [i, i + 1].map((k) => parseInt(colours[k].slice(from, from + 2), 16));
    return Math.round(a + (at - i) * (b - a))
      .toString(16)
      .padStart(2, "0");
  };
  return `#${part(1)}${part(3)}${part(5)}`;
}
