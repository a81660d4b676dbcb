// What the parts of a plane's picture share: the sheet, lines as paths, letters.

import type { Frame } from "./plane_frame.ts";
import type { FieldLayer, Line } from "./study.ts";
import type { Sheet } from "./svg_parts.ts";

export interface PlaneSheet extends Omit<Sheet, "height"> {
  readonly shown: (layer: number) => boolean;
  /** Pixels of a map as the address of a picture; empty where none can be made. */
  readonly picture: (layer: FieldLayer, frame: Frame) => string;
  /** The beginning of the names of parts, of this picture alone. */
  readonly id: string;
}

/** A part as the text of an SVG, and how high it is. */
export interface Drawn {
  readonly inside: string;
  readonly height: number;
}

export const SMALL = { "font-size": 11 } as const;
const LETTER = 6.1;

/** Letters that are read over lines. */
export const halo = (colour: Sheet["colour"]) => ({
  stroke: colour("paper"),
  "stroke-width": 3,
  "paint-order": "stroke",
});

/** Lines as one path. */
export function pathsOf(lines: readonly Line[], { across, up }: Frame, closed = false): string {
  let d = "";
  for (const line of lines) {
    for (let k = 0; k < line.length; k += 2) {
      d += `${k ? "L" : "M"}${across(line[k]!).toFixed(1)} ${up(line[k + 1]!).toFixed(1)}`;
    }
    if (closed) d += "Z";
  }
  return d;
}

/** A text in lines of some width; letters of East Asian scripts are twice as wide as others. */
export function folded(words: string, width: number, letter = LETTER): string[] {
  const wide = (row: string): number => Array.from(row, (c) => (c > "\u2e7f" ? 2 : 1)).reduce((a, b) => a + b, 0);
  const rows = [""];
  for (const part of words.split(/(?<= )|(?<=[\u2e80-\uffff])/u)) {
    if (rows.at(-1) && (wide(rows.at(-1)!) + wide(part.trimEnd())) * letter > width) rows.push("");
    rows[rows.length - 1] += part;
  }
  return rows;
}
