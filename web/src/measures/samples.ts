// A signal between samples: the piecewise cubic with its values and exact rates there. Operation by operation as
// src/linkwright/reductions/interpolant.py and samples.py, to the same bits.

import type { Interval, SampledRow } from "./measure.ts";

type Cubic = readonly [number, number, number, number];
type Node = readonly [number, number, number];

const TURN = 2 * Math.PI;
const GAUSS: readonly (readonly [number, number])[] = [
  [-0.8611363115940526, 0.3478548451374538],
  [-0.3399810435848563, 0.6521451548625461],
  [0.3399810435848563, 0.6521451548625461],
  [0.8611363115940526, 0.3478548451374538],
];
const LEVEL = 1e-14;
const MOST_LOOKS = 60;
/** An angle that turns further can't be looked at on samples. */
const MOST_TURNS = 1000;

/** A signal at times `t` (s, ascending, at least two) with its values and rates per second.
 *
 * A value that isn't finite makes both steps beside it unknown. A rate that isn't finite, or would carry the signal
 * past its whole range within the step, isn't used: the step is a parabola then, or a line. */
export class Interpolant {
  readonly t: ArrayLike<number>;
  readonly values: ArrayLike<number>;
  readonly cubics: Cubic[];

  constructor(t: ArrayLike<number>, values: ArrayLike<number>, cubics: Cubic[]) {
    this.t = t;
    this.values = values;
    this.cubics = cubics;
  }

  static of(t: ArrayLike<number>, values: ArrayLike<number>, rates: ArrayLike<number>): Interpolant {
    let least = Infinity;
    let most = -Infinity;
    for (let i = 0; i < values.length; i++) {
      const value = values[i]!;
      if (!Number.isFinite(value)) continue;
      if (value < least) least = value;
      if (value > most) most = value;
    }
    const span = most >= least ? most - least : NaN;
    const cubics: Cubic[] = [];
    for (let i = 0; i + 1 < t.length; i++) {
      const step = t[i + 1]! - t[i]!;
      const change = values[i + 1]! - values[i]!;
      const [first, last] = ends(change, rates[i]! * step, rates[i + 1]! * step, span);
      const more = 3 * change - 2 * first - last;
      cubics.push([values[i]!, first, more, first + last - 2 * change]);
    }
    return new Interpolant(t, values, cubics);
  }

  /** a x + b y of two signals at the same times. */
  static mixed(x: Interpolant, y: Interpolant, a: number, b: number): Interpolant {
    const values = new Float64Array(x.t.length);
    for (let i = 0; i < values.length; i++) values[i] = a * x.values[i]! + b * y.values[i]!;
    const cubics = x.cubics.map((p, i): Cubic => {
      const q = y.cubics[i]!;
      return [a * p[0] + b * q[0], a * p[1] + b * q[1], a * p[2] + b * q[2], a * p[3] + b * q[3]];
    });
    return new Interpolant(x.t, values, cubics);
  }

