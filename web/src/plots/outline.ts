// Bands, bars and dots of a study's chart as paths, the same on a canvas and in an SVG.

import { known, type Values } from "../scene/data.ts";

/** How a curve of a study is drawn: colour, dash by its number, a band from `low` to its values, bars between edges. */
export interface Look {
  readonly kind: "line" | "dots" | "band" | "strong" | "bars";
  readonly colour: string;
  readonly dash: number;
  readonly low?: Values;
  readonly edges?: readonly (readonly [number, number])[];
}

/** How much of the colour a filled look has. */
export const OPACITY: Readonly<Record<Look["kind"], number>> = { line: 1, dots: 1, band: 0.2, strong: 0.4, bars: 0.75 };

/** What is filled; empty for a line. `unit`: a pixel of the screen. */
export function outline(
  look: Look,
  x: Values,
  y: Values,
  across: (value: number) => number,
  up: (value: number) => number,
  unit = 1,
): string {
  const at = (value: number): string => value.toFixed(2);
  let d = "";
  if (look.kind === "dots") {
    const r = (y.length > 200 ? 1.6 : 2.5) * unit;
    for (let k = 0; k < y.length; k++) {
      const [a, b] = [known(x, k), known(y, k)];
      if (a === null || b === null) continue;
      d += `M${at(across(a) - r)} ${at(up(b))}a${r} ${r} 0 1 0 ${2 * r} 0a${r} ${r} 0 1 0 ${-2 * r} 0Z`;
    }
  }
  look.edges?.forEach(([from, to], k) => {
    const value = known(y, k);
    if (value === null) return;
    const [left, right] = [across(from), across(to)];
    const width = Math.max(right - left - 0.5 * unit, 0.5 * unit);
    d += `M${at(left)} ${at(up(0))}V${at(up(value))}h${at(width)}V${at(up(0))}Z`;
  });
  if (look.low) {
    for (const [first, last] of runs(x, y, look.low)) {
      let back = "";
      for (let k = first; k <= last; k++) {
        d += `${k === first ? "M" : "L"}${at(across(x[k]!))} ${at(up(y[k]!))}`;
        back = `L${at(across(x[k]!))} ${at(up(look.low[k]!))}${back}`;
      }
      d += `${back}Z`;
    }
  }
  return d;
}

/** The unbroken runs of samples that all rows have. */
function* runs(...rows: Values[]): Generator<[number, number]> {
  let from = -1;
  const count = rows[0]!.length;
  for (let k = 0; k <= count; k++) {
    const here = k < count && rows.every((row) => known(row, k) !== null);
    if (here && from < 0) from = k;
    if (!here && from >= 0) {
      yield [from, k - 1];
      from = -1;
    }
  }
}
