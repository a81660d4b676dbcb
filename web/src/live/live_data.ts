// What a report brings to compute its mechanism itself (linkwright/report/live.py). Times in s, all values in SI.

import type { LiveMeasure } from "../measures/measure.ts";
import type { Outline, Program, ProgramData } from "../program/data.ts";

/** A number of the model file that can be moved: its place in the file, its value with bounds, its unit. */
export interface LiveNumber {
  readonly name: string;
  readonly label: string;
  readonly value: number;
  readonly low: number;
  readonly high: number;
  /** Within which it may lie by its tolerance. */
  readonly tolerance: readonly [number, number] | null;
  readonly unit: string;
  readonly size: number;
  readonly named: boolean;
  /** Whether it follows from the sketch until it is moved; the file has no digits of it. */
  readonly drawn: boolean;
  readonly locked: boolean;
  /** What a change is measured by. */
  readonly scale: number;
  /** Its line among those of the data, and the columns of its digits there. */
  readonly line: number;
  readonly start: number;
  readonly end: number;
}

export interface MeasuredSignal {
  readonly signal: string;
  readonly by: "value" | "negative" | "magnitude" | "vector";
  readonly level: boolean;
}

export interface LiveData {
  readonly program: ProgramData;
  readonly times: readonly number[];
  /** The SI sizes of the units of lengths and times. */
  readonly length: number;
  readonly second: number;
  /** The links whose poses come first among the outputs, four rows each. */
  readonly poses: readonly string[];
  readonly signals: readonly string[];
  /** Other rows, behind the signals, that arrows name. */
  readonly arrow_rows: readonly string[];
  readonly sizes: readonly number[];
  readonly units: readonly string[];
  /** The elements of the signals, one after the other, each of so many. */
  readonly owners: readonly { readonly kind: string; readonly of: string; readonly count: number }[];
  /** The signals that can stand in place of the time. */
  readonly axes: readonly string[];
  readonly wrapped: readonly number[];
  readonly probes: readonly (number | null)[];
  readonly scales: readonly number[];
  readonly measures: readonly LiveMeasure[];
  /** Lines on links, one program each; whether some are those of cams. */
  readonly outlines: readonly Outline[];
  readonly cams: boolean;
  /** Whether the last two rows are what the powers of a pose leave, and their size. */
  readonly power: boolean;
  /** Of each measure the signal that it is of: its value, the negative one, its magnitude, that of the vector of which
   * it is the x component; and whether limits of the measure are limits of these values. */
  readonly measured: readonly (MeasuredSignal | null)[];
  readonly numbers: readonly LiveNumber[];
  /** Where the file takes a further parameter: in a line, in braces at a column or below it with an indent; without a
   * line in a section of its own. */
  readonly entry?: {
    readonly line?: number | null;
    readonly column: number;
    readonly indent: string;
    readonly unit: string;
  } | null;
  /** The lines of the file in which numbers stand. */
  readonly lines: readonly string[];
  readonly drives: readonly string[];
  /** The drive by whose values it is said where the mechanism can't be assembled; null where it is by the time. */
  readonly by: { readonly drive: number; readonly size: number } | null;
  readonly parameters: readonly string[];
  /** The places of the conditions on numbers, in the program's order, and the SI sizes of the units of their values,
   * none where all are 1. */
  readonly conditions: { readonly places: readonly string[]; readonly sizes: readonly number[] };
}

declare global {
  /** Set by a script of the page: the emitted programs. */
  var linkwrightPrograms: readonly Program[];
}
