/** Keys, and the card that lists them. */
import { cameraNames } from "./cameras";
import { speeds } from "./clock";
import type { Controls } from "./controls";
import { element, make } from "./elements";
import type { Picker } from "./pick";
import type { Pictures } from "./picture";
import type { Viewer } from "./viewer";

interface Key {
  /** As `KeyboardEvent.key` has them. */
  keys: string[];
  text: string;
  act: (key: string, event: KeyboardEvent) => void;
}

const NAMES: Record<string, string> = { " ": "space", ArrowLeft: "←", ArrowRight: "→", Escape: "Esc", PageUp: "Page ↑", PageDown: "Page ↓" };

export function listenToKeys(viewer: Viewer, controls: Controls, pictures: Pictures, picker: Picker): void {
  const keys = listKeys(viewer, controls, pictures, picker);
  const rows = keys.map(({ keys: names, text }) => {
    const row = make("tr");
    const cell = make("td");
    cell.append(...names.flatMap((name) => [make("kbd", NAMES[name] ?? name), " "]));
    row.append(cell, make("td", text));
    return row;
  });
  element("keys").replaceChildren(...rows);
  document.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey || ownsKeys(event)) return;
    const name = event.key.length === 1 ? event.key.toLowerCase() : event.key;
    const key = keys.find(({ keys: names }) => names.includes(name));
    if (!key) return;
    event.preventDefault();
    key.act(name, event);
  });
}

/** Whether what has the focus has a use for the key of its own. */
function ownsKeys(event: KeyboardEvent): boolean {
  const target = event.target as HTMLElement;
  if (target.closest("dialog[open], select")) return true;
  if (target.closest("button, summary")) return event.key === " " || event.key === "Enter";
  if (target.closest("input[type=checkbox]")) return event.key === " ";
  return target.closest("input") !== null && target.id !== "scrub" && event.key.startsWith("Arrow");
}

function listKeys(viewer: Viewer, controls: Controls, pictures: Pictures, picker: Picker): Key[] {
  const { clock } = viewer;
  return [
    { keys: [" "], text: "play, pause", act: () => (clock.playing ? viewer.pause() : viewer.play()) },
    {
      keys: ["ArrowLeft", "ArrowRight"],
      text: "a frame back, on; with Shift a second",
      act: (key, { shiftKey }) => {
        const by = key === "ArrowLeft" ? -1 : 1;
        if (shiftKey) viewer.seek(clock.time + by);
        else viewer.step(by);
      },
    },
    {
      keys: ["Home", "End"],
      text: "to the start, the end",
      act: (key) => viewer.seek(key === "Home" ? viewer.motion.show.start : viewer.motion.end),
    },
    { keys: [",", "."], text: "slower, faster", act: (key) => changeSpeed(viewer, key === "," ? -1 : 1) },
    {
      keys: cameraNames.map((_, i) => String(i + 1)),
      text: `camera: ${cameraNames.join(", ")}`,
      act: (key) => viewer.setCamera(cameraNames[Number(key) - 1]),
    },
    { keys: ["c"], text: "next colour; with Shift the one before", act: (_, event) => nextColour(viewer, event.shiftKey ? -1 : 1) },
    {
      keys: ["-", "+"],
      text: "deformation smaller, larger",
      act: (key) => viewer.setDeformation(viewer.deformation + (key === "+" ? 1 : -1)),
    },
    { keys: ["PageUp", "PageDown"], text: "show before, next", act: (key) => nextShow(viewer, key === "PageUp" ? -1 : 1) },
    { keys: ["g"], text: "ghost or jig shape", act: () => viewer.setGhost(!viewer.showsGhost) },
    { keys: ["d"], text: "dark or light", act: () => controls.toggleTheme() },
    { keys: ["p"], text: "save a picture", act: () => pictures.savePicture() },
    { keys: ["v"], text: "begin, end a film", act: () => pictures.toggleFilm() },
    { keys: ["r"], text: "everything as at the start", act: () => viewer.reset() },
    { keys: ["Escape"], text: "close what was clicked", act: () => picker.forget() },
    { keys: ["?"], text: "this card", act: () => element<HTMLDialogElement>("card").showModal() },
  ];
}

function changeSpeed(viewer: Viewer, by: number): void {
  const at = speeds.indexOf(viewer.clock.speed) + by;
  viewer.setSpeed(speeds[Math.min(Math.max(at, 0), speeds.length - 1)]);
}

function nextColour(viewer: Viewer, by: number): void {
  const names = [null, ...viewer.motion.show.colours.map(({ name }) => name)];
  const at = names.indexOf(viewer.colour) + by;
  viewer.setColour(names[(at + names.length) % names.length]);
}

function nextShow(viewer: Viewer, by: number): void {
  const { shows } = viewer.scene;
  const at = shows.indexOf(viewer.motion.show) + by;
  viewer.setShow(shows[(at + shows.length) % shows.length].name);
}
