/** Measures the page's own work a frame, and frames a second, over the last of them. */
const KEPT = 300;

export class Meter {
  private readonly work = new Float64Array(KEPT);
  private readonly times = new Float64Array(60);
  private frames = 0;
  private run = 0;

  /** Work of a frame, ms. */
  add(work: number): void {
    this.work[this.frames % KEPT] = work;
    this.frames++;
  }

  /** A frame of a continuous run at a time, ms. */
  tick(now: number): void {
    this.times[this.run % this.times.length] = now;
    this.run++;
  }

  endRun(): void {
    this.run = 0;
  }

  median(): { median: number; frames: number } {
    const count = Math.min(this.frames, KEPT);
    const sorted = this.work.slice(0, count).sort();
    return { median: count > 0 ? sorted[count >> 1] : 0, frames: count };
  }

  framesPerSecond(): number {
    const kept = Math.min(this.run, this.times.length);
    if (kept < 2) return 0;
    const last = this.times[(this.run - 1) % this.times.length];
    const first = this.times[(this.run - kept) % this.times.length];
    return (1000 * (kept - 1)) / (last - first);
  }
}
