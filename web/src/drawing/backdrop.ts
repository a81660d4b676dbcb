// What does not move: grid, scale bar, ground symbols and fixed guides.

import { nice } from "../scene/numbers.ts";
import { svg, write } from "./elements.ts";
import { BLOCK, type Guide } from "./guides.ts";
import type { Pin } from "./pins.ts";
import { place, poseOf } from "./poses.ts";
import type { Facts } from "./survey.ts";
import type { View } from "./view.ts";
import { degrees, inPath, round } from "./written.ts";

export function backdrop(facts: Facts, view: View, parent: Element): void {
  const step = nice(110 / view.k);
  grid(view, step, svg("g", { class: "lw-grid" }, parent));
  scaleBar(view, step, facts.scene.length_unit, parent);
  for (const joint of facts.guides) if (joint.guide.link.fixed) rail(joint, facts, view, parent);
  for (const pin of facts.pins) ground(pin, facts, view, parent);
}

/** Lines at multiples of `step`; those through the origin are named. */
function grid({ width, height, toScreen, toWorld }: View, step: number, parent: Element): void {
  const [left, top] = toWorld([0, 0]);
  const [right, bottom] = toWorld([width, height]);
  for (let i = Math.ceil(left / step); i * step < right; i++) {
    const x = round(toScreen([i * step, 0])[0]);
    svg("path", { d: `M${x} 0V${height}`, class: i ? "" : "lw-axis" }, parent);
    if (!i) write(svg("text", { x: x + 5, y: 13 }, parent), "y");
  }
  for (let i = Math.ceil(bottom / step); i * step < top; i++) {
    const y = round(toScreen([0, i * step])[1]);
    svg("path", { d: `M0 ${y}H${width}`, class: i ? "" : "lw-axis" }, parent);
    if (!i) write(svg("text", { x: width - 12, y: y - 5 }, parent), "x");
  }
}

function scaleBar({ k, height }: View, step: number, unit: string, parent: Element): void {
  const bar = svg("g", { class: "lw-scale", transform: `translate(14 ${height - 14})` }, parent);
  svg("path", { d: `M0 -5v5h${round(step * k)}v-5` }, bar);
  const value = Number(step.toPrecision(6));
  write(svg("text", { x: round((step * k) / 2), y: -6 }, bar), `${value} ${unit}`);
}

/** A guide in the ground: its centre line, and hatching along the block's travel, never above the block. */
function rail({ guide, low, high }: Guide, facts: Facts, view: View, parent: Element): void {
  const pose = poseOf(guide.link, facts.times, 0);
  if (!pose) return;
  let turn = Math.atan2(pose.s, pose.c) + guide.angle;
  const flip = Math.cos(turn) < -1e-9 || (Math.abs(Math.cos(turn)) < 1e-9 && turn < 0);
  if (flip) turn += Math.PI;
  const [from, to] = flip ? [-high * view.k, -low * view.k] : [low * view.k, high * view.k];
  const at = inPath(view.toScreen(place(pose, guide.local)));
  const axes = svg("g", { transform: `translate(${at}) rotate(${degrees(turn)})` }, parent);
  const spare = BLOCK.length / 2 + 8;
  const [start, end] = [round(Math.min(0, from - spare)), round(Math.max(0, to + spare))];
  svg("path", { class: "lw-centre", d: `M${start} 0H${end}` }, axes);
  hatch(axes, from - spare, to - from + 2 * spare, BLOCK.height / 2 + 2);
}

/** The symbol of a pin in the ground, or a cross at a point of it. */
function ground(pin: Pin, facts: Facts, view: View, parent: Element): void {
  const fixed = pin.places.find(({ link }) => link.fixed);
  const pose = fixed && poseOf(fixed.link, facts.times, 0);
  if (!pose) return;
  const mark = svg("g", { transform: `translate(${inPath(view.toScreen(place(pose, fixed.local)))})` }, parent);
  if (!pin.joints.length) svg("path", { class: "lw-ground", d: "M-5 0H5M0 -5V5" }, mark);
  else {
    svg("path", { class: "lw-pivot", d: "M0 0L-11 18H11Z" }, mark);
    hatch(mark, -16, 32, 18);
  }
}

/** Hatching of fixed ground: a line of `length` along x, with strokes below it. */
function hatch(parent: Element, x: number, length: number, y: number): void {
  let d = `M${round(x)} ${y}h${round(length)}`;
  for (let s = x + 5; s <= x + length + 0.1; s += 7) d += `M${round(s)} ${y}l-6 7`;
  svg("path", { class: "lw-ground", d }, parent);
}
