/** A gust field along the track: a sheet whose height over the track is the velocity, translucent. */
import {
  BufferGeometry,
  DoubleSide,
  Float32BufferAttribute,
  Group,
  LineBasicMaterial,
  LineSegments,
  Mesh,
  MeshBasicMaterial,
} from "three";
import type { Gust, Vec } from "./scene";
import { across, add, along, cross, dot, times } from "./vectors";

/** Of the size of the aircraft: the largest velocity, and half the width of the sheet. */
const HEIGHT = 0.3;
const HALF_WIDTH = 0.6;
const MOST_POSTS = 120;

export class GustField {
  readonly group = new Group();
  private readonly sheet: MeshBasicMaterial;
  private readonly posts: LineBasicMaterial;

  constructor(gust: Gust, size: number, colour: string) {
    this.sheet = new MeshBasicMaterial({ color: colour, opacity: 0.22, transparent: true, side: DoubleSide, forceSinglePass: true, depthWrite: false });
    this.posts = new LineBasicMaterial({ color: colour, opacity: 0.55, transparent: true });
    const edges = edgesOf(gust, size);
    const sheet = new BufferGeometry();
    sheet.setAttribute("position", new Float32BufferAttribute(edges.flatMap(({ top }) => top.flat()), 3));
    sheet.setIndex(edges.slice(1).flatMap((_, i) => [2 * i, 2 * i + 1, 2 * i + 3, 2 * i, 2 * i + 3, 2 * i + 2]));
    const lines = new BufferGeometry();
    lines.setAttribute("position", new Float32BufferAttribute(postsOf(edges).flat(), 3));
    this.group.add(new Mesh(sheet, this.sheet), new LineSegments(lines, this.posts));
    for (const part of this.group.children) part.frustumCulled = false;
  }

  setColour(colour: string): void {
    this.sheet.color.set(colour);
    this.posts.color.set(colour);
  }

  dispose(): void {
    for (const part of this.group.children) (part as Mesh).geometry.dispose();
    this.sheet.dispose();
    this.posts.dispose();
  }
}

/** At one distance along the field: its two ends on the track, and above them those on the sheet. */
interface Edge {
  foot: [Vec, Vec];
  top: [Vec, Vec];
}

function edgesOf(gust: Gust, size: number): Edge[] {
  const { profile, start, end } = gust;
  // A gust along the track is drawn upwards.
  const isAlong = Math.abs(dot(gust.along, gust.direction)) > 0.9;
  const rise = isAlong ? across(gust.along, [0, 0, -1]) : gust.direction;
  const side = cross(across(rise, gust.along), rise);
  const most = profile.reduce((most, velocity) => Math.max(most, Math.abs(velocity)), 1e-9);
  return profile.map((velocity, i) => {
    const distance = start + ((end - start) * i) / Math.max(profile.length - 1, 1);
    const centre = times(distance, gust.along);
    const foot: [Vec, Vec] = [along(centre, -HALF_WIDTH * size, side), along(centre, HALF_WIDTH * size, side)];
    const up = times((HEIGHT * size * velocity) / most, rise);
    return { foot, top: [add(foot[0], up), add(foot[1], up)] };
  });
}

/** Lines from the track to the sheet, along both edges of the sheet and along the track. */
function postsOf(edges: Edge[]): Vec[] {
  const every = Math.ceil(edges.length / MOST_POSTS);
  const kept = edges.filter((_, i) => i % every === 0 || i === edges.length - 1);
  const posts = kept.flatMap(({ foot, top }) => [foot[0], top[0], foot[1], top[1]]);
  const borders = edges.slice(1).flatMap(({ foot, top }, i) => {
    const before = edges[i];
    return [before.foot[0], foot[0], before.foot[1], foot[1], before.top[0], top[0], before.top[1], top[1]];
  });
  const ends = [edges[0], edges[edges.length - 1]].flatMap(({ foot, top }) => [...foot, ...top]);
  return [...posts, ...borders, ...ends];
}
