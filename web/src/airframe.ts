/** The aircraft as it is drawn: its frames at a moment, and the meshes that hang in them. */
import { DoubleSide, Group, Matrix4, MeshBasicMaterial, type Material } from "three";
import { stripsInBodies } from "./across";
import { addBody } from "./bodies";
import { addArrow, addCut, addEngine, addMarker } from "./fittings";
import { FRAME, writePoint, writeRotation } from "./frames";
import { HungMesh } from "./hung";
import { closings, type Closing } from "./joints";
import { paintedMaterial } from "./light";
import type { Motion } from "./motion";
import type { Scene, Vec } from "./scene";
import { Shape, Tint } from "./shape";
import { addStrip, COARSE, FINE } from "./strips";
import { writeArrow, writeFlap } from "./moving";

/** More strips than these are drawn with few edges. */
const MANY_STRIPS = 50;

export class Airframe {
  /** In earth axes, at where O is drawn. */
  readonly group = new Group();
  readonly strips: HungMesh;
  readonly bodies: HungMesh;
  readonly fittings: HungMesh;
  readonly cuts: HungMesh;
  /** Position of O (3) and rotation from body to earth (9), row after row. */
  readonly place = new Float64Array(12);
  private readonly frames: Float64Array;
  private readonly jig: Float64Array;
  /** Of each strip with a flap. */
  private readonly flaps: { strip: number; frame: number }[] = [];
  private readonly firstArrow: number;
  private readonly poses: Float64Array;
  private readonly angles: Float64Array;
  private readonly thrust: Float64Array;
  private readonly body = new Float64Array(7);
  private readonly matrix = new Matrix4();

  constructor(
    private readonly scene: Scene,
    material: Material = paintedMaterial(),
    /** How ends of strips are closed where they meet. */
    private readonly joined: Closing = "coarse",
  ) {
    const { sections, strips, engines, size } = scene;
    strips.forEach((strip, i) => {
      if (strip.flap) this.flaps.push({ strip: i, frame: sections.length + this.flaps.length });
    });
    this.firstArrow = sections.length + this.flaps.length;
    this.frames = new Float64Array(FRAME * (this.firstArrow + 2 * engines.length));
    this.jig = Float64Array.from(sections.flat());
    this.poses = new Float64Array(7 * sections.length);
    this.angles = new Float64Array(scene.controls.length);
    this.thrust = new Float64Array(engines.length);
    const outline = new MeshBasicMaterial({ vertexColors: true, side: DoubleSide });
    this.strips = new HungMesh(this.stripShape(), material, 4 * size);
    this.bodies = new HungMesh(this.bodyShape(), material, 4 * size);
    this.fittings = new HungMesh(this.fittingShape(), paintedMaterial(), 4 * size);
    this.cuts = new HungMesh(this.cutShape(), outline, 4 * size);
    for (const part of this.parts()) this.group.add(part.mesh);
    this.group.matrixAutoUpdate = false;
  }

  parts(): HungMesh[] {
    return [this.strips, this.bodies, this.fittings, this.cuts];
  }

  /** Moves all to a frame of a motion, its deformation `factor` times as large. */
  pose(motion: Motion, frame: number, factor: number): void {
    motion.poses.row(frame, this.poses);
    motion.controls.row(frame, this.angles);
    motion.thrust.row(frame, this.thrust);
    for (let s = 0; s < this.scene.sections.length; s++) this.writeSection(s, factor);
    this.moveParts(motion, frame);
  }

  /** Moves all to the jig shape, where the body is at a frame of a motion. */
  poseJig(motion: Motion, frame: number): void {
    motion.controls.row(frame, this.angles);
    this.thrust.fill(0);
    for (let s = 0; s < this.scene.sections.length; s++) {
      const f = FRAME * s;
      this.frames.fill(0, f, f + FRAME);
      this.frames[f] = this.frames[f + 4] = this.frames[f + 8] = 1;
      for (let i = 0; i < 3; i++) this.frames[f + 9 + i] = this.jig[3 * s + i];
    }
    this.moveParts(motion, frame);
  }

