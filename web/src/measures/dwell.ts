// How long a signal dwells: the longest time in which it stays within a band, placed where that begins. As
// src/linkwright/reductions/dwell.py on the cubics.

import type { Figures, Interval, OnSamples } from "./measure.ts";
import { rowOf } from "./measure.ts";
import type { Interpolant } from "./samples.ts";

/** How many places of the band are looked at together, and how often closer around the best of them. */
const LEVELS = 33;
const ZOOMS = 8;

export function dwell(samples: OnSamples): Figures {
  const width = samples.numbers["within"] ?? NaN;
  let best: Interval = [0, -1];
  for (const [a, b] of samples.stretches) {
    const stretch = new TurningCourse(rowOf(samples), a, b).longest(width);
    if (stretch[1] - stretch[0] > best[1] - best[0]) best = stretch;
  }
  return { "": { value: best[1] - best[0], time: best[0] } };
}

/** A signal between its turning points: monotone in between. */
class TurningCourse {
  readonly signal: Interpolant;
  readonly times: number[];
  readonly heights: number[];
  readonly slack: number;

  constructor(signal: Interpolant, a: number, b: number) {
    this.signal = signal;
    const { times, values } = signal.turning(a, b);
    this.times = times;
    this.heights = values;
    this.slack = 1e-13 * values.reduce((size, value) => Math.max(size, Math.abs(value)), 0);
  }

  /** The longest stretch of time (s) in which the signal varies by `width` at most; the first of equals.
   *
   * Where it is longest, its band begins or ends at a turning point or an end inside the stretch, or the signal passes
   * through the band, as fast where it leaves as where it came in. */
  longest(width: number): Interval {
    const found = [...this.around(width), ...this.passing(width)];
    let most = -Infinity;
    for (const [a, b] of found) most = Math.max(most, b - a);
    let best: Interval = [Infinity, Infinity];
    for (const one of found) {
      if (!(one[1] - one[0] >= most * (1 - 1e-9))) continue;
      if (one[0] < best[0] || (one[0] === best[0] && one[1] < best[1])) best = one;
    }
    return best;
  }

  /** The stretches whose band begins or ends at a turning point. */
  private around(width: number): Interval[] {
    const y = this.heights;
    const last = y.length - 1;
    return y.map((height, i) => {
      const top = i < last ? height > y[i + 1]! : height > y[i - 1]!;
      const low = top ? height - width : height;
      const high = top ? height : height + width;
      return [this.exit(i, -1, low, high), this.exit(i, 1, low, high)];
    });
  }

  /** From the turning point i on, the time at which the signal leaves the band; the end of the run where it doesn't. */
  private exit(i: number, step: number, low: number, high: number): number {
    const y = this.heights;
    const slack = this.slack;
    const inside = (k: number): boolean => k >= 0 && k < y.length;
    while (inside(i + step) && low - slack <= y[i + step]! && y[i + step]! <= high + slack) i += step;
    if (!inside(i + step)) return step > 0 ? this.times[this.times.length - 1]! : this.times[0]!;
    return this.when(Math.min(i, i + step), y[i + step]! < low ? low : high);
  }

  /** The longest stretch of each way through a band of which neither edge is a turning point inside. */
  private passing(width: number): Interval[] {
    const found: Interval[] = [];
    for (const sign of [1, -1]) {
      for (const way of this.ways(sign, width)) {
        let [first, last, low, high] = way;
        let best: Interval = [NaN, NaN];
        for (let zoom = 0; zoom < ZOOMS; zoom++) {
          const step = (high - low) / (LEVELS - 1);
          const levels = Array.from({ length: LEVELS }, (_, k) => (k < LEVELS - 1 ? k * step + low : high));
          let at = 0;
          levels.forEach((level, k) => {
            const came = this.when(first, sign * level);
            const left = this.when(last, sign * (level + width));
            if (k === 0 || left - came > best[1] - best[0]) {
              best = [came, left];
              at = k;
            }
          });
          low = levels[Math.max(at - 1, 0)]!;
          high = levels[Math.min(at + 1, LEVELS - 1)]!;
        }
        found.push(best);
      }
    }
    return found;
  }

  /** Pairs of rising pieces between which the signal can stay in a band, with the range of its lower edge. */
  private ways(sign: number, width: number): [number, number, number, number][] {
    const y = this.heights.map((height) => sign * height);
    const found: [number, number, number, number][] = [];
    for (let i = 0; i + 1 < y.length; i++) {
      if (!(y[i]! < y[i + 1]!)) continue;
      let least = Infinity;
      let most = -Infinity;
      for (let j = i; j + 1 < y.length; j++) {
        if (j > i) {
          least = Math.min(least, y[j]!);
          most = Math.max(most, y[j]!);
        }
        if (most - least > width) break;
        const low = Math.max(y[i]!, y[j]! - width, most - width);
        const high = Math.min(y[i + 1]!, y[j + 1]! - width, least);
        if (y[j]! < y[j + 1]! && low < high) found.push([i, j, low, high]);
      }
    }
    return found;
  }

  /** The time (s) at which the signal has a level on a piece; the nearer end where it hasn't. */
  private when(piece: number, level: number): number {
    return this.signal.when(this.times[piece]!, this.times[piece + 1]!, level);
  }
}
