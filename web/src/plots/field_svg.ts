// A field in a plane: bands of colours, lines between them with their values, lines of limits.

import { tick } from "./figure.ts";
import { isolines } from "./isolines.ts";
import type { Frame } from "./plane_frame.ts";
import { pathsOf, type PlaneSheet, SMALL } from "./plane_sheet.ts";
import type { FieldLayer, Line, Place } from "./study.ts";
import { element, text } from "./svg_parts.ts";

/** Pixels between values of lines; of a line that has one. */
const [APART, SHORT] = [34, 40];

/** `id` names its parts; `labels` gets the texts, which lie over all layers. */
export function fieldSvg(
  layer: FieldLayer,
  id: string,
  frame: Frame,
  sheet: PlaneSheet,
  labels: string[],
): string {
  const { colour } = sheet;
  const { left, right, top, bottom } = frame;
  const address = sheet.picture(layer, frame);
  const place = `x="${left}" y="${top}" width="${right - left}" height="${bottom - top}"`;
  let out = address && `<image ${place} preserveAspectRatio="none" href="${address}"/>`;
  const taken: Place[] = [];
  const lines = (level: number): Line[] => isolines(layer.field.finer(level)).sort((a, b) => b.length - a.length);
  const label = (line: Line, words: string, fill: string): void => {
    const at = labelPlace(line, frame, taken);
    if (!at) return;
    taken.push(at);
    const attributes = { x: at[0].toFixed(1), y: (at[1] + 4).toFixed(1), "text-anchor": "middle", ...SMALL };
    labels.push(text(words, { ...attributes, fill, stroke: "#fff", "stroke-width": 2.5, "paint-order": "stroke" }));
  };
  for (const { value, text: words } of layer.limits) {
    const found = lines(value);
    const look = { stroke: "#b3261e", "stroke-width": 2.2, "stroke-dasharray": "6 3" };
    out += element("path", { d: pathsOf(found, frame), stroke: "#fff", "stroke-width": 3.6, "stroke-opacity": 0.7 });
    out += element("path", { d: pathsOf(found, frame), ...look });
    if (found[0]) label(found[0], words, "#b3261e");
  }
  for (const level of layer.field.levels) {
    if (layer.limits.some(({ value }) => Math.abs(value - level) <= 1e-9 * Math.abs(level))) continue;
    const found = lines(level);
    out += element("path", { d: pathsOf(found, frame), stroke: "#000", "stroke-opacity": 0.55, "stroke-width": 0.8 });
    for (const line of found) label(line, tick(Number(level.toPrecision(5))), "#000");
  }
  if (!layer.lines.length) return out;
  const clip = `<clipPath id="${id}"><path clip-rule="evenodd" d="${pathsOf(layer.lines, frame, true)}"/></clipPath>`;
  const edge = element("path", { d: pathsOf(layer.lines, frame, true), stroke: colour("ink"), "stroke-opacity": 0.6 });
  return `${clip}<g clip-path="url(#${id})">${out}</g>${edge}`;
}

/** Where a line's value stands: in the middle of what is seen of a line that is long enough, away from others. */
function labelPlace(line: Line, frame: Frame, taken: readonly Place[]): Place | null {
  const { across, up, left, right, top, bottom } = frame;
  const seen: [number, number][] = [];
  let length = 0;
  for (let k = 0; k < line.length; k += 2) {
    const [x, y] = [across(line[k]!), up(line[k + 1]!)];
    if (x < left + 18 || x > right - 18 || y < top + 12 || y > bottom - 8) continue;
    const before = seen.at(-1);
    if (before) length += Math.hypot(x - before[0], y - before[1]);
    seen.push([x, y]);
  }
  if (length < SHORT) return null;
  for (const share of [0.5, 0.3, 0.7, 0.15, 0.85]) {
    const at = seen[Math.floor(share * (seen.length - 1))]!;
    if (taken.every(([x, y]) => Math.hypot(x - at[0], y - at[1]) > APART)) return at;
  }
  return null;
}
