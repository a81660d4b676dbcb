// How fast a drawing plays.

import { nice } from "../scene/numbers.ts";

/** Seconds of the units of time that play in real time. */
export const SECONDS: Readonly<Record<string, number>> = { s: 1, ms: 1e-3, min: 60, h: 3600 };

export interface Speeds {
  readonly usual: number;
  readonly list: readonly number[];
}

/** Speeds to offer for a cycle of some seconds, as multiples of real time, and the one to start with. */
export function speeds(seconds: number): Speeds {
  const usual = seconds >= 1 && seconds <= 12 ? 1 : nice(seconds / 4);
  const list = [0.1, 0.2, 0.5, 1, 2, 5].map((m) => Number((m * usual).toPrecision(2)));
  return { usual, list: [...new Set([...list, 1])].sort((a, b) => a - b) };
}
