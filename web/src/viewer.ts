/** What is seen: which show at which moment, how, from where; draws it. */
import { Airframe } from "./airframe";
import { Backdrop } from "./backdrop";
import { Cameras, type CameraName } from "./cameras";
import { Clock, fittingSpeed } from "./clock";
import { GustField } from "./gust";
import { ghostMaterial } from "./light";
import { Meter } from "./meter";
import { Motions, type Motion } from "./motion";
import { Painter } from "./painter";
import type { Scene } from "./scene";
import { Stage } from "./stage";
import { packedTints, themes, type ThemeName } from "./theme";
import { WindArrow } from "./wind";

export class Viewer {
  readonly clock = new Clock();
  readonly meter = new Meter();
  readonly cameras: Cameras;
  readonly airframe: Airframe;
  readonly painter: Painter;
  readonly backdrop: Backdrop;
  readonly wind: WindArrow;
  motion!: Motion;
  frame = 0;
  deformation = 1;
  /** Name of the chosen colour. */
  colour: string | null = null;
  theme: ThemeName = "light";
  showsGhost = true;
  /** Called after each change that is more than time going on. */
  onChange: () => void = () => {};
  /** The rest of the page's work for a frame, and what follows a drawn frame. */
  onFrame: () => void = () => {};
  onDrawn: () => void = () => {};
  private readonly motions: Motions;
  private readonly ghost: Airframe;
  private ghostMotion: Motion | undefined;
  private readonly ghostMaterial = ghostMaterial(0.3);
  private gust: GustField | undefined;
  private colourNumber = -1;
  private tints = packedTints(themes.light);
  private readonly gustPlace = new Float64Array(7);
  private isAsked = false;

  constructor(
    readonly scene: Scene,
    data: ArrayBuffer,
    readonly stage: Stage,
  ) {
    this.motions = new Motions(scene, data);
    this.cameras = new Cameras(scene);
    this.airframe = new Airframe(scene);
    this.painter = new Painter(scene, this.airframe);
    this.ghost = new Airframe(scene, this.ghostMaterial, "none");
    this.ghost.fittings.mesh.visible = this.ghost.cuts.mesh.visible = false;
    this.backdrop = new Backdrop(scene.size);
    this.wind = new WindArrow(scene.size);
    stage.scene.background = this.backdrop.ground;
    stage.scene.add(this.backdrop.group, this.airframe.group, this.ghost.group, this.wind.mesh);
    this.setShow(scene.shows[0].name);
  }

  /** What the ghost is, if the show has one. */
  get ghostText(): string | undefined {
    const { kind, level } = this.motion.show;
    const ghost = this.ghostMotion?.show;
    if (ghost) return ghost.level === level ? ghost.name : ghost.level;
    return kind === "trim" || kind === "mode" ? "jig shape" : undefined;
  }

  setShow(name: string): void {
    const motion = this.motions.of(name);
    if (!motion || motion === this.motion) return;
    this.motion = motion;
    this.ghostMotion = motion.show.ghost === undefined ? undefined : this.motions.of(motion.show.ghost);
    this.clock.speed = fittingSpeed(motion);
    this.clock.goTo(motion.show.start);
    this.cameras.frame(motion);
    this.wind.setMotion(motion);
    this.setGust();
    this.setColour(this.colour);
  }

  setColour(name: string | null): void {
    this.colourNumber = this.motion.show.colours.findIndex((colour) => colour.name === name);
    this.colour = this.colourNumber < 0 ? null : name;
    this.painter.plain(this.tints);
    this.changed();
  }

  setTheme(name: ThemeName): void {
    this.theme = name;
    this.tints = packedTints(themes[name]);
    this.backdrop.setTheme(themes[name]);
    this.ghostMaterial.uniforms.ghost.value.set(themes[name].ghost);
    this.gust?.setColour(themes[name].gust);
    this.wind.setTints(this.tints);
    this.painter.plain(this.tints);
    this.changed();
  }

  setCamera(name: CameraName): void {
    this.cameras.choose(name);
    this.changed();
  }

  setDeformation(factor: number): void {
    this.deformation = Math.min(Math.max(factor, 1), 20);
    this.changed();
  }

  setSpeed(speed: number): void {
    this.clock.speed = speed;
    this.changed();
  }

