/** Colours the aircraft by what a strip or section carries at a moment, or by what it is made of. */
import { stripsOfSections } from "./across";
import type { Airframe } from "./airframe";
import type { Motion } from "./motion";
import type { Scene } from "./scene";
import { Tint } from "./shape";

export class Painter {
  private readonly ofStrips: Uint32Array;
  private readonly ofSections: Uint32Array;
  private readonly sectionOfStrip: Uint32Array;
  private readonly stripOfSection: Int32Array;
  private bodyTint = 0;
  private values = new Float64Array(0);

  constructor(
    scene: Scene,
    private readonly airframe: Airframe,
  ) {
    this.ofStrips = new Uint32Array(scene.strips.length);
    this.ofSections = new Uint32Array(scene.sections.length);
    this.sectionOfStrip = Uint32Array.from(scene.strips, (strip) => strip.section);
    this.stripOfSection = stripsOfSections(scene);
  }

  /** Paints all as it is without a colour chosen. */
  plain(tints: Uint32Array): void {
    this.bodyTint = tints[Tint.body];
    for (const part of this.airframe.parts()) part.paintPlain(tints);
  }

  /** Paints by the colour with the given number in the show. */
  paint(motion: Motion, colour: number, frame: number): void {
    const table = motion.colours[colour];
    const scale = motion.scales[colour];
    if (this.values.length < table.columns) this.values = new Float64Array(table.columns);
    table.row(frame, this.values);
    const { values, ofStrips, ofSections, sectionOfStrip, stripOfSection } = this;
    if (motion.show.colours[colour].on === "strips") {
      for (let i = 0; i < ofStrips.length; i++) ofStrips[i] = scale.of(values[i]);
      for (let s = 0; s < ofSections.length; s++) ofSections[s] = stripOfSection[s] < 0 ? this.bodyTint : ofStrips[stripOfSection[s]];
    } else {
      for (let s = 0; s < ofSections.length; s++) ofSections[s] = scale.of(values[s]);
      for (let i = 0; i < ofStrips.length; i++) ofStrips[i] = ofSections[sectionOfStrip[i]];
    }
    this.airframe.bodies.paintOwners(ofSections);
    this.airframe.strips.paintOwners(ofStrips);
  }

  /** The strip that a section of a body shows, if there is one. */
  stripAt(section: number): number | undefined {
    const strip = this.stripOfSection[section];
    return strip < 0 ? undefined : strip;
  }

  /** The present value of a colour at a strip or, for colours on sections, at a section. */
  value(motion: Motion, colour: number, frame: number, strip: number | undefined, section: number): number | undefined {
    const column = motion.show.colours[colour].on === "strips" ? strip : section;
    if (column === undefined) return undefined;
    const row = new Float64Array(motion.colours[colour].columns);
    motion.colours[colour].row(frame, row);
    return row[column];
  }
}
