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

/** A name in so many letters; wide ones count twice. */
export function shortened(name: string, room: number): string {
  const wide = (text: string): number => Array.from(text, (c) => (c > "\u2e7f" ? 2 : 1)).reduce((a, b) => a + b, 0);
  if (wide(name) <= room) return name;
  const letters = Array.from(name);
  while (letters.length > 1 && wide(letters.join("")) > room - 1) letters.pop();
  return `${letters.join("")}…`;
}

/** A number of an axis. */
export const tick = (value: number): string => String(Number(value.toPrecision(7))).replace("-", MINUS);