  /** The step in which a time lies, the later one at a sample. */
  step(time: number): number {
    let low = 0;
    let high = this.t.length;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (time < this.t[middle]!) high = middle;
      else low = middle + 1;
    }
    return Math.min(Math.max(low - 1, 0), this.cubics.length - 1);
  }

  /** How far a time lies in step i, 0..1. */
  share(i: number, time: number): number {
    return (time - this.t[i]!) / (this.t[i + 1]! - this.t[i]!);
  }

  /** The value in step i at a share of it. */
  at(i: number, s: number): number {
    if (s === 1) return this.values[i + 1]!;
    const c = this.cubics[i]!;
    return ((c[3] * s + c[2]) * s + c[1]) * s + c[0];
  }

  /** The value at a time. */
  value(time: number): number {
    const i = this.step(time);
    return this.at(i, this.share(i, time));
  }

  /** Whether there is a value all over a .. b (s). */
  known(a: number, b: number): boolean {
    const [first, last] = this.steps(a, b);
    for (let i = first; i <= last; i++) if (!this.cubics[i]!.every(Number.isFinite)) return false;
    return true;
  }

  /** The first and the last step of which a .. b (s) has a part. */
  steps(a: number, b: number): [number, number] {
    const first = this.step(a);
    let last = first;
    while (last + 1 < this.cubics.length && this.t[last + 1]! < b) last++;
    return [first, last];
  }

  /** Times and values of a, all samples and turning points in between, and b: monotone from one to the next. */
  marks(a: number, b: number): { times: number[]; values: number[] } {
    const times = [a];
    const values = [this.value(a)];
    const [first, last] = this.steps(a, b);
    for (let i = first; i <= last; i++) {
      const t = this.t[i]!;
      const step = this.t[i + 1]! - t;
      if (a < t) {
        times.push(t);
        values.push(this.values[i]!);
      }
      for (const s of turns(this.cubics[i]!)) {
        const time = t + s * step;
        if (times[times.length - 1]! < time && time < b) {
          times.push(time);
          values.push(this.at(i, s));
        }
      }
    }
    times.push(b);
    values.push(this.value(b));
    return { times, values };
  }

  /** Times and values of a, the turning points in between, and b: monotone from one to the next to round-off. */
  turning(a: number, b: number): { times: number[]; values: number[] } {
    const { times, values } = this.marks(a, b);
    const slack = LEVEL * values.reduce((size, value) => Math.max(size, Math.abs(value)), 0);
    const kept = [0];
    let way = 0;
    let top = 0;
    let bottom = 0;
    values.forEach((value, i) => {
      if (value > values[top]!) top = i;
      if (value < values[bottom]!) bottom = i;
      if (way >= 0 && values[top]! - value > slack) {
        if (top > kept[kept.length - 1]!) kept.push(top);
        way = -1;
        bottom = i;
      } else if (way <= 0 && value - values[bottom]! > slack) {
        if (bottom > kept[kept.length - 1]!) kept.push(bottom);
        way = 1;
        top = i;
      }
    });
    kept.push(values.length - 1);
    return { times: kept.map((i) => times[i]!), values: kept.map((i) => values[i]!) };
  }

  /** The largest value in some stretches, or with the sign -1 the smallest, and its time, the first of equals. */
  extreme(stretches: readonly Interval[], sign: number): { value: number; time: number } {
    let best = -Infinity;
    let place = NaN;
    for (const [a, b] of stretches) {
      const { times, values } = this.marks(a, b);
      for (let k = 0; k < times.length; k++) {
        const value = sign * values[k]!;
        if (value > best) {
          best = value;
          place = times[k]!;
        }
      }
    }
    return { value: sign * best, time: place };
  }

  /** Of quadrature over a .. b (s): step, share of it, weight (s). */
  nodes(a: number, b: number): Node[] {
    const found: Node[] = [];
    const [first, last] = this.steps(a, b);
    for (let i = first; i <= last; i++) {
      const step = this.t[i + 1]! - this.t[i]!;
      const low = a > this.t[i]! ? this.share(i, a) : 0;
      const high = b < this.t[i + 1]! ? this.share(i, b) : 1;
      const half = (high - low) / 2;
      for (const [place, weight] of GAUSS) found.push([i, low + half * (1 + place), weight * half * step]);
    }
    return found;
  }

  /** The times between a and b (s) at which the signal passes a level. */
  crossings(level: number, a: number, b: number): number[] {
    const { times, values } = this.marks(a, b);
    const found: number[] = [];
    let sign = 0;
    let last = 0;
    for (let k = 0; k < values.length; k++) {
      const now = Number(values[k]! > level) - Number(values[k]! < level);
      if (now === 0) continue;
      // Passed since the last mark off the level: at the one on it, or in between.
      if (now === -sign) found.push(k > last + 1 ? times[last + 1]! : this.when(times[last]!, times[k]!, level));
      sign = now;
      last = k;
    }
    return found;
  }

  /** The time between a and b (s), where the signal is monotone, at which it has a level; the end nearer to it where it
   * hasn't. */
  when(a: number, b: number, level: number): number {
    const first = this.value(a);
    const last = this.value(b);
    const rising = last > first;
    if (rising ? level <= first : level >= first) return a;
    if (rising ? level >= last : level <= last) return b;
    // The last sample before the level, by bisection.
    let low = this.step(a);
    let high = this.steps(a, b)[1];
    while (low < high) {
      const middle = (low + high + 1) >> 1;
      if (rising ? this.values[middle]! < level : this.values[middle]! > level) low = middle;
      else high = middle - 1;
    }
    const t = this.t[low]!;
    const step = this.t[low + 1]! - t;
    const start = a > t ? this.share(low, a) : 0;
    const end = b < this.t[low + 1]! ? this.share(low, b) : 1;
    return t + this.root(low, start, end, level) * step;
  }

  /** The share of step i at which it has a level: Newton's steps inside a bracket, else bisection. */
  private root(i: number, low: number, high: number, level: number): number {
    const below = this.at(i, low) - level;
    const above = this.at(i, high) - level;
    if (below < 0 === above < 0) return Math.abs(below) <= Math.abs(above) ? low : high;
    const c = this.cubics[i]!;
    let s = low + (high - low) * (below / (below - above));
    for (let k = 0; k < MOST_LOOKS; k++) {
      const off = this.at(i, s) - level;
      if (off === 0) break;
      if (off < 0 === below < 0) low = s;
      else high = s;
      const slope = (3 * c[3] * s + 2 * c[2]) * s + c[1];
      let next = slope !== 0 ? s - off / slope : low;
      if (!(low < next && next < high)) next = (low + high) / 2;
      if (Math.abs(next - s) <= 1e-16) break;
      s = next;
    }
    return s;
  }
}

