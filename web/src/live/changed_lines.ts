// The lines of the model file that say what was changed.

import type { LiveModel } from "./live_model.ts";

/** The changed lines, in their order; of each only the digits of its numbers are others. */
export function changedLines(live: LiveModel): string[] {
  const { numbers, lines } = live.data;
  const changed = new Map<number, number[]>();
  numbers.forEach((number, i) => {
    if (live.value(i) !== number.value) {
      changed.set(number.line, [...(changed.get(number.line) ?? []), i]);
    }
  });
  return [...changed]
    .sort(([a], [b]) => a - b)
    .map(([line, which]) => {
      let text = [...lines[line]!];
      // The last number first, so that the columns of those before stay what they are.
      for (const i of which.sort((a, b) => numbers[b]!.start - numbers[a]!.start)) {
        const { start, end, size } = numbers[i]!;
        text = [...text.slice(0, start), ...digits(live.value(i) / size), ...text.slice(end)];
      }
      return text.join("");
    });
}

/** A number as files have it, to twelve digits: finer than any dimension. */
const digits = (value: number): string => String(Number(value.toPrecision(12)));
