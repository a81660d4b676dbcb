// Values in words.

const MINUS = "−";

/** A value with five significant digits, its width steady while it changes. */
export function figure(value: number | null | undefined): string {
  if (value == null) return "–";
  const size = Math.abs(value);
  if (size !== 0 && (size >= 1e6 || size < 1e-4)) return value.toExponential(3).replaceAll("-", MINUS);
  const decimals = size === 0 ? 0 : Math.max(0, 4 - Math.floor(Math.log10(size)));
  return value.toFixed(decimals).replace("-", MINUS);
}

/** A number of an axis. */
export const tick = (value: number): string => String(Number(value.toPrecision(7))).replace("-", MINUS);
