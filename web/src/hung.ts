/** A mesh whose vertices hang in frames: one geometry for many shapes, updated in place. */
import { BufferAttribute, BufferGeometry, DynamicDrawUsage, Mesh, Sphere, Vector3, type Material } from "three";
import { FRAME } from "./frames";
import type { Shape } from "./shape";

export class HungMesh {
  readonly mesh: Mesh;
  readonly owners: Uint32Array;
  private readonly offsets: Float32Array;
  private readonly normals: Float32Array;
  /** Where the frame of each vertex begins. */
  private readonly frames: Uint32Array;
  private readonly tints: Uint8Array;
  private readonly drawnAt: BufferAttribute;
  private readonly drawnNormals: BufferAttribute;
  private readonly drawnColours: BufferAttribute;
  /** The colours, four bytes at a time. */
  private readonly paint: Uint32Array;

  constructor(shape: Shape, material: Material, reach: number) {
    const count = shape.frames.length;
    this.offsets = Float32Array.from(shape.offsets);
    this.normals = Float32Array.from(shape.normals);
    this.frames = Uint32Array.from(shape.frames, (frame) => frame * FRAME);
    this.owners = Uint32Array.from(shape.owners);
    this.tints = Uint8Array.from(shape.tints);
    this.paint = new Uint32Array(count);
    this.drawnAt = new BufferAttribute(new Float32Array(3 * count), 3).setUsage(DynamicDrawUsage);
    this.drawnNormals = new BufferAttribute(new Float32Array(3 * count), 3).setUsage(DynamicDrawUsage);
    const bytes = new Uint8Array(this.paint.buffer);
    this.drawnColours = new BufferAttribute(bytes, 4, true).setUsage(DynamicDrawUsage);
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", this.drawnAt);
    geometry.setAttribute("normal", this.drawnNormals);
    geometry.setAttribute("color", this.drawnColours);
    geometry.setIndex(shape.triangles);
    // Where vertices will be is not known beforehand: for rays, a sphere around all that is likely.
    geometry.boundingSphere = new Sphere(new Vector3(), reach);
    this.mesh = new Mesh(geometry, material);
    this.mesh.frustumCulled = false;
  }

  /** Moves the vertices to where their frames are. */
  move(f: Float64Array): void {
    const at = this.drawnAt.array;
    const normal = this.drawnNormals.array;
    const { offsets: o, normals: n, frames } = this;
    for (let v = 0, i = 0; v < frames.length; v++, i += 3) {
      const k = frames[v];
      const x = o[i];
      const y = o[i + 1];
      const z = o[i + 2];
      at[i] = f[k] * x + f[k + 1] * y + f[k + 2] * z + f[k + 9];
      at[i + 1] = f[k + 3] * x + f[k + 4] * y + f[k + 5] * z + f[k + 10];
      at[i + 2] = f[k + 6] * x + f[k + 7] * y + f[k + 8] * z + f[k + 11];
      const a = n[i];
      const b = n[i + 1];
      const c = n[i + 2];
      normal[i] = f[k] * a + f[k + 1] * b + f[k + 2] * c;
      normal[i + 1] = f[k + 3] * a + f[k + 4] * b + f[k + 5] * c;
      normal[i + 2] = f[k + 6] * a + f[k + 7] * b + f[k + 8] * c;
    }
    this.drawnAt.needsUpdate = true;
    this.drawnNormals.needsUpdate = true;
  }

  /** Paints each vertex with the colour of its tint. */
  paintPlain(colourOfTint: Uint32Array): void {
    for (let v = 0; v < this.paint.length; v++) this.paint[v] = colourOfTint[this.tints[v]];
    this.drawnColours.needsUpdate = true;
  }

  /** Paints each vertex with the colour of its owner. */
  paintOwners(colourOfOwner: Uint32Array): void {
    for (let v = 0; v < this.paint.length; v++) this.paint[v] = colourOfOwner[this.owners[v]];
    this.drawnColours.needsUpdate = true;
  }

  /** The owner of a triangle that a ray hit. */
  ownerOfFace(face: number): number {
    return this.owners[this.mesh.geometry.index!.getX(3 * face)];
  }
}
