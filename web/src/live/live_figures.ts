// The figures of measures in a motion, each taken once.

import type { Figures, Rows } from "../measures/measure.ts";
import { figures } from "../measures/registry.ts";
import type { Motion } from "../program/mechanism.ts";
import type { LiveModel } from "./live_model.ts";

const taken = new WeakMap<Motion, (Figures | null)[]>();

export const rowsOf =
  (motion: Motion): Rows =>
  (row) =>
    motion.measured[row]!;

/** The figures (SI) of a measure by its number; undefined where it isn't available. */
export function figuresOf(live: LiveModel, measure: number, motion = live.motion): Figures | undefined {
  const known = taken.get(motion) ?? [];
  taken.set(motion, known);
  known[measure] ??= figures(live.data.measures[measure]!, motion.times, rowsOf(motion)) ?? null;
  return known[measure] ?? undefined;
}
