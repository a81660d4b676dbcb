// A slot along a line, as wide as the pins in it, with round ends.

import type { Point } from "../scene/data.ts";

/** Pieces of a rounded end. */
const ROUND = 12;

/** The edge of a slot along an open line, `half` its width to both sides; a line of no length gives a circle. */
export function slotAlong(line: readonly Point[], half: number): Point[] {
  const places = line.filter((at, i) => i === 0 || Math.hypot(at[0] - line[i - 1]![0], at[1] - line[i - 1]![1]) > 0);
  const headings = places.map((_, i) => {
    const [before, after] = [places[Math.max(i - 1, 0)]!, places[Math.min(i + 1, places.length - 1)]!];
    return Math.atan2(after[1] - before[1], after[0] - before[0]);
  });
  const away = ([x, y]: Point, angle: number): Point => [x + half * Math.cos(angle), y + half * Math.sin(angle)];
  const end = (at: Point, heading: number): Point[] =>
    Array.from({ length: ROUND + 1 }, (_, k) => away(at, heading - Math.PI / 2 + (Math.PI * k) / ROUND));
  const right = places.map((at, i) => away(at, headings[i]! - Math.PI / 2));
  const left = places.map((at, i) => away(at, headings[i]! + Math.PI / 2));
  return [
    ...right,
    ...end(places.at(-1)!, headings.at(-1)!),
    ...left.reverse(),
    ...end(places[0]!, headings[0]! + Math.PI),
  ];
}
