// Where a dyad can't close in a motion, and by how much: the page says of it what the command line says.

import type { Mechanism, Motion } from "./mechanism.ts";

const BISECTIONS = 45;
/** Each step of a golden section leaves so much of the stretch. */
const GOLDEN = (Math.sqrt(5) - 1) / 2;

/** When it begins and ends, and when the dyad misses most (s); there the distance (m) that it must span, with the least
 * and the most that it can, -1 without a limit. */
export interface Gap {
  readonly ends: readonly [number, number];
  readonly worst: number;
  readonly distance: number;
  readonly least: number;
  readonly most: number;
}

/** The gap of a dyad in the last motion of a mechanism in which a pose lies. */
export function gapOf(mechanism: Mechanism, group: number, { reaches, times }: Motion, pose: number): Gap {
  const { data, poses } = mechanism;
  const reach = reaches[group]!;
  let [first, last, deepest] = [pose, pose, pose];
  while (reach[first - 1]! < 0) first--;
  while (reach[last + 1]! < 0) last++;
  for (let k = first; k <= last; k++) if (reach[k]! < reach[deepest]!) deepest = k;

  // Between poses only where no group has to be followed to them.
  const between = data.higher.length === 0;
  const x = between ? new Float64Array(data.inputs) : poses[deepest]!;
  const signals = new Float64Array(mechanism.size);
  const reachAt = (time: number): number => {
    mechanism.drive(time, x);
    mechanism.only("signals").pose(x, signals);
    return signals[data.outputs + group]!;
  };
  const edge = (k: number, beside: number): number => {
    let [bad, good] = [times[k]!, times[beside]!];
    if (good === undefined) return bad;
    if (!between) return bad + ((good - bad) * reach[k]!) / (reach[k]! - reach[beside]!);
    for (let i = 0; i < BISECTIONS; i++) {
      const middle = (bad + good) / 2;
      if (reachAt(middle) < 0) bad = middle;
      else good = middle;
    }
    return good;
  };
  const ends = [edge(first, first - 1), edge(last, last + 1)] as const;
  let worst = times[deepest]!;
  if (between) {
    let [low, high] = [times[Math.max(deepest - 1, first)]!, times[Math.min(deepest + 1, last)]!];
    for (let i = 0; i < BISECTIONS; i++) {
      const [left, right] = [high - GOLDEN * (high - low), low + GOLDEN * (high - low)];
      if (reachAt(left) < reachAt(right)) high = right;
      else low = left;
    }
    worst = (low + high) / 2;
    mechanism.drive(worst, x);
  }
  const rows = 4 * data.links.length;
  const out = new Float64Array(rows + 3 * reaches.length);
  mechanism.only("nearest").pose(x, out);
  const [distance, least, most] = out.subarray(rows + 3 * group);
  return { ends, worst, distance: distance!, least: least!, most: most! };
}
