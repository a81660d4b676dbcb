// From the world to the screen.

import type { Point } from "../scene/data.ts";
import { set, shown } from "./elements.ts";
import type { Pose } from "./poses.ts";
import type { Box, Facts } from "./survey.ts";
import { inPath, round } from "./written.ts";

/** Room around the mechanism, in pixels. */
const PAD = { x: 46, top: 44, bottom: 58 };

/** Moves a part of the drawing to sample k + f. */
export type Move = (sample: number, f: number) => void;

/** A scale of k pixels a length unit, and a drawing's size in pixels. */
export interface View {
  readonly k: number;
  readonly width: number;
  readonly height: number;
  readonly toScreen: (at: Point) => Point;
  readonly toWorld: (at: Point) => Point;
}

/** The view that fits a box of the world in a drawing `width` wide and at most `most` high. */
export function fit(facts: Facts, width: number, most: number, { x0, x1, y0, y1 }: Box = facts.box, least = 200): View {
  const [wide, high] = [Math.max(x1 - x0, facts.size * 1e-3), Math.max(y1 - y0, facts.size * 1e-3)];
  const [roomX, roomY] = [Math.max(width - 2 * PAD.x, 50), most - PAD.top - PAD.bottom];
  const k = Math.min(roomX / wide, roomY / high);
  const height = Math.round(Math.max(k * high + PAD.top + PAD.bottom, least));
  const ox = width / 2 - (k * (x0 + x1)) / 2;
  const oy = (PAD.top + height - PAD.bottom) / 2 + (k * (y0 + y1)) / 2;
  const toScreen = ([x, y]: Point): Point => [ox + k * x, oy - k * y];
  const toWorld = ([x, y]: Point): Point => [(x - ox) / k, (oy - y) / k];
  return { k, width, height, toScreen, toWorld };
}

/** Whether two views show the world alike. */
export function sameView(a: View, b: View): boolean {
  const [[x, y], [u, v]] = [a.toScreen([0, 0]), b.toScreen([0, 0])];
  return a.k === b.k && a.width === b.width && a.height === b.height && x === u && y === v;
}

/** Moves what is drawn in a link's axes to its pose; without one it is out of sight. */
export function putShape(shape: SVGGraphicsElement, pose: Pose | null, view: View): void {
  shown(shape, pose !== null);
  if (!pose) return;
  const turn = [pose.c, -pose.s, pose.s, pose.c].map((value) => value.toFixed(6)).join(" ");
  set(shape, "transform", `matrix(${turn} ${inPath(view.toScreen([pose.x, pose.y]))})`);
}

/** Moves a circle to a place on the screen; without one it is out of sight. */
export function putCircle(circle: SVGCircleElement, at: Point | null): void {
  shown(circle, at !== null);
  if (!at) return;
  set(circle, "cx", round(at[0]));
  set(circle, "cy", round(at[1]));
}
