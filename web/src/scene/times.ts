// Where a time lies among increasing times.

import { clamp } from "./numbers.ts";

/** The samples [low, high] next to each other around a time; outside, those of the nearer end. */
function around(times: readonly number[], t: number): [low: number, high: number] {
  let [low, high] = [0, times.length - 1];
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (times[middle]! <= t) low = middle;
    else high = middle;
  }
  return [low, high];
}

/** The sample that is nearest to a time. */
export function nearest(times: readonly number[], t: number): number {
  const [low, high] = around(times, t);
  return t > (times[low]! + times[high]!) / 2 ? high : low;
}

/** A time as sample k and fraction f of the way to the next, and the nearest sample. */
export interface Located {
  readonly k: number;
  readonly f: number;
  readonly nearest: number;
}

export function locate(times: readonly number[], t: number): Located {
  const [low, high] = around(times, t);
  if (high === low) return { k: 0, f: 0, nearest: 0 };
  const f = clamp((t - times[low]!) / (times[high]! - times[low]! || 1), 0, 1);
  return f === 1 ? { k: high, f: 0, nearest: high } : { k: low, f, nearest: f < 0.5 ? low : high };
}
