// The value of a signal at one instant: at an extreme of another one, where one is zero, at start or end of the window.
// As src/linkwright/reductions/value.py.

import type { Figures, OnSamples } from "./measure.ts";
import { rowOf } from "./measure.ts";
import { turnedLevels } from "./samples.ts";

/** An end of the window is a zero where the expression is no larger than this share of its size. */
const ON = 1e-12;
const TURN = 2 * Math.PI;

export function value(samples: OnSamples): Figures | undefined {
  const time = instant(samples);
  return time === undefined ? undefined : { "": { value: rowOf(samples).value(time), time } };
}

function instant(samples: OnSamples): number | undefined {
  const stretches = samples.stretches;
  switch (samples.words["at"]) {
    case "zero":
      return zeros(samples).reduce<number | undefined>((a, b) => (a === undefined || b < a ? b : a), undefined);
    case "max":
      return rowOf(samples, "where").extreme(stretches, 1).time;
    case "min":
      return rowOf(samples, "where").extreme(stretches, -1).time;
    case "start":
      return stretches[0]![0];
    default:
      return stretches[stretches.length - 1]![1];
  }
}

/** The times (s) at which the other expression is zero, of an angle modulo whole turns. */
function zeros(samples: OnSamples): number[] {
  const other = rowOf(samples, "where");
  const turning = samples.angles.has("where");
  const found: number[] = [];
  for (const [a, b] of samples.stretches) {
    const { values } = other.marks(a, b);
    const least = values.reduce((x, y) => Math.min(x, y));
    const most = values.reduce((x, y) => Math.max(x, y));
    for (const [time, end] of [[a, values[0]!], [b, values[values.length - 1]!]] as const) {
      const on = turning
        ? Math.abs(end - TURN * Math.floor(end / TURN + 0.5)) <= 2 * ON
        : Math.abs(end) <= ON * Math.max(-least, most);
      if (on) found.push(time);
    }
    const levels = turning ? turnedLevels(0, least, most) : [0];
    for (const level of levels) found.push(...other.crossings(level, a, b));
  }
  return found;
}