  /** Writes where a point of a section is in body axes. */
  point(section: number, offset: Vec, out: Float64Array): void {
    writePoint(this.frames, FRAME * section, offset, out, 0);
  }

  /** Turns a vector of body axes in place into earth axes. */
  toEarth(v: Float64Array): void {
    const p = this.place;
    const x = v[0];
    const y = v[1];
    const z = v[2];
    for (let i = 0; i < 3; i++) v[i] = p[3 + 3 * i] * x + p[4 + 3 * i] * y + p[5 + 3 * i] * z;
  }

  private writeSection(s: number, factor: number): void {
    const { poses, jig, frames } = this;
    const f = FRAME * s;
    writeRotation(poses, 7 * s + 3, factor, frames, f);
    for (let i = 0; i < 3; i++) {
      const rest = jig[3 * s + i];
      const here = poses[7 * s + i];
      frames[f + 9 + i] = factor === 1 ? here : rest + factor * (here - rest);
    }
  }

  private moveParts(motion: Motion, frame: number): void {
    const { scene, frames, place, body } = this;
    motion.body.row(frame, body);
    for (let i = 0; i < 3; i++) place[i] = body[i];
    writeRotation(body, 3, 1, place, 3);
    for (let i = 0; i < this.flaps.length; i++) {
      const { strip, frame: at } = this.flaps[i];
      writeFlap(scene.strips[strip], this.angles, frames, FRAME * at);
    }
    for (let e = 0; e < scene.engines.length; e++) {
      writeArrow(scene.engines[e], this.thrust[e], frames, FRAME * (this.firstArrow + 2 * e));
    }
    this.strips.move(frames);
    this.bodies.move(frames);
    this.fittings.move(frames);
    this.cuts.move(frames);
  }

  /** Puts the group where O is, seen from `origin` (earth axes). */
  putAt(origin: ArrayLike<number>): void {
    const p = this.place;
    // prettier-ignore
    this.matrix.set(
      p[3], p[4], p[5], p[0] - origin[0],
      p[6], p[7], p[8], p[1] - origin[1],
      p[9], p[10], p[11], p[2] - origin[2],
      0, 0, 0, 1,
    );
    this.group.matrix.copy(this.matrix);
    this.group.matrixWorldNeedsUpdate = true;
  }

  private stripShape(): Shape {
    const shape = new Shape();
    const frameOf = new Map(this.flaps.map(({ strip, frame }) => [strip, frame]));
    const ends = closings(this.scene.strips, this.scene.sections, this.joined);
    const edges = this.scene.strips.length > MANY_STRIPS ? COARSE : FINE;
    const isInBody = stripsInBodies(this.scene);
    this.scene.strips.forEach((strip, i) => {
      if (!isInBody[i]) addStrip(shape, strip, i, { flap: frameOf.get(i), closings: ends[i], edges });
    });
    return shape;
  }

  private bodyShape(): Shape {
    const shape = new Shape();
    for (const body of this.scene.bodies) addBody(shape, body, this.scene.sections);
    return shape;
  }

  private fittingShape(): Shape {
    const { engines, stations, size } = this.scene;
    const shape = new Shape();
    engines.forEach((engine, e) => {
      addEngine(shape, engine, e);
      const shaft = { frame: this.firstArrow + 2 * e, owner: e, tint: Tint.thrust };
      addArrow(shape, shaft, { ...shaft, frame: shaft.frame + 1 }, 0.22 * engine.size);
    });
    stations.forEach(({ section, offset }, s) => {
      addMarker(shape, { frame: section, owner: s, tint: Tint.station }, offset, 0.006 * size);
    });
    return shape;
  }

  private cutShape(): Shape {
    const shape = new Shape();
    this.scene.cuts.forEach(({ section, offset, normal }, c) => {
      addCut(shape, { frame: section, owner: c, tint: Tint.thrust }, offset, normal, 0.03 * this.scene.size);
    });
    return shape;
  }
}
