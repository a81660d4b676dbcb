// The hodograph of vectors, as the text of an SVG: their tips over the motion, one scale for both axes, and an arrow to
// where they are at the moment.

import { known, type Values } from "../scene/data.ts";
import type { Curves, Vector } from "./curves.ts";
import { tick } from "./figure.ts";
import { colourName, dash } from "./looks.ts";
import { extent } from "../scene/numbers.ts";
import { element, pathOf, type Sheet, text } from "./svg_parts.ts";
import { ticks } from "./ticks.ts";

const MARGIN = 14;

/** Where a vector's tip is drawn. */
export interface PolarView {
  readonly x: (value: number) => number;
  readonly y: (value: number) => number;
  readonly step: readonly number[];
}

/** A view with the origin and all tips in it. */
export function polarView(vectors: readonly Vector[], width: number, height: number): PolarView {
  const ends = (rows: readonly Values[]): [number, number] => {
    const found = rows.map((row) => extent(row)).filter((each) => each !== null);
    return [Math.min(0, ...found.map(([low]) => low)), Math.max(0, ...found.map(([, high]) => high))];
  };
  const [x0, x1] = ends(vectors.flatMap(({ x, ghost }) => (ghost ? [x, ghost.x] : [x])));
  const [y0, y1] = ends(vectors.flatMap(({ y, ghost }) => (ghost ? [y, ghost.y] : [y])));
  const room = [width - 2 * MARGIN - 8, height - 2 * MARGIN] as const;
  const largest = Math.max(x1 - x0, y1 - y0) || 1;
  const per = Math.min(room[0] / Math.max(x1 - x0, 1e-3 * largest), room[1] / Math.max(y1 - y0, 1e-3 * largest));
  const [cx, cy] = [width / 2 - (per * (x0 + x1)) / 2, height / 2 + (per * (y0 + y1)) / 2];
  const reach = Math.max(width, height) / per;
  const step = ticks(-reach, reach, 2 * Math.ceil((reach * per) / 56));
  return { x: (value) => cx + per * value, y: (value) => cy - per * value, step };
}

/** `index`: the sample of the arrows; null for none. */
export function polarSvg({ vectors, units }: Curves, index: number | null, sheet: Sheet): string {
  const { width, height, colour } = sheet;
  const view = polarView(vectors, width, height);
  const [ox, oy] = [view.x(0), view.y(0)];
  const inside = (at: number, end: number): boolean => at > 4 && at < end - 4;
  let out = "";
  for (const value of view.step) {
    const [x, y] = [view.x(value), view.y(value)];
    const stroke = colour(value === 0 ? "muted" : "grid");
    if (inside(x, width)) out += element("path", { d: `M${round(x)} 0V${height}`, stroke });
    if (inside(y, height)) out += element("path", { d: `M0 ${round(y)}H${width}`, stroke });
  }
  const below = oy + 13 < height ? oy + 13 : oy - 4;
  const beside = ox > 40 ? ox - 4 : ox + 4;
  const style = { "font-size": 11, fill: colour("muted") };
  for (const value of view.step) {
    if (value === 0) continue;
    const [x, y] = [view.x(value), view.y(value)];
    if (inside(x - 14, width - 28)) {
      out += text(tick(value), { x: round(x), y: round(below), "text-anchor": "middle", ...style });
    }
    if (inside(y - 4, height - 8)) {
      const anchor = ox > 40 ? "end" : "start";
      out += text(tick(value), { x: round(beside), y: round(y + 4), "text-anchor": anchor, ...style });
    }
  }
  out += text(`x, ${units[0] ?? ""}`, { x: width - 4, y: round(oy - 5), "text-anchor": "end", ...style });
  out += text("y", { x: round(ox + 5), y: 11, ...style });
  vectors.forEach(({ x, y, ghost }, i) => {
    const tips = (u: Values, v: Values): string => pathOf(u, v, view.x, view.y);
    const stroke = colour(colourName(i));
    if (ghost) {
      const faint = { stroke: colour("muted"), "stroke-dasharray": "4 3", opacity: 0.75 };
      out += element("path", { d: tips(ghost.x, ghost.y), ...faint });
    }
    out += element("path", { d: tips(x, y), stroke, "stroke-width": 1.7, "stroke-dasharray": dash(i).join(" ") });
    const d = index === null ? "" : arrow(view, known(x, index), known(y, index));
    out += element("path", { class: "arrow", d, stroke, "stroke-width": 2, fill: stroke, "stroke-linejoin": "round" });
  });
  return out;
}

/** The paths of arrows, in the order of the vectors. */
export const arrows = (vectors: readonly Vector[], index: number, width: number, height: number): string[] => {
  const view = polarView(vectors, width, height);
  return vectors.map(({ x, y }) => arrow(view, known(x, index), known(y, index)));
};

function arrow(view: PolarView, u: number | null, v: number | null): string {
  if (u === null || v === null) return "";
  const [x0, y0, x1, y1] = [view.x(0), view.y(0), view.x(u), view.y(v)];
  const length = Math.hypot(x1 - x0, y1 - y0);
  if (length < 1e-9) return "";
  const [c, s] = [(x1 - x0) / length, (y1 - y0) / length];
  const head = Math.min(9, length);
  const wing = (side: number): string =>
    `${round(x1 - head * c - side * 0.4 * head * s)} ${round(y1 - head * s + side * 0.4 * head * c)}`;
  return `M${round(x0)} ${round(y0)}L${round(x1)} ${round(y1)}M${round(x1)} ${round(y1)}L${wing(1)}L${wing(-1)}Z`;
}

const round = (value: number): number => Math.round(value * 100) / 100;
