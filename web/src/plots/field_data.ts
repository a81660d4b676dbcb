// The field of a chart as a page brings it: plain values, or for maps of many places two letters each.

import type { Values } from "../scene/data.ts";
import { Field } from "./field.ts";
import { unpacked } from "./letters.ts";

export interface RawField<Steps> {
  readonly x: Steps;
  readonly y: Steps;
  readonly values?: Values;
  readonly packed?: string;
  readonly low?: number;
  readonly high?: number;
  readonly ratios?: boolean;
  readonly levels: readonly number[];
  readonly colours: readonly string[];
  readonly paths?: readonly number[];
  readonly family?: boolean;
}

export function fieldOf<Steps>(raw: RawField<Steps>, values: (steps: Steps) => Values): Field {
  const [x, y] = [raw.x, raw.y].map((axis) => Array.from(values(axis), Number)) as [number[], number[]];
  const { packed, low = 0, high = 1, ratios = false, levels, colours } = raw;
  if (packed === undefined) return new Field(x, y, raw.values ?? [], { levels, colours, ratios: false, ends: null });
  const ends = ratios ? null : ([low, high] as const);
  return new Field(x, y, unpacked(packed, low, high, ratios), { levels, colours, ratios, ends });
}
