// A mechanism in the page: from the values of its free parameters to all signals over a grid of times.

import { MAX_TURN, wholeTurns, wrapped } from "./angles.ts";
import type { Outline, Program, ProgramData } from "./data.ts";
import { HigherGroups, PATIENCE } from "./higher_groups.ts";
import { Pose } from "./pose.ts";
import { answer } from "./tables.ts";

/** Why and from which pose on a mechanism has no motion: a `parameter` without a value, a `number` that must not be
 * so, a `drive` without a value, a `group` (by its number) that can't close, a `higher` one that can't be followed. */
export interface Failure {
  kind: "parameter" | "number" | "drive" | "group" | "higher";
  index: number;
  pose: number;
  /** Of a number, its value (SI), and the other figures of the sentence on it in their units. */
  value?: number;
  figures?: readonly number[];
}

/** The signals of a mechanism at a set of parameters. A row is NaN where a pose can't be assembled. */
export interface Motion {
  rows: Float64Array[];
  /** Of each dyad with two modes its reach, negative where it can't close. */
  reaches: Float64Array[];
  /** Rows that measures look at, with their rates. */
  measured: { values: Float64Array; rates: Float64Array }[];
  parameters: Float64Array;
  /** When its poses are (s): a run of so many turns takes longer with a slower motor. */
  times: readonly number[];
  failure: Failure | null;
}

/** Kinds of programs with other parameters than all the others. */
const OWN_PARAMETERS = new Set(["derived", "slopes", "dragged", "law_slopes"]);
const STEEPEST = 12; // halvings of a stretch between two times while a turning angle is followed

export class Mechanism {
  private readonly kinds: Record<string, Program[]> = {};
  private readonly p: Float64Array;
  private readonly nominal: Float64Array;
  private readonly out: Float64Array;
  private readonly laws: Float64Array;
  private readonly shapes: Float64Array;
  /** The inputs of all poses of the last motion. */
  readonly poses: Float64Array[];
  private readonly higher: HigherGroups;
  /** How much the program of the signals gives. */
  readonly size: number;
  readonly data: ProgramData;
  times: readonly number[];
  private readonly nominalTimes: readonly number[];
  /** When the run ends (s) at the nominal numbers, and at those of the moment; 0 where it never changes. */
  private readonly nominalEnd: number;
  private end: number;

  constructor(data: ProgramData, programs: readonly Program[], times: readonly number[]) {
    this.data = data;
    this.times = this.nominalTimes = times;
    let next = 0;
    for (const [kind, count] of Object.entries(data.programs)) {
      this.kinds[kind] = programs.slice(next, (next += count));
    }
    this.p = new Float64Array(data.parameters);
    this.size = data.outputs + data.groups.length + 2 * data.measured;
    this.out = new Float64Array(this.size);
    this.shapes = new Float64Array(data.shape);
    this.laws = new Float64Array(data.drives.count * data.drives.width);
    const all = new Float64Array(times.length * data.inputs);
    this.poses = times.map((_, k) => all.subarray(k * data.inputs, (k + 1) * data.inputs));
    this.higher = new HigherGroups(data.higher, this.kinds["closures"]!, data.inputs);
    this.nominal = this.derived(data.values).slice();
    this.end = this.nominalEnd = this.constants(this.nominal).at(-1)!;
  }

  /** All parameters (SI) from the free ones. */
  derived(free: ArrayLike<number>): Float64Array {
    this.only("derived").pose(free, this.p);
    return this.p;
  }

  only(kind: keyof ProgramData["programs"]): Program {
    return this.kinds[kind]![0]!;
  }

  /** The mechanism at one time (s), whose parameters may be moved; null where it can't be assembled. */
  posed(free: ArrayLike<number>, time: number): Pose | null {
    const parameters = this.derived(free).slice();
    if (this.data.higher.length && !this.followed(parameters, [time])) return null;
    return new Pose(this, this.higher, free, time);
  }

