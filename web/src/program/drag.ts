// A mechanism at one time, whose parameters change so that a point follows the pointer: damped least squares on exact
// derivatives, measured by what each parameter is large against, within bounds, and only as far as all groups close.

import type { Mechanism } from "./mechanism.ts";

/** What a drag may change: of each free parameter its size (what a change is measured by), its bounds, whether it is
 * held. All in the order of the free parameters, in SI. */
export interface Freedom {
  sizes: readonly number[];
  low: readonly number[];
  high: readonly number[];
  held: readonly boolean[];
  /** From when to when (s) the time may move where no number can. */
  times: readonly [number, number];
}

/** How a drag ended: `reached`, or as near as it gets because of the `limits` of parameters (their numbers), or of the
 * mechanism, which is about to open. `off` (m) is how far the point is from where it was to be. */
export interface Dragged {
  free: Float64Array;
  time: number;
  off: number;
  reached: boolean;
  limits: number[];
}

const CLOSEST = 1e-6; // the least reach of a dyad: beyond it the mechanism is about to open
const [STEPS, HALVINGS] = [60, 12];
const LONGEST = 0.1; // the most that a step aims to move the point, over the mechanism's size
const LITTLE = 1e-2; // what the time weighs beside a number
const NEAR = 1e-8; // that near to its target, over the mechanism's size, a point has reached it

/** Where a point lies, and how it moves with each free parameter, last with the time. */
export interface Placed {
  x: number;
  y: number;
  slopes: Float64Array[];
}

/** Brings a point to a place by the parameters; by the time too where they can't alone. */
export function drag(
  mechanism: Mechanism,
  start: ArrayLike<number>,
  time: number,
  point: number,
  target: readonly [number, number],
  freedom: Freedom,
): Dragged {
  const found = approach(mechanism, start, time, point, target, { ...freedom, times: [time, time] });
  const [first, last] = freedom.times;
  if (found.reached || !Number.isFinite(found.off) || first === last) return found;
  return approach(mechanism, found.free, time, point, target, freedom);
}

function approach(
  mechanism: Mechanism,
  start: ArrayLike<number>,
  time: number,
  point: number,
  target: readonly [number, number],
  freedom: Freedom,
): Dragged {
  const { size } = mechanism.data;
  const pose = mechanism.posed(start, time);
  let free = Float64Array.from(start);
  let here = pose?.place(point);
  if (!pose || !here) return { free, time, off: NaN, reached: false, limits: [] };
  const count = free.length;
  let off = Math.hypot(target[0] - here.x, target[1] - here.y);
  let limits: number[] = [];
  for (let k = 0; k < STEPS && off > NEAR * size; k++) {
    const aim = Math.min(1, (LONGEST * size) / off);
    const step = stepTo(here, free, [(target[0] - here.x) * aim, (target[1] - here.y) * aim], freedom, size);
    limits = step.limits;
    let better = false;
    for (let half = 0, share = 1; half < HALVINGS && !better; half++, share /= 2) {
      const next = free.map((value, i) => clamp(value + share * step.change[i]!, freedom.low[i]!, freedom.high[i]!));
      const when = clamp(pose.time + share * step.change[count]!, ...freedom.times);
      const there = pose.move(next, when) ? pose.place(point) : null;
      const left = there ? Math.hypot(target[0] - there.x, target[1] - there.y) : Infinity;
      if (there && left < off * (1 - 1e-4)) {
        [free, here, off, better, time] = [next, there, left, true, when];
      }
    }
    if (!better) break;
  }
  return { free, time, off, reached: off <= NEAR * size, limits };
}

const clamp = (value: number, low: number, high: number): number => Math.min(Math.max(value, low), high);

/** The least change (over the sizes) that moves a point by a vector; parameters at a bound that would go beyond it are
 * held, one after the other. */
function stepTo(
  here: Placed,
  free: Float64Array,
  by: readonly [number, number],
  freedom: Freedom,
  size: number,
): { change: Float64Array; limits: number[] } {
  const held = freedom.held.map((each) => each);
  const limits: number[] = [];
  for (;;) {
    const still = freedom.times[0] === freedom.times[1];
    const change = leastChange(here, by, freedom.sizes, [...held, still], size);
    const beyond = change.findIndex(
      (each, i) =>
        i < free.length &&
        !held[i] && ((each < 0 && free[i]! <= freedom.low[i]!) || (each > 0 && free[i]! >= freedom.high[i]!)),
    );
    if (beyond < 0) return { change, limits };
    held[beyond] = true;
    limits.push(beyond);
  }
}

/** W J' (J W J' + d I)^-1 r with W the squares of the sizes. */
function leastChange(
  here: Placed,
  [rx, ry]: readonly [number, number],
  sizes: readonly number[],
  held: readonly boolean[],
  size: number,
): Float64Array {
  let [a, b, c] = [0, 0, 0];
  const speed = Math.hypot(...here.slopes.at(-1)!);
  /** The time moves where no number can: it weighs little beside them. */
  const ofTime = speed ? ((LITTLE * size) / speed) ** 2 : 0;
  const weightOf = (i: number): number => (i < sizes.length ? sizes[i]! ** 2 : ofTime);
  here.slopes.forEach(([jx, jy], i) => {
    if (held[i]) return;
    const weight = weightOf(i);
    a += weight * jx! * jx!;
    b += weight * jx! * jy!;
    c += weight * jy! * jy!;
  });
  const damped = (1e-6 * size) ** 2 + 1e-11 * (a + c);
  [a, c] = [a + damped, c + damped];
  const determinant = a * c - b * b;
  const [u, v] = [(c * rx - b * ry) / determinant, (a * ry - b * rx) / determinant];
  return Float64Array.from(here.slopes, ([jx, jy], i) => (held[i] ? 0 : weightOf(i) * (jx! * u + jy! * v)));
}

/** Whether a pose's groups are closed, and not about to open. */
export const closed = (reaches: ArrayLike<number>): boolean =>
  Array.prototype.every.call(reaches, (reach: number) => reach >= CLOSEST);
