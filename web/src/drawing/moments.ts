// Arrows round a place: moments, counter-clockwise where they are positive.

import type { Point } from "../scene/data.ts";
import { round } from "./written.ts";

/** Of a whole turn the arrow leaves a gap below its place. */
const GAP = Math.PI / 2;
const HEAD = { length: 9, half: 3.6 };
/** The least radius that can be seen, in pixels. */
const LEAST = 2;

/** Arc and head about a place on the screen, with a radius in pixels that is positive counter-clockwise; empty where it
 * is too small to see. The arc is gone along twice, so that it has no ground that would be filled. */
export function turnPath([x, y]: Point, signed: number): string {
  const radius = Math.abs(signed);
  if (!(radius >= LEAST)) return "";
  const sense = Math.sign(signed);
  const head = Math.min(HEAD.length, 0.8 * radius);
  const half = (HEAD.half * head) / HEAD.length;
  const whole = 2 * Math.PI - GAP;
  const at = (turned: number, r = radius): string => {
    const angle = -Math.PI / 2 + sense * (GAP / 2 + turned);
    return `${round(x + r * Math.cos(angle))} ${round(y - r * Math.sin(angle))}`;
  };
  const neck = whole - head / radius;
  const arc = (sweep: boolean, to: string): string =>
    `A${round(radius)} ${round(radius)} 0 ${neck > Math.PI ? 1 : 0} ${sweep ? 1 : 0} ${to}`;
  const [start, end] = [at(0), at(neck)];
  const sides = [radius + half, radius - half].map((r) => at(neck, r));
  return `M${start}${arc(sense < 0, end)}L${sides[0]}L${at(whole)}L${sides[1]}L${end}${arc(sense > 0, start)}Z`;
}
