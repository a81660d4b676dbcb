// What lies at a place of the window.

import type { ArrowKind, Point } from "../scene/data.ts";
import { clamp } from "../scene/numbers.ts";
import { locate } from "../scene/times.ts";
import { type Arrow, arrowScale, beginning, vectorOf } from "./arrows.ts";
import type { Pin } from "./pins.ts";
import { place, poseOf } from "./poses.ts";
import type { Facts } from "./survey.ts";
import type { View } from "./view.ts";

/** A place of the window in the drawing's own pixels. */
export function onPicture(drawing: SVGSVGElement, x: number, y: number): Point {
  const { left, top, width } = drawing.getBoundingClientRect();
  const scale = drawing.viewBox.baseVal.width / (width || 1);
  return [(x - left) * scale, (y - top) * scale];
}

/** The pin next to a place of the drawing at a time, none farther away than `within` pixels. */
export function pinAt(
  facts: Facts,
  view: View,
  times: readonly number[],
  time: number,
  [x, y]: Point,
  within: number,
): Pin | null {
  const { k, f } = locate(times, time);
  let best: Pin | null = null;
  let least = within;
  for (const pin of facts.pins) {
    for (const { link, local } of pin.places) {
      const pose = poseOf(link, times, k, f);
      if (!pose) continue;
      const [px, py] = view.toScreen(place(pose, local));
      const off = Math.hypot(px - x, py - y);
      if (off < least) [best, least] = [pin, off];
    }
  }
  return best;
}

/** The arrow next to a place of the drawing at a time, among those of the kinds that are seen, by factors of their
 * usual length; none farther away than `within` pixels. */
export function arrowAt(
  facts: Facts,
  view: View,
  factors: ReadonlyMap<ArrowKind, number>,
  time: number,
  at: Point,
  within: number,
): Arrow | null {
  const { k, f } = locate(facts.times, time);
  let best: Arrow | null = null;
  let least = within;
  for (const arrow of facts.arrows) {
    const factor = factors.get(arrow.data.kind);
    const from = factor === undefined ? null : beginning(arrow, facts.times, k, f);
    const vector = from && vectorOf(arrow, facts.times, k, f);
    if (factor === undefined || !from || vector === null) continue;
    const scale = arrowScale(facts.longest, arrow.data.kind, factor, view.width);
    const off = away(at, view.toScreen(from), vector, scale);
    if (off < least) [best, least] = [arrow, off];
  }
  return best;
}

/** How far a place lies from the line of an arrow, all on the screen. */
function away([x, y]: Point, [px, py]: Point, vector: Point | number, scale: number): number {
  const [dx, dy] = [x - px, y - py];
  if (typeof vector === "number") return Math.abs(Math.hypot(dx, dy) - Math.abs(scale * vector));
  const [vx, vy] = [scale * vector[0], -scale * vector[1]];
  const share = clamp((dx * vx + dy * vy) / (vx * vx + vy * vy || 1), 0, 1);
  return Math.hypot(dx - share * vx, dy - share * vy);
}
