/** Numbers for people. */

const MINUS = "\u2212";
const THIN_SPACE = "\u202f";

/** Four significant digits, thousands apart. */
export function number(value: number): string {
  if (!Number.isFinite(value)) return "–";
  const size = Math.abs(value);
  if (size === 0) return "0";
  if (size >= 1e7 || size < 1e-4) return value.toExponential(2).replaceAll("-", MINUS);
  const decimals = Math.min(Math.max(3 - Math.floor(Math.log10(size)), 0), 7);
  return fixed(value, decimals);
}

/** A fixed number of decimals, thousands apart. */
export function fixed(value: number, decimals: number): string {
  const [whole, rest] = Math.abs(value).toFixed(decimals).split(".");
  const apart = whole.length > 4 ? whole.replace(/\B(?=(\d{3})+$)/g, THIN_SPACE) : whole;
  const text = rest === undefined ? apart : `${apart}.${rest}`;
  return value < 0 && Number(text.replaceAll(THIN_SPACE, "")) !== 0 ? MINUS + text : text;
}

/** A value with its unit, as `kg.m2` or `N.m` that variables have. */
export function withUnit(value: number, unit: string): string {
  const text = unitText(unit);
  return text === "" ? number(value) : `${number(value)} ${text}`;
}

export function unitText(unit: string): string {
  if (unit === "1") return "";
  return unit.replaceAll(".", "·").replace(/([a-z])2/gi, "$1²").replace(/([a-z])3/gi, "$1³");
}

/** Round values from low to high, at most `most` of them. */
export function ticks(low: number, high: number, most: number): number[] {
  const raw = (high - low) / Math.max(most - 1, 1);
  if (!(raw > 0)) return [low];
  const power = 10 ** Math.floor(Math.log10(raw));
  const step = [1, 2, 2.5, 5, 10].map((factor) => factor * power).find((one) => one >= raw * 0.999) ?? 10 * power;
  const first = Math.ceil(low / step - 1e-9);
  const last = Math.floor(high / step + 1e-9);
  return Array.from({ length: last - first + 1 }, (_, i) => (first + i) * step);
}

/** A tick without trailing zeros. */
export function tickText(value: number): string {
  const size = Math.abs(value);
  if (size >= 1e6 || (size > 0 && size < 1e-3)) {
    return value.toExponential(1).replace(".0e", "e").replace("e+", "e").replaceAll("-", MINUS);
  }
  return fixed(value, 6).replace(/\.?0+$/, "");
}

/** A number beside an axis, in little room. */
export function axisText(value: number): string {
  const size = Math.abs(value);
  const [power, letter] = size >= 1e9 ? [1e9, " G"] : size >= 1e6 ? [1e6, " M"] : size >= 1e4 ? [1e3, " k"] : [1, ""];
  return `${+(value / power).toPrecision(4)}${letter}`.replaceAll("-", MINUS);
}
