/** Shapes as they are built: vertices that hang in frames, and triangles that look outwards. */
import type { Vec } from "./scene";
import { add, cross, dot, minus } from "./vectors";

/** What a vertex is painted as where no colour is chosen. */
export const Tint = { skin: 0, flap: 1, body: 2, engine: 3, inlet: 4, thrust: 5, station: 6, wind: 7 } as const;
export type Tint = (typeof Tint)[keyof typeof Tint];

export class Shape {
  readonly offsets: number[] = [];
  readonly normals: number[] = [];
  readonly frames: number[] = [];
  /** Of each vertex: the strip, section or station whose value colours it. */
  readonly owners: number[] = [];
  readonly tints: number[] = [];
  readonly triangles: number[] = [];
  /** Where the vertices are on the undeformed aircraft, up to a shift. */
  private readonly rest: Vec[] = [];

  vertex(hold: Hold, offset: Vec, normal: Vec): number {
    this.offsets.push(...offset);
    this.normals.push(...normal);
    this.rest.push(hold.base ? add(hold.base, offset) : offset);
    this.frames.push(hold.frame);
    this.owners.push(hold.owner);
    this.tints.push(hold.tint);
    return this.frames.length - 1;
  }

  /** A triangle whose front is where the normal of its first vertex points. */
  triangle(a: number, b: number, c: number): void {
    const front = cross(minus(this.rest[b], this.rest[a]), minus(this.rest[c], this.rest[a]));
    const normal = this.normals.slice(3 * a, 3 * a + 3) as Vec;
    if (dot(front, normal) < 0) this.triangles.push(a, c, b);
    else this.triangles.push(a, b, c);
  }

  quad(a: number, b: number, c: number, d: number): void {
    this.triangle(a, b, c);
    this.triangle(a, c, d);
  }

  /** A flat face with corners in order around it. */
  face(hold: Hold, normal: Vec, corners: Vec[]): void {
    const vertices = corners.map((corner) => this.vertex(hold, corner, normal));
    for (let i = 2; i < vertices.length; i++) this.triangle(vertices[0], vertices[i - 1], vertices[i]);
  }
}

/** What a vertex hangs in and belongs to. */
export interface Hold {
  frame: number;
  owner: number;
  tint: Tint;
  /** Where the frame begins, for triangles between vertices of different frames. */
  base?: Vec;
}
