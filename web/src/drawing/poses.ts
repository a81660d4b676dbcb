// Where links are, at samples and between them.

import { known, type LinkData, type Point, type Values } from "../scene/data.ts";

/** Placement of a link's axes: origin (x, y), unit vector (c, s) of its x axis. */
export interface Pose {
  readonly x: number;
  readonly y: number;
  readonly c: number;
  readonly s: number;
}

/** Value of a row at sample k + f, by cubic interpolation through the samples around it; a row of one never changes. */
export function between(values: Values, times: readonly number[], k: number, f: number): number | null {
  if (values.length === 1) return known(values, 0);
  const v0 = known(values, k);
  if (v0 === null || f === 0) return v0;
  const v1 = known(values, k + 1);
  if (v1 === null) return null;
  const h = times[k + 1]! - times[k]!;
  const slope = (i: number): number => {
    const [a, b] = [known(values, i - 1), known(values, i + 1)];
    return a === null || b === null ? v1 - v0 : ((b - a) / (times[i + 1]! - times[i - 1]!)) * h;
  };
  const [m0, m1] = [slope(k), slope(k + 1)];
  const g = 1 - f;
  return v0 * g * g * (1 + 2 * f) + m0 * f * g * g - m1 * f * f * g + v1 * f * f * (3 - 2 * f);
}

/** The place of two rows at sample k + f. */
export function spot(x: Values, y: Values, times: readonly number[], k: number, f: number): Point | null {
  const [at, up] = [between(x, times, k, f), between(y, times, k, f)];
  return at === null || up === null ? null : [at, up];
}

/** Pose of a link at sample k + f, or null where it can't be assembled. */
export function poseOf({ pose }: LinkData, times: readonly number[], k: number, f = 0): Pose | null {
  const origin = spot(pose.x, pose.y, times, k, f);
  const axis = spot(pose.c, pose.s, times, k, f);
  if (!origin || !axis) return null;
  const [[x, y], [c, s]] = [origin, axis];
  const size = Math.hypot(c, s) || 1;
  return { x, y, c: c / size, s: s / size };
}

/** The place in the world of a place in a link's axes. */
export const place = (pose: Pose, [x, y]: Point): Point => [
  pose.x + pose.c * x - pose.s * y,
  pose.y + pose.s * x + pose.c * y,
];
