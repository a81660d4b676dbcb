// Numbers in letters, as presentation/chart_data.py writes them.

const NUMBERS = new Map(
  Array.from("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/", (letter, i) => [letter, i]),
);
const STEPS = 4094;

/** Values, two letters each: 0 is none, then from the low end to the high one, by even steps or even ratios. */
export function unpacked(packed: string, low: number, high: number, ratios: boolean): (number | null)[] {
  return Array.from({ length: packed.length / 2 }, (_, k) => {
    const number = 64 * NUMBERS.get(packed[2 * k]!)! + NUMBERS.get(packed[2 * k + 1]!)!;
    const share = (number - 1) / STEPS;
    if (number === 0) return null;
    return ratios ? low * (high / low) ** share : low + share * (high - low);
  });
}

/** A line of whole steps, each from the place before, as places x, y, x, y and so on. */
export function placed(path: string, fine: number): Float64Array {
  const steps: number[] = [];
  let [number, size] = [0, 1];
  for (const letter of path) {
    const digit = NUMBERS.get(letter)!;
    number += (digit % 32) * size;
    size *= 32;
    if (digit >= 32) continue;
    steps.push(number % 2 ? -(number + 1) / 2 : number / 2);
    [number, size] = [0, 1];
  }
  const found = new Float64Array(steps.length);
  const at = [0, 0];
  steps.forEach((step, k) => {
    at[k % 2]! += step;
    found[k] = at[k % 2]! * fine;
  });
  return found;
}
