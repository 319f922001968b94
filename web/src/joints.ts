/** Where strips meet: ends that face another strip with the same flap are hardly seen. */
import type { Strip, Vec } from "./scene";
import { add } from "./vectors";

/** How an end is closed: by a face as it is, by one with few corners that is only seen through a gap, or not at all. */
export type Closing = "whole" | "coarse" | "none";

/** How the inboard and the outboard end of each strip are closed: as `joined` where they meet another strip's. */
export function closings(strips: Strip[], sections: Vec[], joined: Closing): [Closing, Closing][] {
  const ends = strips.map((strip) => {
    const { corners, section, flap } = strip;
    const moved = JSON.stringify(flap?.controls ?? []);
    const end = (...points: Vec[]) => {
      const places = points.flatMap((point) => add(sections[section], point)).map((part) => part.toFixed(3));
      return [...places, moved].join(" ");
    };
    return [end(corners[0], corners[3]), end(corners[1], corners[2])];
  });
  const count = new Map<string, number>();
  for (const end of ends.flat()) count.set(end, (count.get(end) ?? 0) + 1);
  const closing = (end: string) => (count.get(end)! > 1 ? joined : "whole");
  return ends.map(([inboard, outboard]) => [closing(inboard), closing(outboard)]);
}
