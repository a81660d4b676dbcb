// The mechanism of a page: values of its numbers, the motion at them, and the original to compare with.

import { wrapped } from "../program/angles.ts";
import type { Program } from "../program/data.ts";
import { type Dragged, drag } from "../program/drag.ts";
import { Mechanism, type Motion } from "../program/mechanism.ts";
import type { LiveData } from "./live_data.ts";

/** Of how many rows one is compared. */
const EVERY = 3;
/** A prime: the pose at which the probe of row i lies is i times this, modulo the number of poses. */
const PROBES = 7919;
/** By how much a probe may differ, over its row's largest value. */
const CLOSE = 1e-9;
/** Changes that come within this time (ms) of each other are one. */
const STROKE = 600;

/** What may keep a drag from its target: numbers at the ends of their sliders, or that none may change. */
export interface Hindrance {
  readonly ended: readonly number[];
  readonly locked: boolean;
}

export class LiveModel {
  readonly data: LiveData;
  readonly mechanism: Mechanism;
  readonly original: Motion;
  /** Whether this browser finds the recorded values. */
  readonly sound: boolean;
  readonly values: Float64Array;
  motion: Motion;
  /** The values of the last motion without a failure. */
  private closing: Float64Array;
  /** Whether there was one. */
  closed: boolean;
  /** The values of before each change, those of the present motion, and when they came (ms). */
  private readonly history: Float64Array[] = [];
  private computed: Float64Array;
  private last = -Infinity;
  private gesture: { noted: boolean } | null = null;
  /** The number of the data by its place among the free parameters; -1 where it stands nowhere in the file. */
  private readonly places: number[];
  /** The place of a number of the data among the free parameters. */
  private readonly own: number[];
  /** Its place among all parameters. */
  private readonly derived: number[];
  private readonly listeners = new Set<() => void>();

  constructor(data: LiveData, programs: readonly Program[]) {
    this.data = data;
    this.mechanism = new Mechanism(data.program, programs, data.times);
    const { free } = data.program;
    this.places = free.map((name) => data.numbers.findIndex((number) => number.name === name));
    this.own = data.numbers.map(({ name }) => free.indexOf(name));
    this.derived = data.numbers.map(({ name }) => data.parameters.indexOf(name));
    this.values = Float64Array.from(data.program.values);
    this.original = this.run(this.values);
    this.motion = this.original;
    this.closing = this.values.slice();
    this.closed = !this.original.failure;
    this.computed = this.values.slice();
    this.sound = this.probed();
  }

  /** Calls back after each change. */
  on(callback: () => void): void {
    this.listeners.add(callback);
  }

  get changed(): boolean {
    return this.values.some((value, i) => value !== this.data.program.values[i]);
  }

  /** The value of a number of the data, by its place there. */
  value(number: number): number {
    const value = this.values[this.own[number]!]!;
    return this.states(value) ? value : this.motion.parameters[this.derived[number]!]!;
  }

  /** Whether a number of the data was moved; one that follows from the sketch isn't by that. */
  moved(number: number): boolean {
    const own = this.own[number]!;
    return this.values[own] !== this.data.program.values[own];
  }

  /** Whether the value of a free parameter is one: those of the sketch have none until they are moved. */
  private states(value: number): boolean {
    return Math.abs(value) < this.data.program.largest;
  }

  set(number: number, value: number): void {
    this.values[this.own[number]!] = value;
    this.compute();
  }

  reset(number: number | null = null): void {
    if (number === null) this.values.set(this.data.program.values);
    else this.values[this.own[number]!] = this.data.program.values[this.own[number]!]!;
    this.compute();
  }

  /** Back to the last values at which all poses close. */
  back(): void {
    this.restore(this.closing);
  }

  /** To values that were noted. */
  restore(values: ArrayLike<number>): void {
    this.values.set(values);
    this.compute();
  }

  /** All changes until the end of a gesture are one step back. */
  begin(): void {
    this.gesture = { noted: false };
  }

  end(): void {
    this.gesture = null;
    this.last = -Infinity;
  }

  /** Back to before the last change, or stroke of changes; false where there was none. */
  undo(): boolean {
    const before = this.history.pop();
    if (!before) return false;
    this.last = -Infinity;
    this.values.set(before);
    this.computed = before;
    this.compute();
    return true;
  }

