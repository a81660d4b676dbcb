// Small tools for numbers.

/** A value as it is shown: six significant digits. */
export const sixDigits = (value: number): string => String(Number(value.toPrecision(6)));

export const clamp = (value: number, low: number, high: number): number =>
  Math.min(Math.max(value, low), high);

/** Largest of 1, 2, 5 times a power of ten that is not above `value`. */
export function nice(value: number): number {
  const power = 10 ** Math.floor(Math.log10(value) + 1e-9);
  return [5, 2, 1].map((m) => m * power).find((v) => v <= value * (1 + 1e-9)) ?? power;
}
