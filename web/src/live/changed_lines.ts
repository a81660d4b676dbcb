// The lines of the model file that say what was changed.

import type { LiveData } from "./live_data.ts";
import type { LiveModel } from "./live_model.ts";

/** The changed lines, in their order; of each only the digits of its numbers are others. What followed from the sketch
 * is a further parameter. */
export function changedLines(live: LiveModel): string[] {
  const { numbers, lines, entry } = live.data;
  const changed = new Map<number, number[]>();
  const stated: string[] = [];
  numbers.forEach((number, i) => {
    if (!live.moved(i)) return;
    if (number.drawn) stated.push(`${number.name}: ${digits(live.value(i) / number.size)}${entry!.unit}`);
    else changed.set(number.line, [...(changed.get(number.line) ?? []), i]);
  });
  const texts = new Map<number, string>();
  for (const [line, which] of changed) {
    let text = [...lines[line]!];
    // The last number first, so that the columns of those before stay what they are.
    for (const i of which.sort((a, b) => numbers[b]!.start - numbers[a]!.start)) {
      const { start, end, size } = numbers[i]!;
      text = [...text.slice(0, start), ...digits(live.value(i) / size), ...text.slice(end)];
    }
    texts.set(line, text.join(""));
  }
  if (!stated.length) return inOrder(texts);
  const line = entry!.line ?? null;
  if (line === null) return [...inOrder(texts), `parameters: {${stated.join(", ")}}`];
  texts.set(line, withEntries(texts.get(line) ?? lines[line]!, stated, entry!));
  return inOrder(texts);
}

const inOrder = (texts: ReadonlyMap<number, string>): string[] =>
  [...texts].sort(([a], [b]) => a - b).map(([, text]) => text);

/** The line of the parameters with further ones: within its braces, or below it. */
function withEntries(
  text: string,
  stated: readonly string[],
  { column, indent }: NonNullable<LiveData["entry"]>,
): string {
  if (indent) return [text, ...stated.map((one) => `${indent}${one}`)].join("\n");
  const letters = [...text];
  const rest = letters.slice(column).join("");
  return `${letters.slice(0, column).join("")}${stated.join(", ")}, ${rest}`;
}

/** A number as files have it, to twelve digits: finer than any dimension. */
const digits = (value: number): string => String(Number(value.toPrecision(12)));
