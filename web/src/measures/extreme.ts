// The largest value, the smallest, both, and what lies between them: samples, turning points of the cubics, or ends of
// the window. As src/linkwright/reductions/extreme.py.

import type { Figures, OnSamples } from "./measure.ts";
import { rowOf } from "./measure.ts";

export function max(samples: OnSamples): Figures {
  return { "": rowOf(samples).extreme(samples.stretches, 1) };
}

export function min(samples: OnSamples): Figures {
  return { "": rowOf(samples).extreme(samples.stretches, -1) };
}

export function extremes(samples: OnSamples): Figures {
  const signal = rowOf(samples);
  return { min: signal.extreme(samples.stretches, -1), max: signal.extreme(samples.stretches, 1) };
}

export function span(samples: OnSamples): Figures {
  const signal = rowOf(samples);
  const high = signal.extreme(samples.stretches, 1).value;
  const low = signal.extreme(samples.stretches, -1).value;
  return { "": { value: high - low, time: null } };
}
