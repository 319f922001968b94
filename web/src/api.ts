/** `window.flexair`: what tests and other programs may ask of the page. */
import type { CameraName } from "./cameras";
import type { ThemeName } from "./theme";
import type { Viewer } from "./viewer";

export interface Flexair {
  /** Settles when the first picture stands; fails where none can be drawn. */
  ready: Promise<void>;
  state(): {
    time: number;
    playing: boolean;
    camera: CameraName;
    colour: string | null;
    show: string;
    deformation: number;
    speed: number;
    theme: ThemeName;
  };
  /** Goes to a time of the show and stays there. */
  seek(seconds: number): void;
  play(): void;
  pause(): void;
  setCamera(name: CameraName): void;
  setColour(name: string | null): void;
  setShow(name: string): void;
  setDeformation(factor: number): void;
  setTheme(name: ThemeName): void;
  /** Where a station is drawn: north, east, down, m. */
  stationPosition(name: string): [number, number, number];
  /** Median of the page's own work for a frame, ms, over the given number of frames. */
  frameWork(): { median: number; frames: number };
  framesPerSecond(): number;
  quality(): { antialias: boolean; ratio: number };
  renderOnce(): void;
}

/** What of the viewer can be asked; `ready` is made before there is one. */
export function apiOf(viewer: Viewer): Omit<Flexair, "ready"> {
  return {
    state: () => ({
      time: viewer.clock.time,
      playing: viewer.clock.playing,
      camera: viewer.cameras.name,
      colour: viewer.colour,
      show: viewer.motion.show.name,
      deformation: viewer.deformation,
      speed: viewer.clock.speed,
      theme: viewer.theme,
    }),
    seek: (seconds) => {
      viewer.pause();
      viewer.seek(seconds);
    },
    play: () => viewer.play(),
    pause: () => viewer.pause(),
    setCamera: (name) => viewer.setCamera(name),
    setColour: (name) => viewer.setColour(name),
    setShow: (name) => viewer.setShow(name),
    setDeformation: (factor) => viewer.setDeformation(factor),
    setTheme: (name) => viewer.setTheme(name),
    stationPosition: (name) => stationPosition(viewer, name),
    frameWork: () => viewer.meter.median(),
    framesPerSecond: () => viewer.meter.framesPerSecond(),
    quality: () => ({ ...viewer.stage.quality }),
    renderOnce: () => viewer.renderOnce(),
  };
}

function stationPosition(viewer: Viewer, name: string): [number, number, number] {
  const station = viewer.scene.stations.find((one) => one.name === name);
  if (!station) throw new Error(`no station ${name}; there are ${viewer.scene.stations.map((one) => one.name).join(", ")}`);
  viewer.update();
  const { airframe } = viewer;
  const point = new Float64Array(3);
  airframe.point(station.section, station.offset, point);
  airframe.toEarth(point);
  return [airframe.place[0] + point[0], airframe.place[1] + point[1], airframe.place[2] + point[2]];
}