  get undoable(): boolean {
    return this.history.length > 0;
  }

  /** Bring a point to a place (m) by the numbers of some links that aren't held, and where these can't by the time (s).
   * Without links all numbers may change. */
  drag(
    point: number,
    target: readonly [number, number],
    time: number,
    links: readonly string[] | null,
    held: (number: number) => boolean,
  ): Dragged & Hindrance {
    const { numbers, program } = this.data;
    const { times } = this.motion;
    const each = this.places.map((number) => numbers[number]);
    const own = new Set(links?.flatMap((link) => program.shaping[link] ?? []));
    // What stands on the frame stays, where the links have other numbers.
    const frame = new Set(links?.includes("frame") ? [] : program.shaping["frame"]);
    const stated = Array.from(this.values, (value) => this.states(value));
    const movable = each.map(
      (number, i) =>
        stated[i]! && !!number && !number.locked && !held(this.places[i]!) && (links === null || own.has(i)),
    );
    const stays = links !== null && movable.some((may, i) => may && !frame.has(i)) ? frame : new Set<number>();
    const found = drag(this.mechanism, this.values, time, point, target, {
      times: [times[0]!, times.at(-1)!],
      sizes: each.map((number) => number?.scale ?? 1),
      low: each.map((number, i) => (stated[i] ? (number?.low ?? 0) : -Infinity)),
      high: each.map((number, i) => (stated[i] ? (number?.high ?? 0) : Infinity)),
      held: movable.map((may, i) => !may || stays.has(i)),
    });
    if (Number.isFinite(found.off)) {
      this.values.set(found.free);
      this.compute();
    }
    const ended = found.limits.map((i) => this.places[i]!).filter((number) => number >= 0);
    return { ...found, ended, locked: movable.every((may, i) => !may || stays.has(i)) };
  }

  /** A signal of a motion in SI by its name; undefined where the page has none. */
  signal(name: string, motion = this.motion): Float64Array | undefined {
    const at = this.data.signals.indexOf(name);
    return at < 0 ? undefined : motion.rows[4 * this.data.poses.length + at];
  }

  /** What is left of the balance of power, over the largest powers; null where nothing has any. */
  get powerResidual(): number | null {
    const [left, size] = this.motion.rows.slice(-2);
    if (!this.data.power || !left || !size) return null;
    const most = (row: Float64Array): number =>
      row.reduce((largest, value) => (Math.abs(value) > largest ? Math.abs(value) : largest), 0);
    return most(size) ? most(left) / most(size) : null;
  }

  private compute(): void {
    // Changes that follow each other within a breath are one step back.
    if (this.values.some((value, i) => value !== this.computed[i])) {
      const first = this.gesture === null ? performance.now() - this.last > STROKE : !this.gesture.noted;
      if (first) this.history.push(this.computed);
      if (this.gesture) this.gesture.noted = true;
      this.last = performance.now();
      this.computed = this.values.slice();
    }
    this.motion = this.run(this.values);
    if (!this.motion.failure) [this.closing, this.closed] = [this.values.slice(), true];
    for (const listener of this.listeners) listener();
  }

  private run(values: ArrayLike<number>): Motion {
    const motion = this.mechanism.run(values);
    for (const i of this.data.wrapped) unwrap(motion.rows[4 * this.data.poses.length + i]!);
    return motion;
  }

  private probed(): boolean {
    // Of a motion with gaps nothing was verified but its poses.
    const rows = this.original.failure ? 4 * this.data.poses.length : Infinity;
    return this.data.probes.every((probe, k) => {
      const i = EVERY * k;
      if (i >= rows) return true;
      const row = this.original.rows[i]!;
      const here = row[(i * PROBES) % row.length]!;
      if (probe === null) return !Number.isFinite(here);
      return Math.abs(here - probe) <= CLOSE * this.data.scales[k]!;
    });
  }
}

/** Makes an angle continuous, in place; behind a gap it goes on from before it. */
function unwrap(row: Float64Array): void {
  let last = NaN;
  row.forEach((value, k) => {
    if (!Number.isFinite(value)) return;
    if (Number.isFinite(last)) row[k] = last + wrapped(value - last);
    last = row[k]!;
  });
}
