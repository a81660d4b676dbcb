// A plot as a table: the time, the horizontal axis where it is another one, and all curves, in the units of the page.

import { known, type Values } from "../scene/data.ts";
import type { Curves } from "./curves.ts";

const POWERS = "⁰¹²³⁴⁵⁶⁷⁸⁹";

const plain = (digit: string): string => (digit === "⁻" ? "-" : String(POWERS.indexOf(digit)));

/** A unit as files spell it: N*m, mm/s^2. */
export const fileUnit = (unit: string): string =>
  unit
    .replaceAll("·", "*")
    .replaceAll("°", "deg")
    .replace(/⁻?[⁰¹²³⁴⁵⁶⁷⁸⁹]+/g, (power) => `^${Array.from(power, plain).join("")}`);

/** A text in one cell: no end of the line, nothing that a spreadsheet takes for a formula. */
function cell(value: string): string {
  const line = value.replace(/[\u0000-\u001f\u007f-\u009f\u2028\u2029]+/g, " ");
  const safe = /^[=+\-@\uff1d\uff0b\uff0d\uff20]/.test(line) ? `'${line}` : line;
  return /[",]/.test(safe) ? `"${safe.replaceAll('"', '""')}"` : safe;
}

const head = (name: string, unit: string): string => cell(unit ? `${name} [${fileUnit(unit)}]` : name);

/** `time`: the axis of times. `note`: a line before the table, such as that the model was changed; empty for none. */
export function csvText(
  { x, curves, vectors }: Curves,
  time: { readonly name: string; readonly unit: string; readonly values: Values },
  note: string,
): string {
  const columns: { name: string; unit: string; values: Values }[] = [time];
  if (x.values !== time.values) columns.push(x);
  for (const { name, x: u, y: v } of vectors) {
    const unit = curves[0]?.unit ?? "";
    columns.push({ name: `${name} x`, unit, values: u }, { name: `${name} y`, unit, values: v });
  }
  columns.push(...curves);
  const rows = [columns.map(({ name, unit }) => head(name, unit)).join(",")];
  for (let k = 0; k < time.values.length; k++) {
    rows.push(columns.map(({ values }) => String(known(values, k) ?? "")).join(","));
  }
  const line = note ? `# ${note.replace(/\s+/g, " ")}\n` : "";
  return `${line}${rows.join("\n")}\n`;
}
