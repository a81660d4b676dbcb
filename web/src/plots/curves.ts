// What a plot shows: curves over the time or over a drive's value, with what measures say of them.

import { known, type Values } from "../scene/data.ts";
import { locate } from "../scene/times.ts";
import { type Choice, unitsOf, viewOf } from "./choice.ts";
import { extent } from "../scene/numbers.ts";
import { monotonePieces, type Piece } from "./monotone.ts";
import "./of_studies.ts";
import type { Look } from "./outline.ts";
import type { Level, Place, Signals } from "./signals.ts";
import { magnitudes, vectorName } from "./vectors.ts";

/** The horizontal axis, the same of all plots of a page. */
export interface Horizontal {
  /** How its column is called in files, and how the axis is labelled. */
  readonly name: string;
  readonly unit: string;
  readonly label: string;
  /** Of each sample; those of the original where these differ, else null. */
  readonly values: Values;
  readonly ghost: Values | null;
  /** Whether it ascends, as a time does. */
  readonly ascends: boolean;
  readonly pieces: readonly Piece[];
  readonly ends: readonly [number, number];
}

/** `signals`: those of the choice that it is made of. `right`: its unit is that of the right axis. */
export interface Curve {
  readonly name: string;
  readonly signals: readonly string[];
  readonly unit: string;
  readonly right: boolean;
  readonly values: Values;
  readonly ghost: Values | null;
  /** A curve without it is a line of its number's colour. */
  readonly look?: Look;
}

/** A vector over time, of a polar plot. */
export interface Vector {
  readonly name: string;
  readonly x: Values;
  readonly y: Values;
  readonly ghost: { readonly x: Values; readonly y: Values } | null;
}

export interface Mark {
  readonly curve: number;
  readonly x: number;
  readonly y: number;
  readonly time: number;
  readonly text: string;
}

export interface Curves {
  readonly title: string;
  readonly units: readonly string[];
  readonly x: Horizontal;
  readonly curves: readonly Curve[];
  /** In place of curves, in a polar plot. */
  readonly vectors: readonly Vector[];
  readonly levels: readonly (Level & { readonly right: boolean })[];
  readonly marks: readonly Mark[];
  /** Limits on the horizontal axis, and names that stand below it in place of numbers, at 0.5, 1.5 and so on. */
  readonly uprights?: readonly Level[];
  readonly names?: readonly string[];
  /** How the vertical axis is called, where the title doesn't say it. */
  readonly vertical?: string;
}

/** The axis of times, whose name in files is `name`. */
export const overTime = (
  values: readonly number[],
  name: string,
  unit: string,
  label: string,
  ghost: readonly number[] | null = null,
): Horizontal => ({
  name,
  unit,
  label,
  values,
  ghost,
  ascends: true,
  pieces: monotonePieces(values),
  ends: [values[0] ?? 0, values.at(-1) ?? 0],
});

/** The axis of a signal's values; a signal that rests is given some room. */
export function overSignal(name: string, signals: Signals): Horizontal {
  const [values, unit] = [signals.values(name), signals.unit(name)];
  const [low, high] = extent(values) ?? [0, 0];
  const rest = high - low <= 1e-9 * Math.max(Math.abs(low), Math.abs(high)) ? Math.max(1, Math.abs(high)) / 2 : 0;
  return {
    name,
    unit,
    label: `${name}, ${unit}`,
    values,
    ghost: signals.changed ? signals.values(name, true) : null,
    ascends: false,
    pieces: monotonePieces(values),
    ends: [low - rest, high + rest],
  };
}

