// Small tools for numbers.

import { known, type Values } from "./data.ts";

/** A value as it is shown: six significant digits. */
export const sixDigits = (value: number): string => String(Number(value.toPrecision(6)));

export const clamp = (value: number, low: number, high: number): number =>
  Math.min(Math.max(value, low), high);

/** Largest of 1, 2, 5 times a power of ten that is not above `value`. */
export function nice(value: number): number {
  const power = 10 ** Math.floor(Math.log10(value) + 1e-9);
  return [5, 2, 1].map((m) => m * power).find((v) => v <= value * (1 + 1e-9)) ?? power;
}

/** The smallest and the largest of values, within some samples; null where there is none. */
export function extent(values: Values, within: (k: number) => boolean = () => true): [number, number] | null {
  let [low, high] = [Infinity, -Infinity];
  for (let k = 0; k < values.length; k++) {
    const value = known(values, k);
    if (value === null || !within(k)) continue;
    if (value < low) low = value;
    if (value > high) high = value;
  }
  return low <= high ? [low, high] : null;
}
