/** Colours of the scene in light and dark; those of the page around it are in style.css. */
import { Tint } from "./shape";

export type ThemeName = "light" | "dark";

export interface Theme {
  zenith: string;
  sky: string;
  horizon: string;
  ground: string;
  line: string;
  tints: Record<keyof typeof Tint, string>;
  ghost: string;
  gust: string;
  text: string;
  axis: string;
  grid: string;
  curve: string;
}

export const themes: Record<ThemeName, Theme> = {
  light: {
    zenith: "#6fa3d4",
    sky: "#b5d0e8",
    horizon: "#e3ebf1",
    ground: "#c6cfc8",
    line: "#7d8b82",
    tints: {
      skin: "#e6eaee",
      flap: "#93b2cf",
      body: "#f4f5f6",
      engine: "#aab4be",
      inlet: "#39424c",
      thrust: "#e07b1a",
      station: "#c2185b",
      wind: "#1976d2",
    },
    ghost: "#5b4bb5",
    gust: "#1669b8",
    text: "#1c242c",
    axis: "#53606c",
    grid: "#00000014",
    curve: "#0b62a8",
  },
  dark: {
    zenith: "#0b1420",
    sky: "#16263a",
    horizon: "#2a3d52",
    ground: "#151c22",
    line: "#3f5260",
    tints: {
      skin: "#b9c4cf",
      flap: "#7f9bb5",
      body: "#c9d0d7",
      engine: "#7c8894",
      inlet: "#14181c",
      thrust: "#ff9a3d",
      station: "#ff5c97",
      wind: "#5ab0ff",
    },
    ghost: "#a99bff",
    gust: "#6cb8ff",
    text: "#e4eaf0",
    axis: "#9fb0bf",
    grid: "#ffffff16",
    curve: "#6cb8ff",
  },
};

/** The bytes red, green, blue, 255 of `#rrggbb`, as they lie in memory. */
export function packed(colour: string, shade = 1): number {
  const part = (at: number) => Math.round(parseInt(colour.slice(at, at + 2), 16) * shade);
  return ((255 << 24) | (part(5) << 16) | (part(3) << 8) | part(1)) >>> 0;
}

export function packedTints(theme: Theme): Uint32Array {
  const names = Object.keys(Tint) as (keyof typeof Tint)[];
  const out = new Uint32Array(names.length);
  for (const name of names) out[Tint[name]] = packed(theme.tints[name]);
  return out;
}
