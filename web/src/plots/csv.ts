// A plot as a table: the time, the horizontal axis where it is another one, and all curves, in the units of the page.

import { known, type Values } from "../scene/data.ts";
import type { Curves } from "./curves.ts";
import "./of_studies.ts";

const POWERS = "⁰¹²³⁴⁵⁶⁷⁸⁹";

const plain = (digit: string): string => (digit === "⁻" ? "-" : String(POWERS.indexOf(digit)));

/** A unit as files spell it: N*m, mm/s^2. */
export const fileUnit = (unit: string): string =>
  unit
    .replaceAll("·", "*")
    .replaceAll("°", "deg")
    .replace(/⁻?[⁰¹²³⁴⁵⁶⁷⁸⁹]+/g, (power) => `^${Array.from(power, plain).join("")}`);

/** A text in one cell: no end of the line, nothing that a spreadsheet takes for a formula. */
export function cell(value: string): string {
  const line = value.replace(/[\u0000-\u001f\u007f-\u009f\u2028\u2029]+/g, " ");
  const safe = /^[=+\-@\uff1d\uff0b\uff0d\uff20]/.test(line) ? `'${line}` : line;
  return /[",]/.test(safe) ? `"${safe.replaceAll('"', '""')}"` : safe;
}

export const head = (name: string, unit: string): string => cell(unit ? `${name} [${fileUnit(unit)}]` : name);

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
  for (const { name, unit, values, look } of curves) {
    if (!globalThis.WITHOUT_STUDIES && look?.low) {
      columns.push({ name: `${name} min`, unit, values: look.low }, { name: `${name} max`, unit, values });
    } else columns.push({ name, unit, values });
    if (globalThis.WITHOUT_STUDIES || !look?.edges) continue;
    const edges = [0, 1].map((end) => look.edges!.map((pair) => pair[end]!));
    const named = edges.map((values, end) => ({ name: `${x.name} ${end ? "max" : "min"}`, unit: x.unit, values }));
    columns.splice(1, 0, ...named);
  }
  const line = note ? `# ${note.replace(/\s+/g, " ")}\n` : "";
  const text = line + tableText(columns);
  // Spreadsheets take a file without this mark as one of the local encoding.
  return /[^\x00-\x7f]/.test(text) ? `\ufeff${text}` : text;
}

/** Columns of equal length as a table. */
export function tableText(
  columns: readonly { readonly name: string; readonly unit: string; readonly values: Values }[],
): string {
  const rows = [columns.map(({ name, unit }) => head(name, unit)).join(",")];
  for (let k = 0; k < (columns[0]?.values.length ?? 0); k++) {
    rows.push(columns.map(({ values }) => String(known(values, k) ?? "")).join(","));
  }
  return `${rows.join("\n")}\n`;
}
