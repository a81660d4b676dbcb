// Efficiency, and shares of the energy given: quotients of works, whose integrals of the cubics are exact. As
// src/linkwright/reductions/efficiency.py.

import type { Figures, OnSamples } from "./measure.ts";
import { rowOf } from "./measure.ts";
import { integral } from "./samples.ts";

/** Useful work below this share of the work that the useful loads exchange is none. */
const NOTHING = 1e-9;

interface Works {
  own: number;
  useful: number;
  given: number;
}

/** The works (J) of the elements, of the useful loads, and all energy given; undefined without useful work, or where
 * others give energy. */
function works(samples: OnSamples, key: string): Works | undefined {
  const work = (of: string): number => {
    const row = rowOf(samples, of);
    return integral(samples.stretches, row, (i, s) => row.at(i, s));
  };
  const row = rowOf(samples, key);
  const found = { own: work(""), useful: work(key), given: work("given") };
  const size = integral(samples.stretches, row, (i, s) => Math.abs(row.at(i, s)));
  const { useful, given } = found;
  const known = Math.abs(useful) > NOTHING * size;
  const lost = given - useful >= -NOTHING * Math.max(Math.abs(given), Math.abs(useful));
  return known && lost ? found : undefined;
}

export function efficiency(samples: OnSamples): Figures | undefined {
  const found = works(samples, "");
  if (found === undefined) return undefined;
  const { useful, given } = found;
  return { "": { value: useful > 0 ? useful / given : given / useful, time: null } };
}

export function share(samples: OnSamples): Figures | undefined {
  const found = works(samples, "useful");
  if (found === undefined) return undefined;
  const { own, useful, given } = found;
  return { "": { value: useful > 0 ? own / given : -own / useful, time: null } };
}
