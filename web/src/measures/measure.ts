// What the page gets of a measure (JSON), what a rule looks at, and what it gives. Numbers are in SI, times in seconds.

import type { Interpolant } from "./samples.ts";

/** A number by its nominal value (null for none), and the row of the program that gives it where it moves. */
export interface LiveNumber {
  value: number | null;
  row: number | null;
}

/** A row of the program; `jumps`: by whole turns, which are counted; `angle`: zero is any number of whole turns. */
export interface LiveRow {
  row: number;
  jumps: boolean;
  angle: boolean;
}

/** Where a signal (without one, the time) lies between two ends; `turning`: or any whole turns from there. */
export interface LiveWindow {
  row: LiveRow | null;
  ends: [LiveNumber, LiveNumber];
  turning: boolean;
}

/** A requirement as it is written, and its ends; null on a side without one. */
export interface LiveRequirement {
  text: string;
  low: LiveNumber | null;
  high: LiveNumber | null;
}

/** A measure; with a `reason` (a key of the texts) it isn't shown live. Shown in `unit`, which is `size` in SI;
 * what isn't there, is none. */
export interface LiveMeasure {
  name: string;
  reduction: string;
  labels: string[];
  unit: string;
  size: number;
  reason: string | null;
  rows: Record<string, LiveRow>;
  watched: number[];
  window: LiveWindow | null;
  numbers: Record<string, LiveNumber>;
  words: Record<string, string>;
  wrap: [LiveNumber, LiveNumber] | null;
  requirement: LiveRequirement | null;
}

/** Values and rates of a row on the samples. */
export interface SampledRow {
  values: ArrayLike<number>;
  rates: ArrayLike<number>;
}

/** The rows of the program by their numbers. */
export type Rows = (row: number) => SampledRow;

export type Interval = readonly [number, number];

/** A number of a measure and its time, null where it has no place. */
export interface Figure {
  value: number;
  time: number | null;
}

/** Figures by label. */
export type Figures = Record<string, Figure>;

/** What a rule looks at: rows known all over the stretches of the window, of which there is one at least. */
export interface OnSamples {
  rows: Record<string, Interpolant>;
  stretches: Interval[];
  angles: Set<string>;
  numbers: Record<string, number>;
  words: Record<string, string>;
}

/** A reduction's rule; undefined where there are no figures. */
export type Rule = (samples: OnSamples) => Figures | undefined;

/** A row that the rule asked for. */
export function rowOf(samples: OnSamples, key = ""): Interpolant {
  const row = samples.rows[key];
  if (row === undefined) throw new Error(`the measure has no row "${key}"`);
  return row;
}

/** A number on the samples: it is the same on all. */
export function numberOn(number: LiveNumber, rows: Rows): number {
  return (number.row === null ? number.value : rows(number.row).values[0]) ?? NaN;
}
