// Whether figures meet a requirement such as `>= 680 mm`. As LiveRequirement of src/linkwright/measures/live.py.

import type { Figures, LiveRequirement, Rows } from "./measure.ts";
import { numberOn } from "./measure.ts";

/** A measure without figures doesn't meet any. */
export function met(requirement: LiveRequirement, figures: Figures | undefined, rows: Rows): boolean {
  if (figures === undefined) return false;
  const low = requirement.low === null ? -Infinity : numberOn(requirement.low, rows);
  const high = requirement.high === null ? Infinity : numberOn(requirement.high, rows);
  return Object.values(figures).every(({ value }) => low <= value && value <= high);
}