/** The slopes at both ends of a step over which a signal changes, from its rates times the step. */
function ends(change: number, first: number, last: number, span: number): readonly [number, number] {
  const begins = Math.abs(first - change) <= span;
  const closes = Math.abs(last - change) <= span;
  if (begins && closes) return [first, last];
  if (begins) return [first, 2 * change - first];
  if (closes) return [2 * change - last, last];
  return [change, change];
}

/** The shares of a step at which its cubic turns, ascending. */
function turns(c: Cubic): number[] {
  const a = 3 * c[3];
  const b = c[2];
  const inside = b * b - a * c[1];
  if (!(inside > 0)) return [];
  const q = b >= 0 ? -(b + Math.sqrt(inside)) : Math.sqrt(inside) - b;
  const found: number[] = [];
  if (a !== 0) found.push(q / a);
  if (q !== 0) found.push(c[1] / q);
  return found.filter((s) => 0 < s && s < 1).sort((x, y) => x - y);
}

/** How many turns an angle that is known without whole turns has made since the first sample, by its rates; NaN after a
 * gap or a step of more than a turn, as nobody knows what it did there. */
export function wholeTurns(t: ArrayLike<number>, row: SampledRow): number[] {
  const { values, rates } = row;
  const found: number[] = [];
  let made = 0;
  let begun = false;
  for (let i = 0; i < t.length; i++) {
    const known = Number.isFinite(values[i]!);
    if (begun && known) {
      const foretold = ((t[i]! - t[i - 1]!) * (rates[i - 1]! + rates[i]!)) / 2;
      const turned = Number.isFinite(foretold) ? foretold : 0;
      const change = values[i]! - values[i - 1]! - turned;
      made -= Math.abs(turned) <= TURN ? Math.floor(change / TURN + 0.5) : NaN;
    } else if (begun) {
      made = NaN;
    }
    begun = begun || known;
    found.push(known ? made : NaN);
  }
  return found;
}

/** Such an angle (rad) without jumps, from its first value. */
export function continuous(
  t: ArrayLike<number>,
  row: { values: ArrayLike<number>; rates: ArrayLike<number> },
): number[] {
  return wholeTurns(t, row).map((k, i) => row.values[i]! + TURN * k);
}

/** The integral over some stretches (s) of a value at a step and a share of it, on the steps of a signal. */
export function integral(
  stretches: readonly Interval[],
  signal: Interpolant,
  value: (i: number, s: number) => number,
): number {
  let total = 0;
  for (const [a, b] of stretches) for (const [i, s, weight] of signal.nodes(a, b)) total += weight * value(i, s);
  return total;
}

/** The levels that are whole turns from an edge and lie around least .. most; none of too many. */
export function turnedLevels(edge: number, least: number, most: number): number[] {
  const first = Math.floor((least - edge) / TURN);
  const last = Math.floor((most - edge) / TURN) + 1;
  const found: number[] = [];
  for (let k = first; k <= last && last - first < MOST_TURNS; k++) found.push(edge + TURN * k);
  return found;
}

/** The stretches of time (s) in which a window's signal lies in low .. high, with `turning` also any whole turns from
 * there; without a signal, the time itself. Undefined where the signal isn't known all along. */
export function stretches(
  t: ArrayLike<number>,
  window: Interpolant | null,
  low: number,
  high: number,
  turning: boolean,
): Interval[] | undefined {
  const start = t[0]!;
  const stop = t[t.length - 1]!;
  if (!(Number.isFinite(low) && Number.isFinite(high))) return undefined;
  if (window === null) {
    const from = Math.max(low, start);
    const to = Math.min(high, stop);
    return from < to ? [[from, to]] : [];
  }
  if (!window.known(start, stop)) return undefined;
  const { values } = window.marks(start, stop);
  const least = values.reduce((a, b) => Math.min(a, b));
  const most = values.reduce((a, b) => Math.max(a, b));
  const marked = [start, stop];
  for (const edge of [low, high]) {
    const levels = turning ? turnedLevels(edge, least, most) : [edge];
    if (levels.length === 0) return undefined;
    for (const level of levels) marked.push(...window.crossings(level, start, stop));
  }
  const times = [...new Set(marked)].sort((x, y) => x - y);
  const found: Interval[] = [];
  for (let k = 0; k + 1 < times.length; k++) {
    const a = times[k]!;
    const b = times[k + 1]!;
    // The middle of each piece decides for the whole of it.
    let over = window.value((a + b) / 2) - low;
    if (turning) over -= TURN * Math.floor(over / TURN);
    if (!(0 <= over && over <= high - low)) continue;
    const before = found[found.length - 1];
    if (before !== undefined && before[1] === a) found[found.length - 1] = [before[0], b];
    else found.push([a, b]);
  }
  return found;
}

/** A figure in the range of whole turns that a measure states. */
export function wrapped(value: number, low: number, high: number): number {
  const turn = high - low;
  return value - turn * Math.floor((value - low) / turn);
}
