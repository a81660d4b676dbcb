// Round numbers along an axis.

import { nice } from "../scene/numbers.ts";

/** Multiples of a round step between two ends, about `count` of them. */
export function ticks(low: number, high: number, count: number): number[] {
  if (!(high > low)) return [low];
  let step = nice((high - low) / Math.max(count, 1));
  while ((high - low) / step > 1.6 * count) step = nice(step * 2.51);
  const found: number[] = [];
  for (let i = Math.ceil(low / step - 1e-9); i * step <= high + 1e-9 * step; i++) {
    found.push(Number((i * step).toPrecision(12)));
  }
  return found;
}
