// What there is to say of a point at a time: where it is, how fast, the largest reaction of its pin, the moments there.
// Of an arrow: its value.

import type { ArrowKind, Point } from "../scene/data.ts";
import { type Arrow, beginning, vectorOf } from "./arrows.ts";
import type { Pin } from "./pins.ts";
import { place, poseOf } from "./poses.ts";
import type { Facts } from "./survey.ts";

export interface Quantity {
  readonly value: number;
  readonly unit: string;
}

export interface Readout {
  readonly name: string;
  readonly at: Point;
  readonly speed: Quantity | null;
  readonly reaction: Quantity | null;
  /** The moments that are drawn about it, by name. */
  readonly moments: readonly (readonly [string, Quantity])[];
}

/** How near to a point a moment is about it, over the size of the mechanism. */
const NEAR = 1e-6;

/** Null where the point has no place. A speed or a reaction that isn't known, or never is any, is null. */
export function readout(facts: Facts, pin: Pin, k: number, f: number): Readout | null {
  const { link, local } = pin.places.find((each) => each.link.fixed) ?? pin.places[0];
  const pose = poseOf(link, facts.times, k, f);
  if (!pose) return null;
  const largest = (kind: ArrowKind): Quantity | null => {
    let found: Quantity | null = null;
    for (const arrow of facts.arrows) {
      if (arrow.data.kind !== kind || !beginsAt(arrow, pin)) continue;
      const value = valueOf(facts, arrow, k, f);
      if (value && (!found || value.value > found.value)) found = value;
    }
    return found;
  };
  const at = place(pose, local);
  const moments = facts.arrows.flatMap((arrow) => {
    const [about, value] = [beginning(arrow, facts.times, k, f), valueOf(facts, arrow, k, f)];
    const off = about && arrow.data.kind === "moment" ? Math.hypot(about[0] - at[0], about[1] - at[1]) : Infinity;
    return value && off < NEAR * facts.size ? [[arrow.data.name, value] as const] : [];
  });
  return { name: pin.name, at, speed: largest("velocity"), reaction: largest("reaction"), moments };
}

/** The magnitude of an arrow's vector, or a moment with its sign. */
export function valueOf({ times }: Facts, arrow: Arrow, k: number, f: number): Quantity | null {
  const vector = vectorOf(arrow, times, k, f);
  if (vector === null) return null;
  return { value: typeof vector === "number" ? vector : Math.hypot(...vector), unit: arrow.data.unit };
}

/** Whether an arrow begins at a pin. */
const beginsAt = ({ from }: Arrow, pin: Pin): boolean =>
  "link" in from && pin.places.some(({ link, local }) => link === from.link && local === from.local);
