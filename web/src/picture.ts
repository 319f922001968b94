/** A picture (PNG) or film (WebM) of what is seen: the scene with its legend, title and moment. */
import { legendText } from "./legend";
import { fixed, tickText, ticks } from "./numbers";
import { themes } from "./theme";
import type { Viewer } from "./viewer";

const FILM_TYPES = ["video/webm;codecs=vp9", "video/webm;codecs=vp8", "video/webm"];
const FRAMES_PER_SECOND = 30;
/** From its left end to the edge of the picture. */
const LEGEND = 244;

export class Pictures {
  private readonly canvas = document.createElement("canvas");
  private recorder: MediaRecorder | undefined;

  constructor(private readonly viewer: Viewer) {}

  /** The type of film that this browser records, if it does. */
  static filmType(): string | undefined {
    if (typeof MediaRecorder === "undefined" || !HTMLCanvasElement.prototype.captureStream) return undefined;
    return FILM_TYPES.find((type) => MediaRecorder.isTypeSupported(type));
  }

  get isRecording(): boolean {
    return this.recorder !== undefined;
  }

  savePicture(): void {
    this.viewer.renderOnce();
    this.compose();
    this.canvas.toBlob((blob) => blob && save(blob, `${this.fileName()}.png`), "image/png");
  }

  /** Begins a film, or ends and saves it. */
  toggleFilm(): void {
    if (this.recorder) return this.recorder.stop();
    const type = Pictures.filmType();
    if (!type) return;
    const parts: Blob[] = [];
    this.viewer.renderOnce();
    this.compose();
    const recorder = new MediaRecorder(this.canvas.captureStream(FRAMES_PER_SECOND), {
      mimeType: type,
      videoBitsPerSecond: 8e6,
    });
    recorder.ondataavailable = (event) => parts.push(event.data);
    recorder.onstop = () => {
      this.recorder = undefined;
      save(new Blob(parts, { type: "video/webm" }), `${this.fileName()}.webm`);
      this.viewer.changed();
    };
    recorder.start(1000);
    this.recorder = recorder;
    this.viewer.changed();
  }

  /** Adds the drawn frame to the film, if there is one. */
  follow(): void {
    if (this.recorder) this.compose();
  }

  private compose(): void {
    const { canvas: source, quality } = this.viewer.stage;
    // The size of a film cannot change while it is recorded.
    if (!this.recorder) {
      this.canvas.width = source.width;
      this.canvas.height = source.height;
    }
    const context = this.canvas.getContext("2d")!;
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.drawImage(source, 0, 0, this.canvas.width, this.canvas.height);
    const scale = this.recorder ? this.canvas.height / source.clientHeight : quality.ratio;
    context.setTransform(scale, 0, 0, scale, 0, 0);
    const [width, height] = [this.canvas.width / scale, this.canvas.height / scale];
    const end = this.write(context);
    // In a narrow picture the legend stands at its foot.
    this.drawLegend(context, width - LEGEND, end < width - LEGEND ? 0 : height - 68);
  }

  /** Title and moment; where they end. */
  private write(context: CanvasRenderingContext2D): number {
    const { motion, clock, scene, theme, deformation } = this.viewer;
    context.fillStyle = themes[theme].text;
    context.textAlign = "left";
    context.font = "600 15px system-ui, sans-serif";
    context.fillText(scene.title, 14, 26);
    const titleWidth = context.measureText(scene.title).width;
    context.font = "13px system-ui, sans-serif";
    const larger = deformation === 1 ? "" : `, deformation × ${deformation}`;
    const moment = `${motion.show.name}, ${fixed(clock.time, 2)} s${larger}`;
    context.fillText(moment, 14, 46);
    return 14 + Math.max(titleWidth, context.measureText(moment).width);
  }

  private drawLegend(context: CanvasRenderingContext2D, left: number, top: number): void {
    const { motion, colour, theme } = this.viewer;
    const scale = motion.scales[motion.show.colours.findIndex((one) => one.name === colour)];
    if (!scale) return;
    const long = 220;
    const bar = context.createLinearGradient(left, 0, left + long, 0);
    scale.colours.forEach((step, i) => bar.addColorStop(i / (scale.colours.length - 1), step));
    context.fillStyle = bar;
    context.fillRect(left, top + 32, long, 11);
    context.fillStyle = themes[theme].text;
    context.fillText(legendText(this.viewer), left, top + 26);
    context.textAlign = "center";
    for (const tick of ticks(scale.low, scale.high, 5)) {
      context.fillText(tickText(tick), left + (long * (tick - scale.low)) / (scale.high - scale.low), top + 58);
    }
  }

  private fileName(): string {
    const { scene, motion, clock } = this.viewer;
    const name = `${scene.aircraft} ${motion.show.name} ${clock.time.toFixed(2)} s`;
    return name.replace(/[^\p{L}\p{N}.]+/gu, "-").slice(0, 100);
  }
}

function save(blob: Blob, name: string): void {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
}
