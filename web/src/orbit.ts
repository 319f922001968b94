/** Turning the view by mouse, pen or fingers; a press without a movement is a click on what is there. */
import type { Viewer } from "./viewer";

/** Pixels within which a press is a click. */
const STILL = 5;

export class Orbit {
  private readonly fingers = new Map<number, { x: number; y: number }>();
  private moved = 0;

  constructor(
    private readonly stage: HTMLElement,
    private readonly viewer: Viewer,
    private readonly click: (x: number, y: number, isTouch: boolean) => void,
  ) {
    stage.addEventListener("pointerdown", (event) => this.press(event));
    stage.addEventListener("pointermove", (event) => this.move(event));
    stage.addEventListener("pointerup", (event) => this.release(event, true));
    stage.addEventListener("pointercancel", (event) => this.release(event, false));
    stage.addEventListener("wheel", (event) => this.wheel(event), { passive: false });
    stage.addEventListener("contextmenu", (event) => event.preventDefault());
  }

  private press(event: PointerEvent): void {
    if ((event.target as Element).closest("#picked")) return;
    this.stage.setPointerCapture(event.pointerId);
    if (this.fingers.size === 0) this.moved = 0;
    this.fingers.set(event.pointerId, { x: event.clientX, y: event.clientY });
  }

  private move(event: PointerEvent): void {
    const finger = this.fingers.get(event.pointerId);
    if (!finger) return;
    const before = this.spread();
    const dx = event.clientX - finger.x;
    const dy = event.clientY - finger.y;
    this.moved += Math.abs(dx) + Math.abs(dy);
    finger.x = event.clientX;
    finger.y = event.clientY;
    if (this.moved <= STILL) return;
    const height = this.stage.clientHeight;
    const share = 1 / (height * this.fingers.size);
    const { cameras } = this.viewer;
    if (this.fingers.size > 1) {
      cameras.zoom(before / Math.max(this.spread(), 1));
      cameras.pan(dx * share, dy * share);
    } else if (event.shiftKey || event.buttons === 2 || event.buttons === 4) cameras.pan(dx * share, dy * share);
    else cameras.orbit(dx * share * Math.PI, dy * share * Math.PI);
    this.viewer.changed();
  }

  private release(event: PointerEvent, isClick: boolean): void {
    if (!this.fingers.delete(event.pointerId) || this.fingers.size > 0) return;
    if (!isClick || this.moved > STILL || event.button !== 0) return;
    const box = this.stage.getBoundingClientRect();
    this.click(event.clientX - box.left, event.clientY - box.top, event.pointerType === "touch");
  }

  private wheel(event: WheelEvent): void {
    if ((event.target as Element).closest("#picked")) return;
    event.preventDefault();
    this.viewer.cameras.zoom(Math.exp(Math.min(Math.max(event.deltaY, -200), 200) * 0.0015));
    this.viewer.ask();
  }

  /** Distance between two fingers, pixels. */
  private spread(): number {
    const [a, b] = [...this.fingers.values()];
    return a && b ? Math.hypot(a.x - b.x, a.y - b.y) : 1;
  }
}