/** `title` is empty for that of its curves. */
export function curvesOf(
  choice: Choice,
  title: string,
  signals: Signals,
  x: Horizontal,
  times: readonly number[],
): Curves {
  const view = viewOf(choice);
  const units = unitsOf(choice.signals, signals.unit);
  const before = (name: string): Values | null => (signals.changed ? signals.values(name, true) : null);
  const right = (name: string): boolean => signals.unit(name) !== units[0];
  const curves: Curve[] = [];
  const vectors: Vector[] = [];
  const levels: (Level & { right: boolean })[] = [];
  const marks: Mark[] = [];
  const add = (curve: Curve, vector: boolean): void => {
    const found = signals.marks(curve.signals[0]!, vector);
    levels.push(...found.levels.map((level) => ({ ...level, right: curve.right })));
    marks.push(...found.places.flatMap((place) => markOf(place, curves.length, curve, x, times)));
    curves.push(curve);
  };
  const vectorAt = (i: number): [string, string] => [choice.signals[i]!, choice.signals[i + 1]!];
  if (view === "components") {
    for (const name of choice.signals) {
      const curve = { name, signals: [name], unit: signals.unit(name), right: right(name) };
      add({ ...curve, values: signals.values(name), ghost: before(name) }, false);
    }
  }
  for (let i = 0; view !== "components" && i < choice.signals.length; i += 2) {
    const pair = vectorAt(i);
    const [u, v] = pair.map((name) => signals.values(name)) as [Values, Values];
    const [gu, gv] = pair.map(before) as [Values | null, Values | null];
    const name = vectorName(pair[0]);
    const ghost = gu && gv ? magnitudes(gu, gv) : null;
    const of = { unit: signals.unit(pair[0]), right: right(pair[0]), ghost };
    add({ ...of, name: `|${name}|`, signals: pair, values: magnitudes(u, v) }, true);
    vectors.push({ name, x: u, y: v, ghost: gu && gv ? { x: gu, y: gv } : null });
  }
  const named = title || (vectors.length ? vectors : curves).map(({ name }) => name).join(", ");
  const polar = view === "polar";
  return { title: named, units, x, curves, vectors: polar ? vectors : [], levels, marks: polar ? [] : marks };
}

/** Where a place of a measure lies in a plot; nowhere where its curve has no value. */
function markOf(
  { time, value, text }: Place,
  curve: number,
  { values }: Curve,
  x: Horizontal,
  times: readonly number[],
): Mark[] {
  const { k, f } = locate(times, time);
  const at = (row: Values): number | null => {
    const [from, to] = [known(row, k), known(row, Math.min(k + 1, times.length - 1))];
    return from === null || to === null ? from : from + f * (to - from);
  };
  const [across, up] = [x.ascends ? time : at(x.values), value ?? at(values)];
  return across === null || up === null ? [] : [{ curve, x: across, y: up, time, text }];
}

/** The values of one side that are seen in a window of the horizontal axis, with their original and levels near by. */
export function sideExtent(
  { curves, levels, x }: Curves,
  right: boolean,
  [from, to]: readonly [number, number],
  shown: (curve: number) => boolean,
): readonly [number, number] | null {
  const whole = from <= x.ends[0] && to >= x.ends[1];
  const within = (across: Values, values: Values): readonly [number, number] | null =>
    whole
      ? wholeExtent(values)
      : extent(values, (k) => {
          const at = known(across, k);
          return at !== null && at >= from && at <= to;
        });
  const seen = curves.flatMap((curve, i) => {
    if (curve.right !== right || !shown(i)) return [];
    const ghost = curve.ghost && within(x.ghost ?? x.values, curve.ghost);
    const lower = !globalThis.WITHOUT_STUDIES ? lowerEnd(curve, (low) => within(x.values, low)) : null;
    return [within(x.values, curve.values), ghost, lower].filter((each) => each !== null);
  });
  if (!seen.length) return null;
  let [low, high] = [Math.min(...seen.map(([a]) => a)), Math.max(...seen.map(([, b]) => b))];
  // A limit far from all values would leave them flat: it stays out of sight.
  const span = high - low;
  for (const { value, right: side } of levels) {
    if (side !== right || value < low - span || value > high + span) continue;
    [low, high] = [Math.min(low, value), Math.max(high, value)];
  }
  return [low, high];
}

/** The other end of what is filled: of a band, of bars. */
function lowerEnd<E>({ look }: Curve, within: (low: Values) => E): E | readonly [number, number] | null {
  if (look?.low) return within(look.low);
  return look?.edges ? [0, 0] : null;
}

const extents = new WeakMap<Values, readonly [number, number] | null>();

/** The ends of values, which don't change: those of an original are asked for in each frame. */
function wholeExtent(values: Values): readonly [number, number] | null {
  let found = extents.get(values);
  if (found === undefined) extents.set(values, (found = extent(values)));
  return found;
}

/** Limits of an axis for values between two ends: round-off around a constant is shown as a constant. */
export function limits(low: number, high: number): [number, number] {
  const size = Math.max(Math.abs(low), Math.abs(high));
  const nought = size < 1e-10;
  const spread = high - low < 1e-8 * size || nought ? Math.max(0.1 * size, nought ? 1 : 0) : 0;
  return [low - spread, high + spread];
}
