// The signals from which plots are made: those of a live model, or those that a recorded report brings with its plots.

import type { Plot, Values } from "../scene/data.ts";

/** An element in the words of the page, as a list of signals names it. */
export interface Listed {
  readonly name: string;
  readonly unit: string;
  readonly element: string;
  /** What it is in words, such as a velocity, where a plot of the report says so. */
  readonly quantity?: string;
}

/** A plot of the report, and by what else its signals are looked for. */
export type Sought = Plot & { readonly also?: string };

/** A place of a measure in the plot of its signal: which sample's time it is nearest to, and how it is called. */
export interface Place {
  readonly time: number;
  readonly value: number | null;
  readonly text: string;
}

/** A limit of a requirement on values of a signal. */
export interface Level {
  readonly value: number;
  readonly text: string;
}

export interface Marks {
  readonly levels: readonly Level[];
  readonly places: readonly Place[];
}

export interface Signals {
  /** All signals; none where a reader can't choose. */
  readonly list: readonly Listed[];
  /** The signals that can stand in place of the time. */
  readonly axes: readonly string[];
  /** Whether values differ from the original ones. */
  readonly changed: boolean;
  has(name: string): boolean;
  unit(name: string): string;
  /** Values in the unit, null where there is none; `original`: before all changes. */
  values(name: string, original?: boolean): Values;
  /** When the samples are, in the page's unit, where that follows the numbers; `original`: before all changes. */
  times?(original?: boolean): readonly number[];
  /** What measures say of a signal, or of the magnitude of the vector of which it is the x component. */
  marks(name: string, vector: boolean): Marks;
}

const NOTHING: Marks = { levels: [], places: [] };

/** Those of recorded plots. */
export function recordedSignals(plots: readonly Plot[]): Signals {
  const every = plots.flatMap(({ series, unit }) => series.map((each) => ({ ...each, unit })));
  const found = new Map(every.map((each) => [each.name, each]));
  return {
    list: [],
    axes: [],
    changed: false,
    has: (name) => found.has(name),
    unit: (name) => found.get(name)?.unit ?? "",
    values: (name) => found.get(name)?.values ?? [],
    marks: () => NOTHING,
  };
}
