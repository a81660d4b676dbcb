// The coordinates of groups beyond the dyads, by continuation: from the nominal start pose in the parameters, then in
// time. A step predicts by the closures' slopes, Newton corrects, and it is accepted only where the correction is
// small, forward and backward, and where the pose that is reached is certified; else it is halved. So no pose jumps to
// another assembly mode. The rules are those of linkwright/kernels/continuation_batch.py and step_certificate.py: the
// determinant of the slopes keeps its sign between poses in which modes meet, and Newton has one root near by where the
// slopes change little, relative to themselves, on its way there.

import type { HigherGroup, Program } from "./data.ts";
import { solve } from "./linear.ts";

const [SOLVED, ACCEPTED, MOST_STEPS] = [1e-14, 1e-10, 30];
const [CLOSE, STRIDE] = [1e-2, 0.5];
/** The most by which slopes may change on the way of Newton; a way shorter than this needs no look. */
const [BENT, SURE] = [0.25, 1e-7];

/** Steps shorter than this share of the way have met a singular pose. */
export const PATIENCE = 1e-9;

/** Puts the inputs of a pose, but for the coordinates, into `x`; programs know the parameters that belong to it. */
export type Place = (at: number, x: Float64Array) => void;

/** One group's closure at a pose: what it misses, its slopes, and Newton on them. */
class Closure {
  readonly n: number;
  readonly group: HigherGroup;
  private readonly program: Program;
  private readonly y: Float64Array;
  private readonly matrix: Float64Array;
  private readonly step: Float64Array;

  constructor(group: HigherGroup, program: Program) {
    this.group = group;
    this.program = program;
    this.n = group.rows.length;
    this.y = new Float64Array(this.n + this.n * this.n);
    this.matrix = new Float64Array(this.n * this.n);
    this.step = new Float64Array(this.n);
  }

  evaluate(x: Float64Array): void {
    this.program.pose(x, this.y);
  }

  get slopes(): Float64Array {
    return this.y.slice(this.n);
  }

  get missed(): Float64Array {
    return this.y.slice(0, this.n);
  }

  /** How far a step goes: the largest over the coordinates' scales, or over how far out a slide is. */
  largest(step: ArrayLike<number>, u: ArrayLike<number>): number {
    let far = 0;
    this.group.scale.forEach((_, i) => {
      const part = Math.abs(step[i]!) / this.size(u, i);
      far = Number.isNaN(part) || Number.isNaN(far) ? NaN : Math.max(far, part);
    });
    return far;
  }

  /** What a step of a coordinate is measured by. */
  private size(u: ArrayLike<number>, i: number): number {
    const scale = this.group.scale[i]!;
    return this.group.slides[i] ? Math.max(scale, Math.abs(u[i]!)) : scale;
  }

  /** How much slopes change from foretold coordinates to those that Newton gives, relative to those foretold. */
  bending(foretold: Float64Array, solved: Float64Array, u: ArrayLike<number>): number {
    const { n } = this;
    const sums = new Float64Array(n);
    for (let j = 0; j < n; j++) {
      const change = Float64Array.from(sums, (_, i) => solved[i * n + j]! - foretold[i * n + j]!);
      solve(foretold.slice(), change);
      change.forEach((part, i) => (sums[i]! += Math.abs(part * this.size(u, j)) / this.size(u, i)));
    }
    return Math.max(...sums);
  }

  /** The sign of the determinant of slopes. */
  mode(slopes: Float64Array): number {
    return solve(slopes.slice(), new Float64Array(this.n));
  }

  /** Newton from the coordinates that stand in `x`, which it replaces; NaN where it doesn't get there. */
  newton(x: Float64Array): void {
    const { rows } = this.group;
    let moved = Infinity;
    for (let k = 0; k < MOST_STEPS && moved >= SOLVED; k++) {
      this.evaluate(x);
      this.matrix.set(this.y.subarray(this.n));
      this.step.set(this.y.subarray(0, this.n));
      solve(this.matrix, this.step);
      rows.forEach((row, i) => (x[row]! -= this.step[i]!));
      moved = this.largest(this.step, this.coordinates(x));
    }
    if (!(moved < ACCEPTED)) for (const row of rows) x[row] = NaN;
  }

  coordinates(x: Float64Array): Float64Array {
    return Float64Array.from(this.group.rows, (row) => x[row]!);
  }

  put(u: ArrayLike<number>, x: Float64Array): void {
    this.group.rows.forEach((row, i) => (x[row] = u[i]!));
  }

