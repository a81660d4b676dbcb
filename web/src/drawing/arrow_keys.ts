// How long arrows are: of each kind a short one with its value, as a scale bar is for lengths.

import type { ArrowKind } from "../scene/data.ts";
import { nice } from "../scene/numbers.ts";
import { ARROW_KINDS, arrowPath, arrowScale } from "./arrows.ts";
import { figure } from "./dimension_lines.ts";
import { svg } from "./elements.ts";
import type { Facts } from "./survey.ts";
import type { View } from "./view.ts";
import type { Say } from "./words.ts";

/** How long such an arrow may be, and how far keys are apart, in pixels. */
const LONGEST = 46;
const APART = 16;

export interface Key {
  readonly path: string;
  readonly pixels: number;
  readonly text: string;
}

/** A nice value of a kind and its arrow, from (0, 0) to the right. */
export function keyOf({ longest }: Facts, kind: ArrowKind, factor: number, width: number): Key | null {
  const scale = arrowScale(longest, kind, factor, width);
  if (!scale) return null;
  const value = nice(LONGEST / scale);
  const pixels = scale * value;
  return { path: arrowPath([0, 0], [pixels, 0]), pixels, text: `${figure(value)} ${longest.get(kind)!.unit}` };
}

/** What kinds of arrows are called. */
export const kindNames = (say: Say): Readonly<Record<ArrowKind, string>> => ({
  velocity: say("arrow_velocity"),
  acceleration: say("arrow_acceleration"),
  reaction: say("arrow_reaction"),
  load: say("arrow_load"),
  weight: say("arrow_weight"),
});

type Factors = ReadonlyMap<ArrowKind, number>;

/** Keys of the kinds that are seen, in a corner of a drawing on paper, which has no row of them. */
export function arrowKeys(facts: Facts, view: View, factors: Factors, say: Say, parent: Element): void {
  const names = kindNames(say);
  const keys = ARROW_KINDS.flatMap((kind) => {
    const key = factors.has(kind) ? keyOf(facts, kind, factors.get(kind)!, view.width) : null;
    return key ? [{ kind, key }] : [];
  });
  keys.forEach(({ kind, key }, i) => {
    const place = `translate(${view.width - 236} ${view.height - 14 - APART * (keys.length - 1 - i)})`;
    const group = svg("g", { class: "lw-key", transform: place }, parent);
    svg("path", { class: `lw-arrow lw-${kind}`, d: key.path }, group);
    svg("text", { x: LONGEST + 8, dy: "0.35em" }, group).textContent = `${names[kind]}: ${key.text}`;
  });
}
