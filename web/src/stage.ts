/** The canvas: renderer, and a quality that falls by itself where frames come too slowly. */
import { ColorManagement, LinearSRGBColorSpace, Scene, WebGLRenderer, type Camera } from "three";

interface Quality {
  antialias: boolean;
  /** Pixels of the picture a CSS pixel. */
  ratio: number;
}

const SLOW = 30;
/** Frames that are looked at before quality falls. */
const PATIENCE = 45;

export class Stage {
  readonly scene = new Scene();
  canvas!: HTMLCanvasElement;
  private renderer!: WebGLRenderer;
  private readonly qualities: Quality[];
  private level = 0;
  private frames = 0;
  private since = 0;

  /** `mayFall`: quality may be lowered. */
  constructor(
    private readonly holder: HTMLElement,
    private readonly mayFall: boolean,
  ) {
    // Colours go to the screen as they are, so that a surface in full light has the colour of the legend.
    ColorManagement.enabled = false;
    const finest = Math.min(window.devicePixelRatio || 1, 2);
    this.qualities = [
      { antialias: true, ratio: finest },
      ...(finest > 1 ? [{ antialias: true, ratio: 1 }] : []),
      { antialias: false, ratio: Math.min(finest, 1) },
      { antialias: false, ratio: 0.75 },
      { antialias: false, ratio: 0.5 },
    ];
    this.makeRenderer();
  }

  get quality(): Quality {
    return this.qualities[this.level];
  }

  get aspect(): number {
    return this.holder.clientWidth / Math.max(this.holder.clientHeight, 1);
  }

  render(camera: Camera): void {
    this.renderer.render(this.scene, camera);
  }

  resize(): void {
    const { clientWidth, clientHeight } = this.holder;
    this.renderer.setPixelRatio(this.quality.ratio);
    this.renderer.setSize(clientWidth, clientHeight);
  }

  /** To be told of every frame of a continuous run; 0 starts a new run. */
  watch(now: number): void {
    if (now === 0 || this.frames === 0) {
      this.frames = now === 0 ? 0 : 1;
      this.since = now;
      return;
    }
    this.frames++;
    if (this.frames <= PATIENCE) return;
    const rate = (1000 * (this.frames - 1)) / (now - this.since);
    this.frames = 0;
    if (rate < SLOW && this.mayFall && this.level < this.qualities.length - 1) this.lower();
  }

  private lower(): void {
    const { antialias } = this.quality;
    this.level++;
    if (antialias === this.quality.antialias) return this.resize();
    // Whether a canvas is antialiased is settled when it is made.
    this.renderer.dispose();
    this.renderer.forceContextLoss();
    this.canvas.remove();
    this.makeRenderer();
  }

  private makeRenderer(): void {
    this.canvas = document.createElement("canvas");
    // Opaque, so that the browser need not blend it with the page.
    const context = this.canvas.getContext("webgl2", {
      alpha: false,
      antialias: this.quality.antialias,
      powerPreference: "high-performance",
    });
    if (!context) throw new Error("This browser draws no WebGL, which the moving picture needs. Here is the plan view.");
    this.renderer = new WebGLRenderer({ canvas: this.canvas, context });
    this.renderer.outputColorSpace = LinearSRGBColorSpace;
    this.canvas.setAttribute("aria-label", "The aircraft");
    this.holder.prepend(this.canvas);
    this.resize();
  }
}
