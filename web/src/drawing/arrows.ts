// Arrows of velocities, accelerations and forces, each as long as its value is large.

import { type ArrowData, type ArrowKind, known, type LinkData, type Point } from "../scene/data.ts";
import type { Scene, Values } from "../scene/data.ts";
import { clamp } from "../scene/numbers.ts";
import { svg } from "./elements.ts";
import { place, poseOf, spot } from "./poses.ts";
import type { Facts } from "./survey.ts";
import type { Move, View } from "./view.ts";
import { round } from "./written.ts";

export const ARROW_KINDS: readonly ArrowKind[] = ["velocity", "acceleration", "reaction", "load", "weight"];

/** The longest arrow of a kind over the motion, in pixels, on a drawing of usual width. */
const LONGEST = 70;
/** Length and half the width of an arrow's head, in pixels. */
const HEAD = { length: 9, half: 3.6 };

/** An arrow with the rows of its vector, and where it begins: a point of a link, or two more rows. */
export interface Arrow {
  readonly data: ArrowData;
  readonly x: Values;
  readonly y: Values;
  readonly from: { readonly link: LinkData; readonly local: Point } | { readonly x: Values; readonly y: Values };
}

/** The longest value of each kind that there is, with its unit. */
export type Longest = ReadonlyMap<ArrowKind, { readonly value: number; readonly unit: string }>;

/** The arrows whose rows a scene has. */
export function arrowsOf(scene: Scene, links: ReadonlyMap<string, LinkData>): Arrow[] {
  const { arrows = [], values = {} } = scene;
  return arrows.flatMap((data): Arrow[] => {
    const [x, y] = [values[data.rows[0]], values[data.rows[1]]];
    if (!x || !y) return [];
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
      longest.value = Math.max(longest.value, Math.hypot(known(x, k) ?? 0, known(y, k) ?? 0));
    }
    if (longest.value > 0) found.set(data.kind, longest);
  }
  return found;
}

/** Pixels for a unit of a kind's values, at a factor of the usual length. */
export function arrowScale(longest: Longest, kind: ArrowKind, factor: number, width: number): number {
  const most = longest.get(kind)?.value ?? 0;
  return most > 0 ? (factor * clamp(width / 9, 36, LONGEST)) / most : 0;
}

/** The place in the world where an arrow begins. */
export function beginning({ from }: Arrow, times: readonly number[], k: number, f: number): Point | null {
  if (!("link" in from)) return spot(from.x, from.y, times, k, f);
  const pose = poseOf(from.link, times, k, f);
  return pose && place(pose, from.local);
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

/** `factors`: the kinds that are seen, each with the factor of its usual length. */
export function arrows(facts: Facts, view: View, factors: ReadonlyMap<ArrowKind, number>, parent: Element): Move {
  const parts = facts.arrows.flatMap((arrow) => {
    const factor = factors.get(arrow.data.kind);
    if (factor === undefined) return [];
    const scale = arrowScale(facts.longest, arrow.data.kind, factor, view.width);
    const look = { class: `lw-arrow lw-${arrow.data.kind}`, "data-arrow": arrow.data.name };
    const path = svg("path", look, parent);
    svg("title", {}, path).textContent = arrow.data.name;
    return [{ arrow, scale, path }];
  });
  return (sample, f) => {
    for (const { arrow, scale, path } of parts) {
      const from = beginning(arrow, facts.times, sample, f);
      const vector = spot(arrow.x, arrow.y, facts.times, sample, f);
      const d = from && vector ? arrowPath(view.toScreen(from), [scale * vector[0], -scale * vector[1]]) : "";
      path.setAttribute("d", d);
    }
  };
}