  /** All signals at some values of the free parameters, in their order. */
  run(free: ArrayLike<number>): Motion {
    const parameters = this.derived(free).slice();
    const poses = this.times.length;
    const all = new Float64Array(this.size * poses).fill(NaN); // one piece, as this is done at every frame of a drag
    const motion: Motion = {
      measured: [],
      rows: [],
      reaches: [],
      parameters,
      times: this.times,
      failure: null,
    };
    const rows = Array.from({ length: this.size }, (_, i) => all.subarray(i * poses, (i + 1) * poses));
    motion.rows = rows.slice(0, this.data.outputs);
    const rest = this.data.outputs + this.data.groups.length;
    motion.reaches = rows.slice(this.data.outputs, rest);
    motion.measured = Array.from({ length: this.data.measured }, (_, i) => ({
      values: rows[rest + 2 * i]!,
      rates: rows[rest + 2 * i + 1]!,
    }));
    const constants = this.constants(parameters);
    const missing = parameters.findIndex((value) => !(Math.abs(value) < this.data.largest));
    const [first, count] = [this.data.turns.length, this.data.conditions.length];
    const checked = constants.subarray(first, first + count);
    const wrong = this.wrongNumber(checked);
    if (missing >= 0 || wrong >= 0) {
      motion.failure =
        missing >= 0
          ? { kind: "parameter", index: missing, pose: 0 }
          : {
              kind: "number",
              index: wrong,
              pose: 0,
              value: checked[wrong]!,
              figures: this.figures(wrong, constants.subarray(first + count)),
            };
      return motion;
    }
    motion.times = this.times = this.spread(constants.at(-1)!);
    const lost = this.place(parameters);
    this.turn(constants);
    this.supply();
    this.times.forEach((_, k) => {
      this.only("signals").pose(this.poses[k]!, this.out);
      for (let i = 0; i < this.size; i++) all[i * poses + k] = this.out[i]!;
    });
    motion.failure = this.failure(motion, lost);
    return motion;
  }

  /** The times of all poses in a run that ends at another time (s). */
  private spread(end: number): readonly number[] {
    const { nominalEnd, nominalTimes } = this;
    if (end === this.end) return this.times;
    this.end = end;
    return end === nominalEnd ? nominalTimes : nominalTimes.map((time) => time * (end / nominalEnd));
  }

  /** What is computed once for some parameters. */
  private constants(parameters: Float64Array): Float64Array {
    const { turns, conditions, figures } = this.data;
    const found = new Float64Array(turns.length + conditions.length + figures.length + 1);
    this.tell(parameters);
    this.only("constants").pose([], found);
    return found;
  }

  /** The value of a drive (SI) at a time. */
  driveValue(drive: number, time: number): number {
    this.only("laws").pose([time], this.laws);
    return this.laws[drive * this.data.drives.width]!;
  }

  /** The shapes of links at some parameters: coordinates of points (m), angles of lines (rad). */
  shape(parameters: Float64Array): Float64Array {
    const program = this.only("shape");
    program.parameters(parameters);
    program.pose([], this.shapes);
    return this.shapes;
  }

  /** The places of lines (m), line by line, by their program and its inputs at each place, with what else it asks for;
   * none where the parameters don't allow it. */
  outline(
    number: number,
    { lines, inputs }: Outline,
    parameters: Float64Array,
    others: readonly number[] = [],
  ): [number, number][][] {
    const program = this.kinds["outlines"]![number]!;
    program.parameters(parameters);
    const out = new Float64Array(2 * lines);
    const found = Array.from({ length: lines }, (): [number, number][] => []);
    for (const at of inputs) {
      program.pose(others.length ? [...at, ...others] : at, out);
      found.forEach((line, i) => line.push([out[2 * i]!, out[2 * i + 1]!]));
    }
    return found.filter((line) => line.every((at) => at.every((value) => Number.isFinite(value))));
  }

  /** The rows of all poses; where dyads of the last motion can't close, those in which they come nearest to it. */
  nearest(motion: Motion): Float64Array[] {
    const count = 4 * this.data.links.length;
    const rows = motion.rows.slice(0, count).map((row) => row.slice());
    const out = new Float64Array(count + 3 * this.data.groups.length);
    for (const [k, x] of this.poses.entries()) {
      if (rows.every((row) => Number.isFinite(row[k]!))) continue;
      this.only("nearest").pose(x, out);
      for (const [i, row] of rows.entries()) row[k] = out[i]!;
    }
    return rows;
  }

  /** Let all programs know the parameters. */
  tell(parameters: Float64Array): void {
    for (const [kind, programs] of Object.entries(this.kinds)) {
      if (!OWN_PARAMETERS.has(kind)) for (const program of programs) program.parameters(parameters);
    }
  }

  /** The figures of a condition's sentence, of those of all. */
  private figures(condition: number, values: Float64Array): number[] {
    return this.data.figures.flatMap(([of, size], i) => (of === condition ? [values[i]! / size] : []));
  }

  private wrongNumber(values: Float64Array): number {
    const { conditions, largest } = this.data;
    const sound = [(v: number) => Math.abs(v) < largest, (v: number) => v >= 0, (v: number) => v > 0];
    return values.findIndex((value, i) => !sound[Number(conditions[i])]!(value));
  }

  /** Drives and branches of a pose at a time. */
  readonly drive = (time: number, x: Float64Array): void => {
    this.only("laws").pose([time], this.laws);
    x.set(this.laws);
    x.set(this.data.branches, this.laws.length);
    if (this.data.time !== null) x[this.data.time] = time;
    for (const [row, total] of this.data.totals) x[row] = total;
  };

