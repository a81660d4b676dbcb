// Curves on the canvas of a plot, in the order of their samples.

import type uPlot from "uplot";
import { known, type Values } from "../scene/data.ts";

/** A curve of one side of a plot, broken where it has no value. */
export function trace(u: uPlot, right: boolean, x: Values, y: Values): Path2D {
  const [across, up] = [scaled(u, "x"), scaled(u, right ? "right" : "y")];
  const path = new Path2D();
  let broken = true;
  for (let k = 0; k < y.length; k++) {
    const [a, b] = [known(x, k), known(y, k)];
    if (a === null || b === null) {
      broken = true;
      continue;
    }
    if (broken) path.moveTo(across(a), up(b));
    else path.lineTo(across(a), up(b));
    broken = false;
  }
  return path;
}

/** Draws within the area of the curves, and leaves the canvas as it was. */
export function clipped(u: uPlot, draw: () => void): void {
  const { ctx, bbox } = u;
  ctx.save();
  ctx.beginPath();
  ctx.rect(bbox.left, bbox.top, bbox.width, bbox.height);
  ctx.clip();
  draw();
  ctx.restore();
}

/** From values of a scale to pixels of the canvas. */
export function scaled(u: uPlot, scale: string): (value: number) => number {
  const { min = 0, max = 1 } = u.scales[scale]!;
  const [from, to] = [u.valToPos(min!, scale, true), u.valToPos(max!, scale, true)];
  const per = (to - from) / (max! - min! || 1);
  return (value) => from + (value - min!) * per;
}
