/** What a click hits, and the card that says what it is, where it is and what it carries. */
import { Raycaster, Vector2, Vector3 } from "three";
import { element, make, say } from "./elements";
import { fixed, withUnit } from "./numbers";
import type { Vec } from "./scene";
import { add, times } from "./vectors";
import type { Viewer } from "./viewer";

interface Picked {
  name: string;
  section: number;
  offset: Vec;
  strip: number | undefined;
}

export class Picker {
  private picked: Picked | undefined;
  private readonly ray = new Raycaster();
  private readonly tag = element("tag");
  private readonly card = element("picked");
  private readonly name = element("picked-name");
  private readonly values = element("picked-values");
  private readonly body = new Float64Array(3);
  private readonly seen = new Vector3();

  constructor(private readonly viewer: Viewer) {
    element("unpick").addEventListener("click", () => this.forget());
  }

  /** Picks what is at a place of the stage, CSS pixels; nothing there forgets what was picked. */
  click(x: number, y: number, isTouch: boolean): void {
    const picked = this.stationAt(x, y, isTouch ? 24 : 12) ?? this.stripAt(x, y);
    if (!picked) return this.forget();
    this.picked = picked;
    this.card.hidden = this.tag.hidden = false;
    say(this.name, picked.name);
    say(this.tag, picked.name);
    this.tell();
    this.viewer.ask();
  }

  forget(): void {
    this.picked = undefined;
    this.card.hidden = this.tag.hidden = true;
  }

  /** Moves the tag to where the picked thing is drawn. */
  place(): void {
    if (!this.picked) return;
    const { x, y, isAhead } = this.project(this.picked.section, this.picked.offset);
    this.tag.style.visibility = isAhead ? "visible" : "hidden";
    this.tag.style.transform = `translate(${Math.round(x + 8)}px, ${Math.round(y - 26)}px)`;
  }

  /** Says position and values of the present moment. */
  tell(): void {
    const { picked, viewer } = this;
    if (!picked) return;
    const { motion, frame, airframe } = viewer;
    airframe.point(picked.section, picked.offset, this.body);
    const lines: [string, string][] = [["x, y, z", `${list(this.body)} m`]];
    airframe.toEarth(this.body);
    const earth = Array.from(this.body, (part, i) => airframe.place[i] + part);
    lines.push(["north, east", `${list(earth.slice(0, 2))} m`], ["altitude", `${fixed(-earth[2], 3)} m`]);
    motion.show.colours.forEach((colour, c) => {
      const value = viewer.painter.value(motion, c, frame, picked.strip, picked.section);
      if (value !== undefined) lines.push([colour.label || colour.name, withUnit(value, colour.unit)]);
    });
    while (this.values.childElementCount > lines.length) this.values.lastElementChild!.remove();
    lines.forEach(([label, text], i) => this.line(i, label, text));
  }

  private line(i: number, label: string, text: string): void {
    let row = this.values.children[i] as HTMLElement | undefined;
    if (!row) {
      row = make("tr");
      row.append(make("td"), make("td"));
      this.values.append(row);
    }
    say(row.children[0] as HTMLElement, label);
    say(row.children[1] as HTMLElement, text);
  }

  private stationAt(x: number, y: number, reach: number): Picked | undefined {
    let best = reach;
    let picked: Picked | undefined;
    for (const { name, section, offset } of this.viewer.scene.stations) {
      const at = this.project(section, offset);
      const distance = Math.hypot(at.x - x, at.y - y);
      if (!at.isAhead || distance >= best) continue;
      best = distance;
      picked = { name: `station ${name}`, section, offset, strip: undefined };
    }
    return picked;
  }

  private stripAt(x: number, y: number): Picked | undefined {
    const { stage, cameras, airframe, painter, scene } = this.viewer;
    const at = new Vector2((2 * x) / stage.canvas.clientWidth - 1, 1 - (2 * y) / stage.canvas.clientHeight);
    this.ray.setFromCamera(at, cameras.camera);
    const hits = this.ray.intersectObjects([airframe.strips.mesh, airframe.bodies.mesh], false);
    const hit = hits.find(({ faceIndex }) => faceIndex !== undefined && faceIndex !== null);
    if (!hit) return undefined;
    const face = hit.faceIndex!;
    const isStrip = hit.object === airframe.strips.mesh;
    const i = isStrip ? airframe.strips.ownerOfFace(face) : painter.stripAt(airframe.bodies.ownerOfFace(face));
    if (i === undefined) return undefined;
    const strip = scene.strips[i];
    const offset = times(0.25, strip.corners.reduce(add));
    return { name: `${strip.component}, strip ${strip.number}`, section: strip.section, offset, strip: i };
  }

  /** Where a point is drawn on the stage, CSS pixels. */
  private project(section: number, offset: Vec): { x: number; y: number; isAhead: boolean } {
    const { airframe, cameras, stage } = this.viewer;
    airframe.point(section, offset, this.body);
    airframe.toEarth(this.body);
    this.seen.fromArray(this.body).project(cameras.camera);
    return {
      x: (0.5 + this.seen.x / 2) * stage.canvas.clientWidth,
      y: (0.5 - this.seen.y / 2) * stage.canvas.clientHeight,
      isAhead: this.seen.z < 1,
    };
  }
}

function list(values: ArrayLike<number>): string {
  return Array.from(values, (value) => fixed(value, 3)).join(", ");
}
