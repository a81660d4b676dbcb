// How straight a path is: the narrowest strip that holds it. The path across a strip is a cubic too, whose turning
// points are known. As src/linkwright/reductions/straightness.py.

import type { Figures, OnSamples } from "./measure.ts";
import { rowOf } from "./measure.ts";
import { Interpolant } from "./samples.ts";

type Point = readonly [number, number];

const ROUNDS = 60;

export function straightness(samples: OnSamples): Figures {
  const x = rowOf(samples, "x");
  const y = rowOf(samples, "y");
  const place = (time: number): Point => [x.value(time), y.value(time)];
  const marks = samples.stretches.flatMap(([a, b]) => x.marks(a, b).times);
  let points = corners(marks.map(place));
  const origin = points[0]!;
  let extent = 0;
  for (const p of points) extent = Math.max(extent, Math.abs(p[0] - origin[0]), Math.abs(p[1] - origin[1]));
  let best = extent > 0 ? Infinity : 0;
  // The narrowest strip of some points is a lower bound, the whole path across it an upper one: add the path's
  // outermost points until the two meet.
  for (let k = 0; k < ROUNDS && extent > 0; k++) {
    const [least, a, b] = narrow(points);
    const height = Interpolant.mixed(x, y, a, b);
    const top = height.extreme(samples.stretches, 1);
    const bottom = height.extreme(samples.stretches, -1);
    best = Math.min(best, top.value - bottom.value);
    if (best - least <= 1e-12 * best + 1e-15 * extent) break;
    points = corners([...points, place(top.time), place(bottom.time)]);
  }
  return { "": { value: best, time: null } };
}

/** The corners of the convex hull, counter-clockwise (Andrew's monotone chain). */
function corners(points: readonly Point[]): Point[] {
  const ordered = [...points].sort((p, q) => p[0] - q[0] || p[1] - q[1]);
  const own = ordered.filter((p, i) => i === 0 || p[0] !== ordered[i - 1]![0] || p[1] !== ordered[i - 1]![1]);
  const sides: Point[] = [];
  for (const row of [own, [...own].reverse()]) {
    const side: Point[] = [];
    for (const p of row) {
      while (side.length > 1 && left(side[side.length - 2]!, side[side.length - 1]!, p) <= 0) side.pop();
      side.push(p);
    }
    sides.push(...side.slice(0, -1));
  }
  return sides.length > 0 ? sides : own;
}

/** How far c lies to the left of the way from a to b, times the length of that. */
function left(a: Point, b: Point, c: Point): number {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/** The width of the narrowest strip around a convex polygon, and the unit vector across it: one side of it lies on an
 * edge of the polygon. */
function narrow(points: readonly Point[]): [number, number, number] {
  let best: [number, number, number] = [Infinity, 0, 1];
  points.forEach((p, i) => {
    const q = points[(i + 1) % points.length]!;
    const along = q[0] - p[0];
    const up = q[1] - p[1];
    const length = Math.sqrt(along * along + up * up);
    const a = -up / length;
    const b = along / length;
    let width = -Infinity;
    for (const c of points) width = Math.max(width, (c[0] - p[0]) * a + (c[1] - p[1]) * b);
    if (width < best[0]) best = [width, a, b];
  });
  return best;
}
