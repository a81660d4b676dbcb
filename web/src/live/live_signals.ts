// The signals of a live model as plots take them, in the units of the page.

import { type LiveNumber, numberOn } from "../measures/measure.ts";
import type { Level, Marks, Place, Signals, Sought } from "../plots/signals.ts";
import type { Motion } from "../program/mechanism.ts";
import type { Values } from "../scene/data.ts";
import { figuresOf, rowsOf } from "./live_figures.ts";
import type { LiveModel } from "./live_model.ts";

/** The kinds of elements in words. */
export type Kinds = Readonly<Record<string, string>>;

/** `plots`: the report's own, which say what their signals are. */
export function liveSignals(live: LiveModel, kinds: Kinds, plots: readonly Sought[]): Signals {
  const { data } = live;
  const quantities = new Map(
    plots.flatMap(({ title, also = "", series }) => series.map(({ name }) => [name, `${title} ${also}`] as const)),
  );
  const numbers = new Map(data.signals.map((name, i) => [name, i]));
  const size = (name: string): number => data.sizes[numbers.get(name) ?? -1] ?? 1;
  const taken = new WeakMap<Motion, Map<string, Values>>();
  const values = (name: string, original = false): Values => {
    const motion = original ? live.original : live.motion;
    const known = taken.get(motion) ?? new Map<string, Values>();
    taken.set(motion, known);
    let found = known.get(name);
    if (!found) known.set(name, (found = shown(live.signal(name, motion), size(name))));
    return found;
  };
  const moments = new WeakMap<readonly number[], readonly number[]>();
  const timesOf = ({ times }: Motion): readonly number[] => {
    let found = moments.get(times);
    if (!found) moments.set(times, (found = times.map((each) => each / data.second)));
    return found;
  };
  const elements = data.owners.flatMap(({ kind, of, count }) => {
    const text = kinds[kind] ?? "";
    return Array<string>(count).fill(kind === "point" && of ? `${text} (${of})` : text);
  });
  return {
    list: data.signals.map((name, i) => {
      return { name, unit: data.units[i]!, element: elements[i] ?? "", quantity: quantities.get(name) ?? "" };
    }),
    axes: data.axes,
    get changed() {
      return live.changed;
    },
    has: (name) => numbers.has(name),
    unit: (name) => data.units[numbers.get(name) ?? -1] ?? "",
    values,
    times: (original = false) => timesOf(original ? live.original : live.motion),
    marks: (name, vector) => marksOf(live, name, vector, size(name)),
  };
}

const shown = (row: Float64Array | undefined, size: number): Values =>
  Array.from(row ?? [], (value) => (Number.isFinite(value) ? value / size : null));

/** What the measures of a signal say of it: their places; and limits of requirements, where values of the signal have
 * them. Of a negative or a magnitude that is measured, the signal's own values. */
function marksOf(live: LiveModel, name: string, vector: boolean, size: number): Marks {
  const { data, motion } = live;
  const levels: Level[] = [];
  const places: Place[] = [];
  data.measured.forEach((measured, i) => {
    if (measured?.signal !== name || (measured.by === "vector") !== vector) return;
    const measure = data.measures[i]!;
    const sign = measured.by === "negative" ? -1 : 1;
    for (const [label, { value, time }] of Object.entries(figuresOf(live, i) ?? {})) {
      if (time === null) continue;
      // A magnitude has lost its sign, an angle its whole turns: the curve itself says where it is.
      const exact = measured.level && measured.by !== "magnitude" && !measure.wrap;
      const text = label ? `${measure.name} ${label}` : measure.name;
      places.push({ time: time / data.second, value: exact ? (sign * value) / size : null, text });
    }
    const { requirement, wrap } = measure;
    if (!requirement || wrap || !measured.level) return;
    const ends: readonly (LiveNumber | null)[] = [requirement.low, requirement.high];
    for (const end of ends) {
      const value = end && numberOn(end, rowsOf(motion)) / size;
      if (value === null || !Number.isFinite(value)) continue;
      const text = `${measure.name} ${requirement.text}`;
      levels.push({ value: sign * value, text });
      if (measured.by === "magnitude" && value) levels.push({ value: -value, text });
    }
  });
  return { levels, places };
}

