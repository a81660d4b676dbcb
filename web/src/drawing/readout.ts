// What there is to say of a point at a time: where it is, how fast, the largest reaction of its pin.

import type { ArrowKind, Point } from "../scene/data.ts";
import type { Arrow } from "./arrows.ts";
import type { Pin } from "./pins.ts";
import { place, poseOf, spot } from "./poses.ts";
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
}

/** Null where the point has no place. A speed or a reaction that isn't known, or never is any, is null. */
export function readout(facts: Facts, pin: Pin, k: number, f: number): Readout | null {
  const { link, local } = pin.places.find((each) => each.link.fixed) ?? pin.places[0];
  const pose = poseOf(link, facts.times, k, f);
  if (!pose) return null;
  const largest = (kind: ArrowKind): Quantity | null => {
    let found: Quantity | null = null;
    for (const arrow of facts.arrows) {
      if (arrow.data.kind !== kind || !beginsAt(arrow, pin)) continue;
      const vector = spot(arrow.x, arrow.y, facts.times, k, f);
      const value = vector ? Math.hypot(...vector) : 0;
      if (vector && (!found || value > found.value)) found = { value, unit: arrow.data.unit };
    }
    return found;
  };
  return { name: pin.name, at: place(pose, local), speed: largest("velocity"), reaction: largest("reaction") };
}

/** Whether an arrow begins at a pin. */
const beginsAt = ({ from }: Arrow, pin: Pin): boolean =>
  "link" in from && pin.places.some(({ link, local }) => link === from.link && local === from.local);
