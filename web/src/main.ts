/** The page of `flexair view`: reads the scene, makes the picture and everything around it. */
import { apiOf, type Flexair } from "./api";
import { Charts } from "./charts";
import { Controls } from "./controls";
import { readData, readScene } from "./data";
import { element } from "./elements";
import { listenToKeys } from "./keyboard";
import { Legend } from "./legend";
import { Orbit } from "./orbit";
import { Picker } from "./pick";
import { Pictures } from "./picture";
import { Stage } from "./stage";
import { Viewer } from "./viewer";

declare global {
  interface Window {
    flexair: Flexair;
  }
}

/** Texts and the scrubber change at most so often, ms: more cannot be read, and costs the browser much. */
const READABLE = 120;

async function begin(): Promise<void> {
  const scene = readScene();
  const data = await readData();
  element("app").hidden = false;
  const options = location.hash.slice(1).split(",");
  const stage = new Stage(element("stage"), !options.includes("quality=high"));
  const viewer = new Viewer(scene, data, stage);
  assemble(viewer);
  const dark = matchMedia("(prefers-color-scheme: dark)");
  dark.addEventListener("change", () => viewer.setTheme(dark.matches ? "dark" : "light"));
  viewer.setTheme(dark.matches ? "dark" : "light");
  element("still").hidden = true;
  Object.assign(window.flexair, apiOf(viewer));
  viewer.renderOnce();
  performance.mark("first picture");
  const isCalm = matchMedia("(prefers-reduced-motion: reduce)").matches;
  if (!isCalm && !options.includes("paused")) viewer.play();
}

/** Joins the viewer with all that acts on it or follows it. */
function assemble(viewer: Viewer): void {
  const pictures = new Pictures(viewer);
  const controls = new Controls(viewer, pictures);
  const legend = new Legend();
  const charts = new Charts(element("charts"), viewer);
  const picker = new Picker(viewer);
  let told = 0;
  viewer.onChange = () => {
    controls.refresh();
    legend.refresh(viewer);
    charts.refresh();
    told = 0;
  };
  viewer.onFrame = () => {
    charts.place();
    picker.place();
    const now = performance.now();
    if (now - told < READABLE) return;
    told = now;
    controls.tell();
    charts.tell();
    picker.tell();
  };
  viewer.onDrawn = () => pictures.follow();
  new Orbit(element("stage"), viewer, (x, y, isTouch) => picker.click(x, y, isTouch));
  listenToKeys(viewer, controls, pictures, picker);
  new ResizeObserver(() => {
    viewer.stage.resize();
    viewer.cameras.setAspect(viewer.stage.aspect);
    viewer.renderOnce();
  }).observe(element("stage"));
  viewer.cameras.setAspect(viewer.stage.aspect);
}

/** Leaves the plan view standing, and says why there is no more. */
function giveUp(reason: unknown): void {
  element("app").hidden = true;
  document.documentElement.className = "";
  element("why").textContent = reason instanceof Error ? reason.message : String(reason);
}

const ready = begin();
window.flexair = { ready } as Flexair;
ready.catch(giveUp);
