/** The controls under the scene and beside it: they act on the viewer and show how it is. */
import { cameraNames, type CameraName } from "./cameras";
import { speeds } from "./clock";
import { element, entry, fill, make, say } from "./elements";
import { fixed, tickText } from "./numbers";
import { Pictures } from "./picture";
import type { Show } from "./scene";
import type { Viewer } from "./viewer";

const PLAY = "M7 4v16l13-8z";
const PAUSE = "M6 4h4.5v16H6zM13.5 4H18v16h-4.5z";
const KINDS: [Show["kind"], string][] = [
  ["flight", "Flights"],
  ["trim", "Trims"],
  ["mode", "Modes"],
  ["root", "Roots in flight"],
];

export class Controls {
  private readonly scrub = element<HTMLInputElement>("scrub");
  private readonly time = element("time");
  private readonly factor = element("factor");
  private readonly corner = element("corner");
  private readonly menus = {
    speed: element<HTMLSelectElement>("speed"),
    camera: element<HTMLSelectElement>("camera"),
    colour: element<HTMLSelectElement>("colour"),
    show: element<HTMLSelectElement>("show"),
  };
  private readonly deformation = element<HTMLInputElement>("deformation");
  private readonly ghost = element<HTMLInputElement>("ghost");
  private readonly play = element("play");
  private readonly film = element<HTMLButtonElement>("film");
  private told = "";

  constructor(
    private readonly viewer: Viewer,
    private readonly pictures: Pictures,
  ) {
    const { scene } = viewer;
    say(element("title"), scene.title);
    element("notes").replaceChildren(...scene.notes.map((note) => make("li", note)));
    this.menus.show.replaceChildren(...showMenu(scene.shows));
    fill(
      this.menus.speed,
      speeds.map((speed) => [String(speed), `${speed} ×`]),
    );
    fill(
      this.menus.camera,
      cameraNames.map((name) => [name, name]),
    );
    this.film.disabled = Pictures.filmType() === undefined;
    if (this.film.disabled) this.film.title = "This browser does not record films of a canvas as WebM";
    this.listenToMenus();
    this.listenToTransport();
  }

  /** Shows how the viewer is. */
  refresh(): void {
    const { viewer, menus } = this;
    const { show } = viewer.motion;
    this.tellShow(show);
    menus.speed.value = String(viewer.clock.speed);
    menus.camera.value = viewer.cameras.name;
    menus.colour.value = viewer.colour ?? "";
    this.deformation.value = String(viewer.deformation);
    say(element("deformation-value"), `× ${tickText(viewer.deformation)}`);
    const isPlaying = viewer.clock.playing;
    element("play-icon").setAttribute("d", isPlaying ? PAUSE : PLAY);
    this.play.setAttribute("aria-label", isPlaying ? "Pause" : "Play");
    this.ghost.checked = viewer.showsGhost;
    this.film.classList.toggle("recording", this.pictures.isRecording);
    say(this.film.querySelector("span")!, this.pictures.isRecording ? "End film" : "Film");
    document.documentElement.dataset.theme = viewer.theme;
  }

  /** Shows the moment and what is around. */
  tell(): void {
    const { clock, motion, wind, backdrop, airframe, scene } = this.viewer;
    this.scrub.valueAsNumber = clock.time;
    const moves = motion.show.count > 1;
    say(this.time, moves ? `${fixed(clock.time, 2)} s of ${fixed(motion.end, 2)} s` : "at rest");
    say(this.factor, moves ? this.pace() : "");
    const lines = [`grid ${tickText(backdrop.cell)} m`];
    if (!scene.clamped && motion.show.kind === "flight") lines.push(`at ${fixed(-motion.ground || 0, 0)} m; altitude ${fixed(-airframe.place[2] || 0, 1)} m`);
    if (wind.speed > 0) lines.push(`wind ${fixed(wind.speed, 1)} m/s`);
    if (motion.show.gust) lines.push(motion.show.gust.text);
    say(this.corner, lines.join("\n"));
  }

  private pace(): string {
    const { clock } = this.viewer;
    if (!clock.playing) return "paused";
    return clock.rest > 0 ? "then again" : `real ${fixed(clock.factor, 2)} ×`;
  }

  toggleTheme(): void {
    this.viewer.setTheme(this.viewer.theme === "dark" ? "light" : "dark");
  }

  /** What belongs to the show, once when it is chosen. */
  private tellShow(show: Show): void {
    if (show.name === this.told) return;
    this.told = show.name;
    this.menus.show.value = show.name;
    say(element("level"), show.level);
    const facts = show.facts.flatMap(([label, text]) => [make("dt", label), make("dd", text)]);
    element("facts").replaceChildren(...facts);
    const colours = show.colours.map((colour): [string, string] => [colour.name, colour.label || colour.name]);
    fill(this.menus.colour, [["", "none"], ...colours]);
    this.scrub.min = String(show.start);
    this.scrub.max = String(this.viewer.motion.end);
    const text = this.viewer.ghostText;
    element("ghosting").hidden = text === undefined;
    say(element("ghost-text"), text === "jig shape" ? text : `ghost: ${text}`);
    for (const id of ["play", "back", "forward", "first", "scrub"]) {
      element<HTMLButtonElement>(id).disabled = show.count < 2;
    }
  }

  private listenToMenus(): void {
    const { viewer, menus } = this;
    menus.speed.addEventListener("change", () => viewer.setSpeed(Number(menus.speed.value)));
    menus.camera.addEventListener("change", () => viewer.setCamera(menus.camera.value as CameraName));
    menus.colour.addEventListener("change", () => viewer.setColour(menus.colour.value || null));
    menus.show.addEventListener("change", () => viewer.setShow(menus.show.value));
    this.deformation.addEventListener("input", () => viewer.setDeformation(this.deformation.valueAsNumber));
    this.ghost.addEventListener("change", () => viewer.setGhost(this.ghost.checked));
  }

  private listenToTransport(): void {
    const { viewer } = this;
    this.scrub.addEventListener("input", () => viewer.seek(this.scrub.valueAsNumber));
    const on = (id: string, act: () => void) =>
      element(id).addEventListener("click", (event) => {
        act();
        // After a press by pointer, keys belong to the scene again.
        if (event.detail > 0) (event.currentTarget as HTMLElement).blur();
      });
    on("play", () => (viewer.clock.playing ? viewer.pause() : viewer.play()));
    on("back", () => viewer.step(-1));
    on("forward", () => viewer.step(1));
    on("first", () => viewer.seek(viewer.motion.show.start));
    on("reset", () => viewer.reset());
    on("theme", () => this.toggleTheme());
    on("picture", () => this.pictures.savePicture());
    on("film", () => this.pictures.toggleFilm());
    on("help", () => element<HTMLDialogElement>("card").showModal());
  }
}

function showMenu(shows: Show[]): HTMLElement[] {
  return KINDS.flatMap(([kind, label]) => {
    const options = shows.filter((show) => show.kind === kind).map(({ name }) => entry(name, name));
    if (options.length === 0) return [];
    const group = make("optgroup");
    group.label = label;
    group.append(...options);
    return [group];
  });
}
