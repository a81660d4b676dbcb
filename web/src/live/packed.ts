// Parts of a report's data as the file has them, shorter than they are (linkwright/report/packed.py).

import type { LiveData } from "./live_data.ts";

/** Lists in which few values recur have these, and the number of each entry's. */
export interface List<T> {
  readonly of: readonly T[];
  readonly at: readonly number[];
}

/** Times (s) one by one, or at equal distances. */
type Times = readonly number[] | { readonly from: number; readonly to: number; readonly count: number };

/** The elements in the order of their signals: kind, names, the beginning of the signals' names, the number of the list
 * of endings. */
interface Signals {
  readonly owners: readonly (readonly [kind: string, of: string, stem: string, endings: number])[];
  readonly endings: readonly (readonly string[])[];
}

/** Numbers and measures, which have the size of their unit of their own only where that isn't among all sizes. */
type Sized<T extends { readonly unit: string; readonly size: number }> = Omit<T, "size"> & { readonly size?: number };

type Shortened = "numbers" | "measures" | "times" | "signals" | "owners" | "sizes" | "units" | "conditions";

export type Packed = Omit<LiveData, Shortened> & {
  readonly numbers: readonly Sized<LiveData["numbers"][number]>[];
  readonly measures: readonly Sized<LiveData["measures"][number]>[];
  /** The SI sizes of units, by what they are called; a number of no unit has none. */
  readonly unit_sizes: Readonly<Record<string, number>>;
  readonly times: Times;
  readonly signals: Signals;
  readonly sizes: List<number>;
  readonly units: List<string>;
  readonly conditions: { readonly places: readonly string[]; readonly sizes: List<number> };
};

export const unpacked = <T>({ of, at }: List<T>): T[] => at.map((i) => of[i]!);

/** The digits that times have. */
const DIGITS = 13;

export function timesOf(times: Times): readonly number[] {
  if (!("from" in times)) return times;
  const { from, to, count } = times;
  const step = (k: number): number => from + ((to - from) * k) / Math.max(count - 1, 1);
  return Array.from({ length: count }, (_, k) => Number(step(k).toPrecision(DIGITS)));
}

export function signalsOf({ owners, endings }: Signals): Pick<LiveData, "signals" | "owners"> {
  const signals = owners.flatMap(([, , stem, list]) => endings[list]!.map((end) => (stem ? `${stem}.${end}` : end)));
  return { signals, owners: owners.map(([kind, of, , list]) => ({ kind, of, count: endings[list]!.length })) };
}
