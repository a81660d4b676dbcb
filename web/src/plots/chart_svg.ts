// A plot as an SVG file: title, axes, curves, marks, legend. It is also what its PNG is made of.

import { type Curve, type Curves, limits, sideExtent } from "./curves.ts";
import { shortened, tick } from "./figure.ts";
import { colourName, colourOf, dashOf } from "./looks.ts";
import "./of_studies.ts";
import { OPACITY, outline } from "./outline.ts";
import { polarSvg } from "./polar.ts";
import { element, escaped, pathOf, type Sheet, text } from "./svg_parts.ts";
import { ticks } from "./ticks.ts";

const [TITLE, NOTE, LINE, BOTTOM] = [26, 16, 18, 40];
const FONTS = "system-ui, 'Segoe UI', Roboto, Arial, 'PingFang SC', 'Microsoft YaHei', 'Noto Sans CJK SC', sans-serif";
/** About how wide a letter is, in pixels of a font of 11 pixels. */
const LETTER = 6.3;

export interface PictureOptions extends Sheet {
  /** What is in sight of the horizontal axis, and which curves. */
  readonly window: readonly [number, number];
  readonly shown: (curve: number) => boolean;
  /** A line below the title, such as that the model was changed; empty for none. */
  readonly note: string;
  /** The sample of the arrows of a polar plot. */
  readonly index: number;
}

/** The text of the file; `height` is that of the curves' area with its axis. */
export function chartSvg(curves: Curves, options: PictureOptions): string {
  const { width, height, colour, note, shown } = options;
  const polar = curves.vectors.length > 0;
  const names = (polar ? curves.vectors : curves.curves).map(({ name }, i) => {
    const unit = curves.units.length > 1 ? ` ${(curves.curves[i] as Curve).unit}` : "";
    return { i, label: name + unit, curve: polar ? {} : curves.curves[i]! };
  });
  const entries = names.filter(({ i }) => polar || shown(i));
  const rows = legendRows(entries, width);
  const top = TITLE + (note ? NOTE : 0);
  const total = top + height + rows.length * LINE + 8;
  const unit = curves.units.length === 1 && curves.units[0] ? `, ${curves.units[0]}` : "";
  let out = element("rect", { width, height: total, fill: colour("paper") });
  out += text(curves.title + unit, { x: 10, y: 18, "font-size": 13, "font-weight": 600, fill: colour("ink") });
  if (note) out += text(note, { x: 10, y: TITLE + 8, "font-size": 11, "font-weight": 600, fill: colour("warn") });
  if (polar) {
    const inner = { ...options, width: width - 20, height: height - 8 };
    const place = `x="10" y="${top}" width="${inner.width}" height="${inner.height}"`;
    out += `<svg ${place}>${polarSvg(curves, options.index, inner)}</svg>`;
  } else out += `<g transform="translate(0 ${top})">${axes(curves, options)}</g>`;
  rows.forEach((row, r) => {
    const y = top + height + r * LINE + 10;
    for (const { i, label, curve, x } of row) {
      out += swatch(curve, i, x, y - 4, colour);
      out += text(label, { x: x + 32, y, "font-size": 11, fill: colour("ink") });
    }
  });
  const head = `xmlns="http://www.w3.org/2000/svg" width="${width}" height="${total}" viewBox="0 0 ${width} ${total}"`;
  const title = escaped(note ? `${curves.title} (${note})` : curves.title);
  return `<svg ${head} font-family="${FONTS}"><title>${title}</title>${out}</svg>\n`;
}

