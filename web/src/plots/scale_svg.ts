// The colours of a plane with their values, below its axes.

import { tick } from "./figure.ts";
import type { Frame } from "./plane_frame.ts";
import { type Drawn, folded, type PlaneSheet, SMALL } from "./plane_sheet.ts";
import type { Layer, Plane, Scale } from "./study.ts";
import { element, escaped, text } from "./svg_parts.ts";
import { ticks } from "./ticks.ts";

const [LINE, BAR] = [15, 12];

/** The colour of a value on a scale. */
export function hue({ low, high, stops }: Scale, value: number): string {
  const share = high > low ? (value - low) / (high - low) : 0;
  return stops[Math.round(Math.min(Math.max(share, 0), 1) * (stops.length - 1))] ?? "#888888";
}

/** The colours with their values, below the axes. */
export function scaleSvg(plane: Plane, frame: Frame, sheet: PlaneSheet): Drawn {
  const valued = (each: Layer): boolean => each.kind === "field" || ("scale" in each && each.scale !== null);
  const layer = plane.layers.find((each, i) => sheet.shown(i) && valued(each));
  if (!layer) return { inside: "", height: 0 };
  const { left } = frame;
  const wide = Math.min(frame.right - left - 16, 420);
  const muted = { ...SMALL, fill: sheet.colour("muted") };
  const axis = layer.kind === "field" ? layer.axis : (layer as { readonly scale: Scale }).scale.axis;
  const rows = folded(axis.label, frame.right - left);
  let y = frame.height + 10;
  let out = "";
  for (const row of rows) {
    out += text(row, { x: left, y, ...SMALL, fill: sheet.colour("ink") });
    y += LINE;
  }
  y -= 8;
  const mark = (x: number, value: number): string =>
    text(tick(Number(value.toPrecision(6))), { x: x.toFixed(1), y: y + BAR + 13, "text-anchor": "middle", ...muted });
  if (layer.kind === "field") {
    const { levels, colours } = layer.field;
    const each = wide / colours.length;
    const box = { y, width: each.toFixed(2), height: BAR };
    colours.forEach((fill, i) => (out += element("rect", { x: (left + i * each).toFixed(2), ...box, fill })));
    levels.forEach((level, i) => (out += mark(left + (i + 1) * each, level)));
  } else {
    const { low, high, stops } = (layer as { readonly scale: Scale }).scale;
    const name = `${sheet.id}-scale`;
    const parts = stops.map((stop, i) => {
      const offset = `${((100 * i) / (stops.length - 1)).toFixed(1)}%`;
      return `<stop offset="${offset}" stop-color="${escaped(stop)}"/>`;
    });
    out += `<linearGradient id="${name}">${parts.join("")}</linearGradient>`;
    out += element("rect", { x: left, y, width: wide, height: BAR, rx: 2, fill: `url(#${name})` });
    const span = high - low || 1;
    for (const value of ticks(low, high, Math.max(2, Math.round(wide / 60)))) {
      out += mark(left + ((value - low) / span) * wide, value);
    }
  }
  return { inside: out, height: y + BAR + 20 - frame.height };
}