  /** The motion's own inputs of all poses; from which pose on the higher groups can't be followed. */
  private place(parameters: Float64Array): number {
    this.times.forEach((time, k) => this.drive(time, this.poses[k]!));
    if (!this.data.higher.length) return this.times.length;
    let lost = this.times.length;
    this.followed(parameters, this.times, (k, known) => {
      if (!known) lost = Math.min(lost, k);
      this.higher.fill(this.poses[k]!);
    });
    return lost;
  }

  /** Follow the higher groups from the nominal start, in the parameters and then from time to time; whether they are
   * known at the last one. */
  private followed(
    parameters: Float64Array,
    times: readonly number[],
    at?: (k: number, known: boolean) => void,
  ): boolean {
    const homotopy = (share: number, x: Float64Array): void => {
      const { nominal } = this;
      this.tell(share < 1 ? parameters.map((goal, i) => nominal[i]! + share * (goal - nominal[i]!)) : parameters);
      this.drive(0, x);
    };
    let known = this.higher.begin(homotopy);
    this.tell(parameters);
    if (known) this.higher.restart(this.drive);
    const least = PATIENCE * Math.max(...times);
    for (const [k, time] of times.entries()) {
      known = this.higher.advance(this.drive, time, least);
      at?.(k, known);
    }
    return known;
  }

  /** The whole turns of angles that axes tell but for these: each runs on without jumps from the first time. */
  private turn(starts: Float64Array): void {
    this.data.turns.forEach(({ row, started }, i) => {
      const program = this.kinds["turns"]![i]!;
      const [here, y] = [new Float64Array(2), new Float64Array(2)];
      let path = NaN;
      let before: { time: number; x: Float64Array } | null = null;
      for (const [k, x] of this.poses.entries()) {
        program.pose(x, y);
        const time = this.times[k]!;
        x[row] = 0;
        if (!Number.isFinite(y[0]!)) continue; // what can't be assembled leaves the angle where it was
        if (before === null) path = y[0]! + (started ? 2 * Math.PI * wholeTurns(y[0]!, starts[i]!) : 0);
        else path += this.turned(program, before.time, here, time, y, 0);
        here.set(y);
        before = { time, x };
        x[row] = wholeTurns(y[0]!, path);
      }
    });
  }

  /** By how much an angle turns between two times, where it and its rate are known; in between it is looked at as
   * closely as it turns fast. */
  private turned(program: Program, a: number, from: Float64Array, b: number, to: Float64Array, depth: number): number {
    const foretold = ((b - a) * (from[1]! + to[1]!)) / 2;
    if (Math.abs(foretold) > MAX_TURN && depth < STEEPEST && !this.data.higher.length) {
      const [middle, x, y] = [(a + b) / 2, new Float64Array(this.data.inputs), new Float64Array(2)];
      this.drive(middle, x);
      program.pose(x, y);
      return this.turned(program, a, from, middle, y, depth + 1) + this.turned(program, middle, y, b, to, depth + 1);
    }
    return foretold + wrapped(to[0]! - from[0]! - foretold);
  }

  /** Answers of tables, level by level, and ratios of followers. */
  private supply(): void {
    this.data.lookups.forEach((asked, level) => {
      const program = this.kinds["lookups"]![level]!;
      const y = new Float64Array(2 * asked.length);
      for (const x of this.poses) {
        program.pose(x, y);
        asked.forEach(({ row, table, integral }, i) => {
          const [value, slope] = answer(this.data.tables[table]!, y[2 * i]!, integral);
          x[row] = value;
          x[row + 1] = slope * y[2 * i + 1]!;
        });
      }
    });
    const { ratios } = this.data;
    if (!ratios.length) return;
    const [given, y] = [new Float64Array(2 * ratios.length), new Float64Array(2 * ratios.length)];
    for (const x of this.poses) {
      ratios.forEach(({ motor }, i) => given.set([x[motor]!, x[motor + 1]!], 2 * i));
      this.only("ratios").pose(given, y);
      ratios.forEach(({ rows: [ratio, rate] }, i) => {
        x[ratio] = y[2 * i]!;
        x[rate] = y[2 * i + 1]!;
      });
    }
  }

  /** The first pose without a motion, and why: what comes first on the way of that pose. */
  private failure(motion: Motion, lost: number): Failure | null {
    const { count, width } = this.data.drives;
    for (const k of this.times.keys()) {
      for (let i = 0; i < count; i++) {
        const law = this.poses[k]!.subarray(i * width, i * width + 3);
        if (!law.every((value) => Number.isFinite(value))) return { kind: "drive", index: i, pose: k };
      }
      const index = motion.reaches.findIndex((reach) => reach[k]! < 0);
      if (index >= 0) return { kind: "group", index, pose: k };
      if (k >= lost) return { kind: "higher", index: 0, pose: k };
    }
    return null;
  }
}
