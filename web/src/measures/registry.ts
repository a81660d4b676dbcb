// The rules of reductions by name, and a measure taken by its rule. As LiveMeasure of src/linkwright/measures/live.py.

import { dwell } from "./dwell.ts";
import { efficiency, share } from "./efficiency.ts";
import { extremes, max, min, span } from "./extreme.ts";
import { mean, path, rms } from "./mean.ts";
import type { Figures, Interval, LiveMeasure, LiveRow, OnSamples, Rows, Rule } from "./measure.ts";
import { numberOn } from "./measure.ts";
import { continuous, Interpolant, stretches, wholeTurns, wrapped } from "./samples.ts";
import { straightness } from "./straightness.ts";
import { value } from "./value.ts";

export const RULES: Readonly<Record<string, Rule>> = {
  dwell,
  efficiency,
  extremes,
  max,
  mean,
  min,
  path,
  rms,
  share,
  span,
  straightness,
  value,
};

/** Whether a measure can be shown live: not those of reductions that other packages bring. */
export function isLive(measure: LiveMeasure): boolean {
  return measure.reason === null && Object.hasOwn(RULES, measure.reduction);
}

/** The figures (SI) of a measure from samples at times `t` (s, ascending), by label; undefined where there are none:
 * fewer than two samples, nothing in its window, or a pose there without values. */
export function figures(measure: LiveMeasure, t: ArrayLike<number>, rows: Rows): Figures | undefined {
  const rule = isLive(measure) ? RULES[measure.reduction] : undefined;
  if (rule === undefined || t.length < 2) return undefined;
  for (const watched of measure.watched) if (wholeTurns(t, rows(watched)).some((k) => k !== 0)) return undefined;
  const samples = onSamples(measure, t, rows);
  const found = samples && rule(samples);
  if (found === undefined || !Object.values(found).every((one) => Number.isFinite(one.value))) return undefined;
  if (measure.wrap === null) return found;
  const low = numberOn(measure.wrap[0], rows);
  const high = numberOn(measure.wrap[1], rows);
  if (!(Number.isFinite(low) && Number.isFinite(high) && low < high)) return undefined;
  const turned = Object.entries(found).map(([label, one]) => [label, { ...one, value: wrapped(one.value, low, high) }]);
  return Object.fromEntries(turned) as Figures;
}

/** What the rule looks at; undefined where something is missing. */
function onSamples(measure: LiveMeasure, t: ArrayLike<number>, rows: Rows): OnSamples | undefined {
  const course = (row: LiveRow): Interpolant => {
    const { values, rates } = rows(row.row);
    return Interpolant.of(t, row.jumps ? continuous(t, { values, rates }) : values, rates);
  };
  let where: Interval[] | undefined = [[t[0]!, t[t.length - 1]!]];
  const window = measure.window;
  if (window !== null) {
    const [low, high] = [numberOn(window.ends[0], rows), numberOn(window.ends[1], rows)];
    where = stretches(t, window.row && course(window.row), low, high, window.turning);
  }
  if (where === undefined || where.length === 0) return undefined;
  const courses: Record<string, Interpolant> = {};
  const angles = new Set<string>();
  for (const [key, row] of Object.entries(measure.rows)) {
    const made = course(row);
    for (const [a, b] of where) if (!made.known(a, b)) return undefined;
    courses[key] = made;
    if (row.angle) angles.add(key);
  }
  const numbers: Record<string, number> = {};
  for (const [key, number] of Object.entries(measure.numbers)) {
    const found = numberOn(number, rows);
    if (!Number.isFinite(found)) return undefined;
    numbers[key] = found;
  }
  return { rows: courses, stretches: where, angles, numbers, words: measure.words };
}