  setGhost(isShown: boolean): void {
    this.showsGhost = isShown;
    this.changed();
  }

  seek(time: number): void {
    this.clock.goTo(Math.min(Math.max(time, this.motion.show.start), this.motion.end));
    this.changed();
  }

  play(): void {
    if (this.motion.show.count < 2) return;
    const isAtEnd = this.clock.time >= this.motion.end && !this.motion.show.loops;
    if (isAtEnd) this.clock.goTo(this.motion.show.start);
    this.clock.start(performance.now());
    this.changed();
  }

  pause(): void {
    this.clock.stop();
    this.changed();
  }

  /** To the next (1) or the previous (−1) frame of the show. */
  step(by: number): void {
    this.clock.stop();
    const frame = this.motion.frameAt(this.clock.time);
    const next = by > 0 ? Math.floor(frame + 1e-6) + by : Math.ceil(frame - 1e-6) + by;
    this.seek(this.motion.show.start + next * this.motion.show.step);
  }

  reset(): void {
    this.clock.stop();
    this.deformation = 1;
    this.cameras.reset();
    this.clock.speed = fittingSpeed(this.motion);
    this.setColour(null);
    this.seek(this.motion.show.start);
  }

  changed(): void {
    this.onChange();
    this.ask();
  }

  /** Asks for a frame. */
  ask(): void {
    if (this.isAsked) return;
    this.isAsked = true;
    requestAnimationFrame(this.tick);
  }

  renderOnce(): void {
    const began = performance.now();
    this.update();
    this.onFrame();
    this.meter.add(performance.now() - began);
    this.stage.render(this.cameras.camera);
    this.onDrawn();
  }

  private readonly tick = (now: number): void => {
    this.isAsked = false;
    const wasPlaying = this.clock.playing;
    if (wasPlaying) {
      this.clock.advance(now, this.motion);
      this.meter.tick(now);
      this.stage.watch(now);
      this.ask();
    }
    this.renderOnce();
    if (this.clock.playing) return;
    this.meter.endRun();
    this.stage.watch(0);
    if (wasPlaying) this.changed();
  };

  /** Poses, colours, surroundings and camera of the present moment. */
  update(): void {
    const { motion, airframe, clock } = this;
    const frame = (this.frame = motion.frameAt(clock.time));
    airframe.pose(motion, frame, this.deformation);
    const origin = airframe.place;
    airframe.putAt(origin);
    if (this.colourNumber >= 0) this.painter.paint(motion, this.colourNumber, frame);
    this.updateGhost(origin);
    this.wind.place(motion, frame);
    this.placeGust(origin);
    this.cameras.place(airframe, motion.headingAt(frame));
    this.backdrop.place(this.cameras.camera, origin, motion.ground);
  }

  private updateGhost(origin: Float64Array): void {
    const { ghost, ghostMotion, motion } = this;
    ghost.group.visible = this.showsGhost && this.ghostText !== undefined;
    if (!ghost.group.visible) return;
    // The bodies of the jig shape lie so near to those that are drawn that they would only make these spotty.
    ghost.bodies.mesh.visible = ghostMotion !== undefined;
    if (ghostMotion) ghost.pose(ghostMotion, ghostMotion.frameAt(this.clock.time), this.deformation);
    else ghost.poseJig(motion, this.frame);
    ghost.putAt(origin);
  }

  private setGust(): void {
    if (this.gust) {
      this.stage.scene.remove(this.gust.group);
      this.gust.dispose();
      this.gust = undefined;
    }
    const { gust } = this.motion.show;
    if (!gust) return;
    this.gust = new GustField(gust, this.scene.size, themes[this.theme].gust);
    this.stage.scene.add(this.gust.group);
    this.motion.body.row(0, this.gustPlace);
  }

  private placeGust(origin: Float64Array): void {
    if (!this.gust) return;
    const begin = this.gustPlace;
    const passed = this.clock.time - this.motion.show.start;
    const drift = this.motion.show.gust!.drift;
    const at = this.gust.group.position;
    at.x = begin[0] - origin[0] + (drift ? drift[0] * passed : 0);
    at.y = begin[1] - origin[1] + (drift ? drift[1] * passed : 0);
    at.z = begin[2] - origin[2] + (drift ? drift[2] * passed : 0);
  }
}
