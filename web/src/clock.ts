/** Time as it is played: real time multiplied by a speed, between the ends of a show. */
import type { Motion } from "./motion";

export const speeds = [0.1, 0.2, 0.5, 1, 2, 4];
/** A pause between frames longer than this does not count, s: the page was not seen. */
const LONGEST_STEP = 0.25;

export class Clock {
  time = 0;
  playing = false;
  speed = 1;
  /** Seconds of the show a second of real time, as measured. */
  factor = 0;
  private last = 0;
  private played = 0;
  private real = 0;

  start(now: number): void {
    this.playing = true;
    this.last = now;
    this.played = this.real = 0;
    this.factor = this.speed;
  }

  stop(): void {
    this.playing = false;
  }

  /** Moves on to the moment of this frame (`now` in ms); stops at the end of what does not repeat. */
  advance(now: number, motion: Motion): void {
    const passed = Math.max(now - this.last, 0) / 1000;
    this.last = now;
    const step = Math.min(passed, LONGEST_STEP) * this.speed;
    const { start, loops } = motion.show;
    const whole = motion.end - start;
    this.time += step;
    if (this.time > motion.end) {
      if (loops && whole > 0) this.time = start + ((this.time - start) % whole);
      else {
        this.time = motion.end;
        this.stop();
      }
    }
    this.measure(passed, step);
  }

  private measure(passed: number, step: number): void {
    this.real += passed;
    this.played += step;
    if (this.real < 0.5) return;
    this.factor = this.played / this.real;
    this.real = this.played = 0;
  }
}

/** A speed at which one turn of what repeats lasts neither too short to be seen nor too long to be waited for. */
export function fittingSpeed(motion: Motion): number {
  if (!motion.show.loops) return 1;
  const turn = motion.end - motion.show.start;
  const slowEnough = speeds.filter((speed) => turn / speed >= 1.2);
  const quickEnough = slowEnough.find((speed) => turn / speed <= 12) ?? slowEnough[slowEnough.length - 1];
  if (turn >= 1.2 && turn <= 12) return 1;
  return turn < 1.2 ? (slowEnough[slowEnough.length - 1] ?? speeds[0]) : (quickEnough ?? 1);
}
