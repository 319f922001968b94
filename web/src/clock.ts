/** Time as it is played: real time multiplied by a speed, between the ends of a show. */
import type { Motion } from "./motion";

export const speeds = [0.1, 0.2, 0.5, 1, 2, 4];
/** A pause between frames longer than this does not count, s: the page was not seen. */
const LONGEST_STEP = 0.25;
/** How long the last moment of what decays or grows stands before it begins again, s of real time. */
const REST = 1.2;

export class Clock {
  time = 0;
  playing = false;
  speed = 1;
  /** Seconds of the show a second of real time, as measured. */
  factor = 0;
  /** How long the last moment is still to stand, s of real time. */
  rest = 0;
  private last = 0;
  private played = 0;
  private real = 0;

  start(now: number): void {
    this.playing = true;
    this.last = now;
    this.played = this.real = this.rest = 0;
    this.factor = this.speed;
  }

  stop(): void {
    this.playing = false;
  }

  goTo(time: number): void {
    this.time = time;
    this.rest = 0;
  }

  /** Moves on to the moment of this frame (`now` in ms); stops at the end of what does not repeat. */
  advance(now: number, motion: Motion): void {
    const passed = Math.max(now - this.last, 0) / 1000;
    this.last = now;
    if (this.rest > 0) return this.stand(passed, motion);
    const step = Math.min(passed, LONGEST_STEP) * this.speed;
    this.time += step;
    this.measure(passed, step);
    if (this.time > motion.end) this.meetEnd(motion);
  }

  private meetEnd(motion: Motion): void {
    const { start, loops } = motion.show;
    if (motion.isPeriodic) {
      this.time = start + ((this.time - start) % (motion.end - start));
      return;
    }
    this.time = motion.end;
    if (loops) this.rest = REST;
    else this.stop();
  }

  /** Lets the last moment stand, so that one sees that what follows is the beginning and not what becomes of it. */
  private stand(passed: number, motion: Motion): void {
    this.rest = Math.max(this.rest - passed, 0);
    if (this.rest === 0) this.time = motion.show.start;
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
