/** Strips across a body, which stand for the air about it: the body is drawn in their place, and shows what they carry. */
import type { Scene } from "./scene";

/** Whether each strip lies in a body. */
export function stripsInBodies({ strips, bodies }: Scene): boolean[] {
  const names = new Set(bodies.map(({ component }) => component));
  return strips.map(({ component }) => names.has(component));
}

/** Of each section that has a ring of a body, the nearest level strip in that body; −1 of all others. */
export function stripsOfSections({ sections, strips, bodies }: Scene): Int32Array {
  const nearest = new Int32Array(sections.length).fill(-1);
  for (const { component, rings } of bodies) {
    const across = strips.flatMap((strip, i) => (strip.component === component && Math.abs(strip.normal[2]) > 0.7 ? [i] : []));
    for (const { section } of rings) {
      const distance = (strip: number) => Math.hypot(...sections[strips[strip].section].map((part, k) => part - sections[section][k]));
      nearest[section] = across.reduce((best, strip) => (best < 0 || distance(strip) < distance(best) ? strip : best), -1);
    }
  }
  return nearest;
}