  /** Newton's step for slopes and misses. */
  stepOf(slopes: Float64Array, missed: Float64Array): Float64Array {
    const [matrix, step] = [slopes.slice(), missed.slice()];
    solve(matrix, step);
    return step;
  }
}

/** The coordinates of all higher groups, where they stand now. */
export class HigherGroups {
  private readonly closures: Closure[];
  private readonly x: Float64Array;
  /** Of each group: its coordinates, and its closure's slopes there. */
  private u: Float64Array[] = [];
  private slopes: Float64Array[] = [];
  /** The signs of the slopes' determinants at the nominal start: the assembly modes. */
  private modes: number[] = [];
  private now = 0;

  constructor(groups: readonly HigherGroup[], programs: readonly Program[], inputs: number) {
    this.closures = groups.map((group, k) => new Closure(group, programs[k]!));
    this.x = new Float64Array(inputs);
  }

  get known(): boolean {
    return this.u.every((u) => u.every((value) => Number.isFinite(value)));
  }

  /** Begin at the nominal start, and go on in the parameters (`share` 0 to 1). False where that leads nowhere. */
  begin(place: Place): boolean {
    this.u = this.closures.map((closure) => Float64Array.from(closure.group.start));
    this.now = 0;
    this.look(place);
    this.modes = this.closures.map((closure, k) => closure.mode(this.slopes[k]!));
    return this.advance(place, 1, PATIENCE);
  }

  /** From here on, places are times (s). */
  restart(place: Place): void {
    this.now = 0;
    this.look(place);
  }

  /** Where the groups stand, to come back to. */
  kept(): Float64Array[] {
    return this.u.map((u) => u.slice());
  }

  restore(kept: readonly Float64Array[]): void {
    this.u = kept.map((u) => u.slice());
  }

  /** Put the coordinates into a pose's inputs. */
  fill(x: Float64Array): void {
    this.closures.forEach((closure, k) => closure.put(this.u[k]!, x));
  }

  /** Go on to a place, by steps not shorter than `least`. False, and all coordinates unknown, where that can't be. */
  advance(place: Place, target: number, least: number): boolean {
    let step = Infinity;
    while (this.now < target && this.known) {
      const there = Math.min(this.now + step, target);
      const length = there - this.now;
      const off = this.try(place, there);
      if (off < 1) {
        this.now = there;
        step = length * (off < 1 / 3 ? 1.5 : 1);
      } else {
        step = length / 2;
        if (step < least) for (const u of this.u) u.fill(NaN);
      }
    }
    return this.known;
  }

  /** The slopes of the closures where the groups stand. */
  private look(place: Place): void {
    place(this.now, this.x);
    this.fill(this.x);
    this.slopes = this.closures.map((closure) => {
      closure.evaluate(this.x);
      return closure.slopes;
    });
  }

  /** A step's error over what is allowed; where that is under 1 the groups stand there. */
  private try(place: Place, there: number): number {
    place(there, this.x);
    this.fill(this.x);
    const found: Float64Array[] = [];
    const ends: Float64Array[] = [];
    let worst = 0;
    for (const [k, closure] of this.closures.entries()) {
      const u = this.u[k]!;
      closure.evaluate(this.x);
      const missed = closure.missed;
      const ahead = closure.stepOf(this.slopes[k]!, missed);
      const guess = u.map((value, i) => value - ahead[i]!);
      closure.put(guess, this.x);
      closure.evaluate(this.x);
      const foretold = closure.slopes;
      closure.newton(this.x);
      const here = closure.coordinates(this.x);
      closure.evaluate(this.x);
      const ending = closure.slopes;
      const behind = closure.stepOf(ending, missed);
      const corrected = closure.largest(here.map((value, i) => value - guess[i]!), here);
      const off = Math.max(
        corrected,
        closure.largest(here.map((value, i) => value + behind[i]! - u[i]!), here),
      );
      const moved = closure.largest(here.map((value, i) => value - u[i]!), here);
      worst = Math.max(worst, off / CLOSE, moved / STRIDE);
      const bent = corrected < SURE ? 0 : closure.bending(foretold, ending, here);
      if (closure.mode(ending) !== this.modes[k] || !(bent < BENT)) worst = NaN;
      found.push(here);
      ends.push(ending);
    }
    if (worst < 1) [this.u, this.slopes] = [found, ends];
    return worst;
  }
}
