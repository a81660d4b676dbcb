// A plane as the text of an SVG: axes, what lies in it layer by layer, the scale of its colours below.

import { known } from "../scene/data.ts";
import { fieldSvg } from "./field_svg.ts";
import { tick } from "./figure.ts";
import { dash } from "./looks.ts";
import type { Frame } from "./plane_frame.ts";
import { type Drawn, halo, pathsOf, type PlaneSheet, SMALL } from "./plane_sheet.ts";
import { hue, scaleSvg } from "./scale_svg.ts";
import type { Layer, Plane, SpotsLayer } from "./study.ts";
import { element, type Sheet, text } from "./svg_parts.ts";

/** How high the picture is. */
export const heightOf = (plane: Plane, frame: Frame, sheet: PlaneSheet): number =>
  frame.height + scaleSvg(plane, frame, sheet).height;

/** The picture without the element around it, and its height. */
export function planeSvg(plane: Plane, frame: Frame, sheet: PlaneSheet): Drawn {
  const { colour, id } = sheet;
  const { left, right, top, bottom } = frame;
  const muted = { ...SMALL, fill: colour("muted") };
  let out = "";
  for (const value of frame.xs) {
    const x = frame.across(value).toFixed(2);
    out += element("path", { d: `M${x} ${top}V${bottom}`, stroke: colour("grid") });
    out += text(tick(value), { x, y: bottom + 14, "text-anchor": "middle", ...muted });
  }
  for (const value of frame.ys) {
    const y = frame.up(value).toFixed(2);
    out += element("path", { d: `M${left} ${y}H${right}`, stroke: colour("grid") });
    out += text(tick(value), { x: left - 5, y: Number(y) + 4, "text-anchor": "end", ...muted });
  }
  const name = plane.equal ? `${plane.x.name}, ${plane.y.label}` : plane.x.label;
  out += text(name, { x: (left + right) / 2, y: bottom + 31, "text-anchor": "middle", ...muted });
  if (!plane.equal) {
    const [x, y] = [11, (top + bottom) / 2];
    out += text(plane.y.label, { x, y, transform: `rotate(-90 ${x} ${y})`, "text-anchor": "middle", ...muted });
  }
  const seen = element("rect", { x: left, y: top, width: right - left, height: bottom - top });
  const area = `<clipPath id="${id}">${seen}</clipPath>`;
  const labels: string[] = [];
  const drawn = plane.layers.map((layer, i) => (sheet.shown(i) ? layerSvg(layer, i, frame, sheet, labels) : ""));
  const limits = plane.limits.map(({ value, text: label }) => {
    const y = frame.up(value);
    const line = element("path", { d: `M${left} ${y}H${right}`, stroke: colour("warn"), "stroke-dasharray": "6 4" });
    const place = { x: right - 4, y: (y - 4).toFixed(2), "text-anchor": "end" };
    return line + text(label, { ...place, ...SMALL, fill: colour("warn"), ...halo(colour) });
  });
  out += `${area}<g clip-path="url(#${id})">${drawn.join("")}${limits.join("")}${labels.join("")}</g>`;
  out += element("path", { d: `M${left} ${top}V${bottom}H${right}`, stroke: colour("line") });
  const below = scaleSvg(plane, frame, sheet);
  return { inside: out + below.inside, height: frame.height + below.height };
}

function layerSvg(layer: Layer, i: number, frame: Frame, sheet: PlaneSheet, labels: string[]): string {
  const { colour } = sheet;
  switch (layer.kind) {
    case "region": {
      const d = pathsOf(layer.lines, frame, true);
      const fill = { fill: colour(layer.colour), "fill-opacity": 0.22, "fill-rule": "evenodd" };
      return element("path", { d, ...fill, stroke: colour(layer.colour), "stroke-opacity": 0.55, "stroke-width": 0.8 });
    }
    case "lines": {
      const d = pathsOf(layer.lines, frame);
      const look = { stroke: colour(layer.colour), "stroke-width": layer.width, "stroke-linejoin": "round" };
      return element("path", { d, ...look, "stroke-dasharray": dash(layer.dash).join(" ") });
    }
    case "coloured": {
      const share = Math.min(1, 72 / Math.max(layer.groups.length, 1)) ** 0.5;
      const look = { "stroke-width": Math.max(0.5, 1.2 * share), "stroke-opacity": Math.max(0.3, 0.85 * share) };
      const paths = layer.groups.map(({ value, lines }) => {
        const stroke = hue(layer.scale, value);
        return element("path", { d: pathsOf(lines, frame), stroke, "stroke-linejoin": "round", ...look });
      });
      return paths.join("");
    }
    case "spots":
      return spots(layer, frame, colour);
    case "field":
      return fieldSvg(layer, `${sheet.id}-${i}`, frame, sheet, labels);
  }
}

function spots(layer: SpotsLayer, frame: Frame, colour: Sheet["colour"]): string {
  const { x, y, values, scale, cross, colour: own } = layer;
  let out = "";
  let d = "";
  const r = y.length > 200 ? 2 : 3;
  for (let k = 0; k < y.length; k++) {
    const [a, b, value] = [known(x, k), known(y, k), values && known(values, k)];
    if (a === null || b === null) continue;
    const [cx, cy] = [frame.across(a), frame.up(b)];
    if (cross) d += `M${(cx - 3).toFixed(1)} ${(cy - 3).toFixed(1)}l6 6m-6 0l6 -6`;
    else if (scale && value !== null) {
      out += element("circle", { cx: cx.toFixed(1), cy: cy.toFixed(1), r, fill: hue(scale, value) });
    }
    else d += `M${(cx - r).toFixed(1)} ${cy.toFixed(1)}a${r} ${r} 0 1 0 ${2 * r} 0a${r} ${r} 0 1 0 ${-2 * r} 0Z`;
  }
  const look = cross ? { stroke: colour(own), "stroke-width": 1.3 } : { fill: colour(own) };
  return out + (d && element("path", { d, ...look }));
}
