/** An arrow above the aircraft along the velocity of the air at O. */
import type { Mesh } from "three";
import { addArrow } from "./fittings";
import { FRAME } from "./frames";
import { HungMesh } from "./hung";
import { paintedMaterial } from "./light";
import type { Motion } from "./motion";
import { writeAlong } from "./moving";
import { Shape, Tint } from "./shape";

/** Of the size of the aircraft: how long the strongest wind of a show is, and how high the arrow is over O. */
const LONGEST = 0.22;
const ABOVE = 0.3;

export class WindArrow {
  speed = 0;
  private readonly hung: HungMesh;
  private readonly frames = new Float64Array(2 * FRAME);
  private readonly velocity = new Float64Array(3);
  private strongest = 1;

  constructor(private readonly size: number) {
    const shape = new Shape();
    const shaft = { frame: 0, owner: 0, tint: Tint.wind };
    addArrow(shape, shaft, { ...shaft, frame: 1 }, 0.028 * size);
    this.hung = new HungMesh(shape, paintedMaterial(), size);
  }

  get mesh(): Mesh {
    return this.hung.mesh;
  }

  setTints(tints: Uint32Array): void {
    this.hung.paintPlain(tints);
  }

  setMotion(motion: Motion): void {
    this.strongest = 1e-3;
    for (let i = 0; motion.wind && i < motion.wind.rows; i++) {
      this.strongest = Math.max(this.strongest, this.read(motion, i));
    }
  }

  place(motion: Motion, frame: number): void {
    this.speed = motion.wind ? this.read(motion, frame) : 0;
    this.mesh.visible = this.speed > 1e-3 * this.strongest && this.speed > 1e-3;
    if (!this.mesh.visible) return;
    const { frames: f, velocity } = this;
    const long = (LONGEST * this.size * this.speed) / this.strongest;
    writeAlong(velocity, 1 / this.speed, f);
    for (let i = 0; i < 9; i++) f[FRAME + i] = f[i];
    for (let i = 0; i < 3; i++) {
      const ahead = f[3 * i];
      const middle = i === 2 ? -ABOVE * this.size : 0;
      f[9 + i] = middle - 0.5 * long * ahead;
      f[FRAME + 9 + i] = middle + 0.5 * long * ahead;
      f[3 * i] *= long;
    }
    this.hung.move(f);
  }

  private read(motion: Motion, frame: number): number {
    motion.wind!.row(frame, this.velocity);
    const v = this.velocity;
    return Math.sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
  }
}
