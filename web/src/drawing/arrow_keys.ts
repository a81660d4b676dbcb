// How long arrows are: of each kind a short one with its value, as a scale bar is for lengths; of moments a small arc.

import type { ArrowKind } from "../scene/data.ts";
import { nice } from "../scene/numbers.ts";
import { ARROW_KINDS, arrowPath, arrowScale } from "./arrows.ts";
import { figure } from "./dimension_lines.ts";
import { svg, write } from "./elements.ts";
import { turnPath } from "./moments.ts";
import type { Facts } from "./survey.ts";
import type { View } from "./view.ts";
import type { Say } from "./words.ts";

/** How long such an arrow may be, the radius of a moment's, how high a key is at least, in pixels. */
const LONGEST = 46;
const RADIUS = 12;
const APART = 16;

export interface Key {
  readonly path: string;
  readonly pixels: number;
  readonly high: number;
  readonly text: string;
}

/** A nice value of a kind and its arrow, from (0, 0) to the right, `pixels` wide. */
export function keyOf({ longest }: Facts, kind: ArrowKind, factor: number, width: number): Key | null {
  const scale = arrowScale(longest, kind, factor, width);
  if (!scale) return null;
  const round = kind === "moment";
  const value = nice((round ? RADIUS : LONGEST) / scale);
  const [long, text] = [scale * value, `${figure(value)} ${longest.get(kind)!.unit}`];
  if (!round) return { path: arrowPath([0, 0], [long, 0]), pixels: long, high: 10, text };
  return { path: turnPath([long + 4, 0], long), pixels: 2 * long + 8, high: 2 * long + 8, text };
}

/** What kinds of arrows are called. */
export const kindNames = (say: Say): Readonly<Record<ArrowKind, string>> => ({
  velocity: say("arrow_velocity"),
  acceleration: say("arrow_acceleration"),
  reaction: say("arrow_reaction"),
  load: say("arrow_load"),
  weight: say("arrow_weight"),
  moment: say("arrow_moment"),
});

type Factors = ReadonlyMap<ArrowKind, number>;

/** Keys of the kinds that are seen, in a corner of a drawing on paper, which has no row of them. */
export function arrowKeys(facts: Facts, view: View, factors: Factors, say: Say, parent: Element): void {
  const names = kindNames(say);
  const keys = ARROW_KINDS.flatMap((kind) => {
    const key = factors.has(kind) ? keyOf(facts, kind, factors.get(kind)!, view.width) : null;
    return key ? [{ kind, key }] : [];
  });
  let bottom = view.height - 6;
  for (const { kind, key } of keys.reverse()) {
    const high = Math.max(key.high, APART);
    const place = `translate(${view.width - 236} ${bottom - high / 2})`;
    bottom -= high;
    const group = svg("g", { class: "lw-key", transform: place }, parent);
    svg("path", { class: `lw-arrow lw-${kind}`, d: key.path }, group);
    write(svg("text", { x: LONGEST + 8, dy: "0.35em" }, group), `${names[kind]}: ${key.text}`);
  }
}
