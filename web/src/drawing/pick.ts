// What lies at a place of the window.

import type { Point } from "../scene/data.ts";
import { locate } from "../scene/times.ts";
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
