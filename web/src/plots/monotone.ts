// A curve over values that go up and down, such as a drive's angle: pieces over which they are monotone, and the sample
// of a curve that belongs to a place on the axis.

import { known, type Values } from "../scene/data.ts";

/** First and last sample of a piece. */
export type Piece = readonly [number, number];

/** The pieces over which values never turn; each begins where the one before ends, but at samples without values. */
export function monotonePieces(values: Values): Piece[] {
  const pieces: Piece[] = [];
  let from = -1;
  let way = 0;
  const end = (to: number): void => {
    if (from >= 0) pieces.push([from, to]);
  };
  for (let k = 0; k < values.length; k++) {
    const here = known(values, k);
    const before = k > 0 ? known(values, k - 1) : null;
    if (here === null) {
      end(k - 1);
      [from, way] = [-1, 0];
      continue;
    }
    if (from < 0 || before === null) {
      [from, way] = [k, 0];
      continue;
    }
    const step = Math.sign(here - before);
    if (step * way < 0) {
      end(k - 1);
      from = k - 1;
    }
    if (step) way = step;
  }
  end(values.length - 1);
  return pieces;
}

/** The sample whose value is nearest to a place on the axis; of several pieces that reach there, the one next to a
 * sample of before, so that the mechanism doesn't jump. Sample 0 where there are no values. */
export function sampleAt(values: Values, pieces: readonly Piece[], place: number, before: number): number {
  let best = { k: 0, off: Infinity, far: Infinity };
  for (const [from, to] of pieces) {
    const k = nearestIn(values, from, to, place);
    // Within a piece that reaches the place the miss is that of sampling: it counts as none.
    const [low, high] = [Math.min(values[from]!, values[to]!), Math.max(values[from]!, values[to]!)];
    const off = place >= low && place <= high ? 0 : Math.abs(values[k]! - place);
    const far = Math.abs(k - before);
    if (off < best.off || (off === best.off && far < best.far)) best = { k, off, far };
  }
  return best.k;
}

/** By bisection in a piece, up or down. */
function nearestIn(values: Values, from: number, to: number, place: number): number {
  const up = values[to]! >= values[from]!;
  let [low, high] = [from, to];
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (values[middle]! <= place === up) low = middle;
    else high = middle;
  }
  return Math.abs(values[low]! - place) <= Math.abs(values[high]! - place) ? low : high;
}
