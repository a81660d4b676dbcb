// What a page gets of a mechanism: emitted programs, and what joins them (linkwright/kernels/page_programs.py).
// All numbers are in SI. Rows are those of the inputs of one pose.

/** An emitted program: what depends on the parameters alone is computed once, then pose by pose. */
export interface Program {
  parameters(p: ArrayLike<number>): void;
  pose(x: ArrayLike<number>, out: Float64Array): void;
}

/** A group beyond the dyads, solved by Newton: `scale` measures the steps of its coordinates, of which some `slide`. */
export interface HigherGroup {
  group: string;
  rows: number[];
  scale: number[];
  slides: boolean[];
  start: number[];
}

/** A table as polynomials of what its argument is past a knot, lowest power first. */
export interface Table {
  knots: number[];
  powers: number[][];
  ends: [number, number];
  period: number | null;
}

/** An answer of a table, or of its integral: its value in this row, its rate in the next. */
export interface Lookup {
  row: number;
  table: number;
  integral: boolean;
}

/** Closed lines on a link: how many, and the inputs of their program at each place of them. */
export interface Outline {
  readonly link: string;
  readonly lines: number;
  readonly inputs: readonly (readonly number[])[];
  /** The signal whose lowest and highest value are the last two inputs. */
  readonly travel?: string;
  /** Of open lines, which are drawn as slots, how wide (m). */
  readonly width?: number;
}

/** How many programs there are of each kind, in the order of the array of programs. */
export type Counts = Record<
  | "derived"
  | "constants"
  | "laws"
  | "law_slopes"
  | "closures"
  | "turns"
  | "lookups"
  | "ratios"
  | "signals"
  | "nearest"
  | "dragged"
  | "slopes"
  | "shape"
  | "outlines",
  number
>;

export interface ProgramData {
  programs: Counts;
  /** Parameters that depend on no other: names, nominal values, and those that can't be moved. */
  free: string[];
  values: number[];
  locked: string[];
  /** Of all parameters, by number: how many there are. */
  parameters: number;
  inputs: number;
  drives: { count: number; width: number };
  branches: number[];
  /** The dyads with two modes, in the order of their reaches. */
  groups: string[];
  size: number;
  higher: HigherGroup[];
  time: number | null;
  turns: { row: number; started: boolean }[];
  tables: Table[];
  lookups: Lookup[][];
  ratios: { rows: [number, number]; motor: number }[];
  totals: [number, number][];
  outputs: number;
  /** How many rows are computed with their rates. */
  measured: number;
  /** How many numbers the shapes of links are. */
  shape: number;
  /** Of each link, which free parameters its points depend on. */
  shaping: Record<string, number[]>;
  /** The points that may be dragged, and the links whose poses are known, by name. */
  points: string[];
  links: string[];
  /** What each number that is checked must be, a digit each: 0 smaller than the largest, 1 not negative, 2 positive. */
  conditions: string;
  /** The further figures of the conditions' sentences: of which condition, and the SI value of the unit. */
  figures: (readonly [number, number])[];
  largest: number;
}
