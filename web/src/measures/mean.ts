// Mean, root mean square, and the length of a path: the integral of the cubics, or of their squares, is exact. As
// src/linkwright/reductions/mean.py.

import type { Figures, OnSamples } from "./measure.ts";
import { rowOf } from "./measure.ts";
import { integral } from "./samples.ts";

function length(samples: OnSamples): number {
  let total = 0;
  for (const [a, b] of samples.stretches) total += b - a;
  return total;
}

export function mean(samples: OnSamples): Figures {
  const signal = rowOf(samples);
  const total = integral(samples.stretches, signal, (i, s) => signal.at(i, s));
  return { "": { value: total / length(samples), time: null } };
}

export function rms(samples: OnSamples): Figures {
  const signal = rowOf(samples);
  const total = integral(samples.stretches, signal, (i, s) => {
    const here = signal.at(i, s);
    return here * here;
  });
  return { "": { value: Math.sqrt(total / length(samples)), time: null } };
}

/** The components of the velocity are smooth where the speed isn't: it is made of their cubics. */
export function path(samples: OnSamples): Figures {
  const along = rowOf(samples, "vx");
  const across = rowOf(samples, "vy");
  const total = integral(samples.stretches, along, (i, s) => {
    const vx = along.at(i, s);
    const vy = across.at(i, s);
    return Math.sqrt(vx * vx + vy * vy);
  });
  return { "": { value: total, time: null } };
}
