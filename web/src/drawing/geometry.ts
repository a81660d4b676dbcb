// Shapes around points of the plane.

import type { Point } from "../scene/data.ts";
import { round } from "./written.ts";

/** Convex hull (Andrew's monotone chain), counter-clockwise in the plane of its coordinates. */
export function hull(points: readonly Point[]): Point[] {
  const sorted = [...points].sort((a, b) => a[0] - b[0] || a[1] - b[1]);
  const lower = chain(sorted);
  const upper = chain(sorted.reverse());
  return lower.length < 2 ? lower : [...lower.slice(0, -1), ...upper.slice(0, -1)];
}

/** One side of the hull of sorted points; places that coincide count once. */
function chain(points: readonly Point[]): Point[] {
  const out: Point[] = [];
  for (const p of points) {
    while (out.length > 1) {
      const [a, b] = [out.at(-2)!, out.at(-1)!];
      if ((b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]) > 1e-9) break;
      out.pop();
    }
    const last = out.at(-1);
    if (!last || Math.hypot(p[0] - last[0], p[1] - last[1]) > 1e-6) out.push(p);
  }
  return out;
}

/** Outline of the hull of `points`, a distance r outside it: a circle, a rounded bar or a rounded plate. */
export function outline(points: readonly Point[], r: number): string {
  const ring = hull(points);
  const [first] = ring;
  if (first && ring.length === 1) {
    const [x, y] = first;
    return `M${round(x - r)} ${round(y)}a${r} ${r} 0 1 1 ${2 * r} 0a${r} ${r} 0 1 1 ${-2 * r} 0Z`;
  }
  const sides = ring.map((a, i) => {
    const b = ring[(i + 1) % ring.length]!;
    const [dx, dy] = [b[0] - a[0], b[1] - a[1]];
    const [nx, ny] = [(dy / Math.hypot(dx, dy)) * r, (-dx / Math.hypot(dx, dy)) * r];
    return { from: `${round(a[0] + nx)} ${round(a[1] + ny)}`, to: `${round(b[0] + nx)} ${round(b[1] + ny)}` };
  });
  const arc = `A${r} ${r} 0 0 1 `;
  const lines = sides.map(({ from, to }) => `${from}L${to}`);
  return sides[0] ? `M${lines.join(arc)}${arc}${sides[0].from}Z` : "";
}

export const mean = (points: readonly Point[]): Point => [
  points.reduce((sum, [x]) => sum + x, 0) / points.length,
  points.reduce((sum, [, y]) => sum + y, 0) / points.length,
];

/** Middle of the longest stretch of the bar from a to b that is free of points; `points` holds at least these two. */
export function widestGap([a, b]: readonly [Point, Point], points: readonly Point[]): Point {
  const along = ([x, y]: Point) => (x - a[0]) * (b[0] - a[0]) + (y - a[1]) * (b[1] - a[1]);
  const row = [...points].sort((p, q) => along(p) - along(q));
  const size = ([p, q]: readonly [Point, Point]) => along(q) - along(p);
  const gaps = row.slice(1).map((p, i): [Point, Point] => [row[i]!, p]);
  return mean(gaps.reduce((best, gap) => (size(gap) > size(best) ? gap : best)));
}