/** Grid, axes, limits, curves and marks, in an area of the sheet's size. */
function axes(curves: Curves, { width, height, colour, window, shown }: PictureOptions): string {
  const side = (right: boolean): [number, number] => {
    const [low, high] = limits(...(sideExtent(curves, right, window, shown) ?? [-1, 1]));
    return [low - 0.06 * (high - low), high + 0.06 * (high - low)];
  };
  const two = curves.units.length > 1;
  const ends = [side(false), ...(two ? [side(true)] : [])];
  const bottom = height - BOTTOM;
  const marks = ends.map(([low, high]) => ticks(low, high, Math.max(2, Math.round(bottom / 38))));
  const longest = marks.map((each) => Math.max(...each.map((value) => tick(value).length), 3));
  const room = longest.map((count) => count * LETTER + 16 + (two ? 15 : 0));
  const [left, right] = [room[0]!, width - (two ? room[1]! : 14)];
  const across = (value: number): number =>
    left + ((value - window[0]) / (window[1] - window[0] || 1)) * (right - left);
  const up = (i: number): ((value: number) => number) => {
    const [low, high] = ends[i]!;
    return (value) => bottom - ((value - low) / (high - low)) * (bottom - 6);
  };
  const level = (y: number): string => `M${left} ${y.toFixed(2)}H${right}`;
  const small = { "font-size": 11, fill: colour("muted") };
  const muted = colour("muted");
  let out = "";
  const { names } = curves;
  for (const value of names ? [] : ticks(window[0], window[1], Math.max(2, Math.round((right - left) / 70)))) {
    const x = across(value).toFixed(2);
    out += element("path", { d: `M${x} 6V${bottom}`, stroke: colour("grid") });
    out += text(tick(value), { x, y: bottom + 14, "text-anchor": "middle", ...small });
  }
  if (!globalThis.WITHOUT_STUDIES) names?.forEach((name, i) => {
    const label = shortened(name, (right - left) / names.length / LETTER);
    out += text(label, { x: across(i + 0.5).toFixed(2), y: bottom + 14, "text-anchor": "middle", ...small });
  });
  marks.forEach((each, i) => {
    for (const value of each) {
      const y = up(i)(value);
      if (i === 0) out += element("path", { d: level(y), stroke: colour(value === 0 ? "line" : "grid") });
      const at = i ? { x: right + 5 } : { x: left - 5, "text-anchor": "end" };
      out += text(tick(value), { ...at, y: (y + 4).toFixed(2), ...small });
    }
    if (two) {
      const x = i ? width - 5 : 12;
      const turn = `rotate(-90 ${x} ${bottom / 2})`;
      out += text(curves.units[i]!, { x, y: bottom / 2, transform: turn, "text-anchor": "middle", ...small });
    }
  });
  out += element("path", { d: `M${left} 6V${bottom}H${right}${two ? "V6" : ""}`, stroke: colour("line") });
  out += text(curves.x.label, { x: (left + right) / 2, y: bottom + 32, "text-anchor": "middle", ...small });
  let inside = "";
  for (const { value, right: onRight, text: label } of curves.levels) {
    const y = up(Number(onRight))(value);
    inside += element("path", { d: level(y), stroke: colour("warn"), "stroke-dasharray": "6 4" });
    const place = { x: right - 4, y: (y - 4).toFixed(2), "text-anchor": "end" };
    inside += text(label, { ...place, "font-size": 11, fill: colour("warn") });
  }
  if (!globalThis.WITHOUT_STUDIES) curves.uprights?.forEach(({ value, text: label }, i) => {
    const x = across(value);
    inside += element("path", { d: `M${x.toFixed(2)} 6V${bottom}`, stroke: colour("warn"), "stroke-dasharray": "6 4" });
    const late = x > (left + right) / 2;
    const place = { x: (x + (late ? -4 : 4)).toFixed(2), y: 16 + 14 * i, "text-anchor": late ? "end" : "start" };
    inside += text(label, { ...place, "font-size": 11, fill: colour("warn") });
  });
  const drawn = curves.curves.map((curve, i) => ({ curve, i })).filter(({ i }) => shown(i));
  for (const { curve } of drawn) {
    if (!curve.ghost) continue;
    const d = pathOf(curves.x.ghost ?? curves.x.values, curve.ghost, across, up(Number(curve.right)));
    inside += element("path", { d, stroke: muted, "stroke-dasharray": "4 3", opacity: 0.75 });
  }
  for (const { curve, i } of drawn) {
    const { look, values } = curve;
    if (!globalThis.WITHOUT_STUDIES && look && look.kind !== "line") {
      const d = outline(look, curves.x.values, values, across, up(Number(curve.right)));
      inside += element("path", { d, fill: colour(colourOf(curve, i)), "fill-opacity": OPACITY[look.kind] });
      continue;
    }
    const d = pathOf(curves.x.values, values, across, up(Number(curve.right)));
    inside += element("path", { d, ...line(curve, i, colour), "stroke-width": 1.7, "stroke-linejoin": "round" });
  }
  for (const { curve, x, y } of curves.marks) {
    if (!shown(curve)) continue;
    const place = { cx: across(x).toFixed(2), cy: up(Number(curves.curves[curve]!.right))(y).toFixed(2) };
    inside += element("circle", { ...place, r: 3.5, fill: colour(colourName(curve)), stroke: colour("paper") });
  }
  // An inner picture ends where its area does.
  const [w, h] = [right - left, bottom - 2];
  const area = `x="${left}" y="2" width="${w}" height="${h}" viewBox="${left} 2 ${w} ${h}"`;
  return `${out}<svg ${area}>${inside}</svg>`;
}

type Drawn = Parameters<typeof colourOf>[0];

const line = (curve: Drawn, i: number, colour: Sheet["colour"]): { stroke: string; "stroke-dasharray": string } => ({
  stroke: colour(colourOf(curve, i)),
  "stroke-dasharray": dashOf(curve, i).join(" "),
});

/** What a curve looks like, in the legend. */
export function swatch(curve: Drawn, i: number, x: number, y: number, colour: Sheet["colour"]): string {
  const kind = curve.look?.kind ?? "line";
  if (globalThis.WITHOUT_STUDIES || kind === "line") {
    return element("path", { d: `M${x} ${y}h26`, ...line(curve, i, colour), "stroke-width": 2 });
  }
  const fill = { fill: colour(colourOf(curve, i)), "fill-opacity": OPACITY[kind] };
  return kind === "dots"
    ? element("circle", { cx: x + 13, cy: y, r: 3, ...fill })
    : element("rect", { x, y: y - 4, width: 26, height: 8, ...fill });
}

/** Entries of a legend in rows of a width. */
export function legendRows<E extends { readonly label: string }>(
  entries: readonly E[],
  width: number,
): (E & { x: number })[][] {
  const rows: (E & { x: number })[][] = [];
  let x = Infinity;
  for (const entry of entries) {
    const wide = 44 + entry.label.length * LETTER;
    if (x + wide > width) {
      rows.push([]);
      x = 10;
    }
    rows.at(-1)!.push({ ...entry, x });
    x += wide;
  }
  return rows;
}
