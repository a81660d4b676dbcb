// Arrows of velocities, accelerations and forces, each as long as its value is large; of moments arcs round their
// places, with a radius that is.

import { type ArrowData, type ArrowKind, known, type LinkData, type Point } from "../scene/data.ts";
import type { Scene, Values } from "../scene/data.ts";
import { clamp } from "../scene/numbers.ts";
import { set, svg } from "./elements.ts";
import { turnPath } from "./moments.ts";
import { between, place, poseOf, spot } from "./poses.ts";
import type { Facts } from "./survey.ts";
import type { Move, View } from "./view.ts";
import { round } from "./written.ts";

export const ARROW_KINDS: readonly ArrowKind[] = ["velocity", "acceleration", "reaction", "load", "weight", "moment"];

/** The longest arrow of a kind over the motion, of moments the largest radius, in pixels: a share of the drawing's
 * width, between bounds. */
const LONGEST = { straight: { share: 1 / 9, least: 36, most: 70 }, round: { share: 1 / 15, least: 22, most: 40 } };
/** Length and half the width of an arrow's head, in pixels. */
const HEAD = { length: 9, half: 3.6 };

/** An arrow with the rows of its vector, or the one of a moment, and where it begins: a point of a link, or two more
 * rows. */
export interface Arrow {
  readonly data: ArrowData;
  readonly x: Values;
  readonly y: Values | null;
  readonly from: { readonly link: LinkData; readonly local: Point } | { readonly x: Values; readonly y: Values };
}

/** The longest value of each kind that there is, with its unit. */
export type Longest = ReadonlyMap<ArrowKind, { readonly value: number; readonly unit: string }>;

/** The arrows whose rows a scene has. */
export function arrowsOf(scene: Scene, links: ReadonlyMap<string, LinkData>): Arrow[] {
  const { arrows = [], values = {} } = scene;
  return arrows.flatMap((data): Arrow[] => {
    const [x, y = null] = data.rows.map((row) => values[row]);
    if (!x || (!y && data.rows.length > 1)) return [];
    if (data.at) {
      const link = links.get(data.at[0]);
      const local = link?.points[data.at[1]];
      return link && local ? [{ data, x, y, from: { link, local } }] : [];
    }
    const [px, py] = [values[data.places?.[0] ?? ""], values[data.places?.[1] ?? ""]];
    return px && py ? [{ data, x, y, from: { x: px, y: py } }] : [];
  });
}

export function longestOf(arrows: readonly Arrow[]): Longest {
  const found = new Map<ArrowKind, { value: number; unit: string }>();
  for (const { data, x, y } of arrows) {
    const longest = found.get(data.kind) ?? { value: 0, unit: data.unit };
    for (let k = 0; k < x.length; k++) {
      longest.value = Math.max(longest.value, Math.hypot(known(x, k) ?? 0, y ? (known(y, k) ?? 0) : 0));
    }
    if (longest.value > 0) found.set(data.kind, longest);
  }
  return found;
}

/** Pixels for a unit of a kind's values, at a factor of the usual length. */
export function arrowScale(longest: Longest, kind: ArrowKind, factor: number, width: number): number {
  const most = longest.get(kind)?.value ?? 0;
  const longer = LONGEST[kind === "moment" ? "round" : "straight"];
  return most > 0 ? (factor * clamp(width * longer.share, longer.least, longer.most)) / most : 0;
}

/** The place in the world where an arrow begins. */
export function beginning({ from }: Arrow, times: readonly number[], k: number, f: number): Point | null {
  if (!("link" in from)) return spot(from.x, from.y, times, k, f);
  const pose = poseOf(from.link, times, k, f);
  return pose && place(pose, from.local);
}

/** The vector of an arrow at sample k + f, of a moment its value alone; null where it isn't known. */
export function vectorOf({ x, y }: Arrow, times: readonly number[], k: number, f: number): Point | number | null {
  return y ? spot(x, y, times, k, f) : between(x, times, k, f);
}

/** Shaft and head from a place on the screen by a vector, y down; empty where it is too short to see. */
export function arrowPath([x, y]: Point, [dx, dy]: Point): string {
  const length = Math.hypot(dx, dy);
  if (!(length >= 1)) return "";
  const [ux, uy] = [dx / length, dy / length];
  const head = Math.min(HEAD.length, 0.7 * length);
  const half = (HEAD.half * head) / HEAD.length;
  const at = (along: number, across: number): string =>
    `${round(x + along * ux - across * uy)} ${round(y + along * uy + across * ux)}`;
  const neck = length - head;
  return `M${at(0, 0)}L${at(neck, 0)}L${at(neck, half)}L${at(length, 0)}L${at(neck, -half)}L${at(neck, 0)}Z`;
}

/** An arrow from a place on the screen. */
const drawn = (at: Point, vector: Point | number, scale: number): string =>
  typeof vector === "number" ? turnPath(at, scale * vector) : arrowPath(at, [scale * vector[0], -scale * vector[1]]);

/** `factors`: the kinds that are seen, each with the factor of its usual length. */
export function arrows(facts: Facts, view: View, factors: ReadonlyMap<ArrowKind, number>, parent: Element): Move {
  const parts = facts.arrows.flatMap((arrow) => {
    const factor = factors.get(arrow.data.kind);
    if (factor === undefined) return [];
    const scale = arrowScale(facts.longest, arrow.data.kind, factor, view.width);
    const look = { class: `lw-arrow lw-${arrow.data.kind}`, "data-arrow": arrow.data.name };
    return [{ arrow, scale, path: svg("path", look, parent) }];
  });
  return (sample, f) => {
    for (const { arrow, scale, path } of parts) {
      const from = beginning(arrow, facts.times, sample, f);
      const vector = vectorOf(arrow, facts.times, sample, f);
      set(path, "d", from && vector !== null ? drawn(view.toScreen(from), vector, scale) : "");
    }
  };
}
