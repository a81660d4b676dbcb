// Charts of studies as a page brings them (presentation/chart_data.py), in the words of the language.

import type { Values } from "../scene/data.ts";
import type { Curve, Curves, Horizontal } from "./curves.ts";
import { fieldOf } from "./field_data.ts";
import { placed } from "./letters.ts";
import { extent } from "../scene/numbers.ts";
import { monotonePieces } from "./monotone.ts";
import type { Look } from "./outline.ts";
import type { Level } from "./signals.ts";
import type { Axis, Layer, Line, Plane, Scale, Study } from "./study.ts";
import type {
  Box,
  RawAxis,
  RawCharts,
  RawGraph,
  RawLayer,
  RawLimit,
  RawPlane,
  RawRow,
  RawScale,
  Steps,
} from "./study_raw.ts";

/** The chart of a key; its `words` are its title, then its texts by number. */
export function studyOf({ charts, paths }: RawCharts, key: string, words: readonly string[]): Study {
  const [title = "", ...texts] = words;
  const raw = charts[key];
  if (!raw) throw new Error(`no chart ${key}`);
  const read = new Reader(texts, paths);
  return "rows" in raw ? { curves: read.curves(raw, title) } : { plane: read.plane(raw, title) };
}

/** The values of an axis. */
export const values = (steps: Steps): Values =>
  "from" in steps
    ? Array.from({ length: steps.count }, (_, k) => steps.from + ((steps.to - steps.from) * k) / (steps.count - 1))
    : steps;

const colour = (of: number | string): string => (typeof of === "number" ? `c${of % 8}` : of);
const withUnit = (name: string, unit: string): string => (unit ? `${name}, ${unit}` : name);

/** An axis of ascending values, seen from end to end. */
export const ascending = ({ name, unit, label }: Axis, at: Values, ends: readonly [number, number]): Horizontal => ({
  name,
  unit,
  label,
  values: at,
  ghost: null,
  ascends: true,
  pieces: monotonePieces(at),
  ends,
});

class Reader {
  private readonly texts: readonly string[];
  private readonly paths: readonly string[];

  constructor(texts: readonly string[], paths: readonly string[]) {
    this.texts = texts;
    this.paths = paths;
  }

  curves({ x, at, y, rows, limits = [], names }: RawGraph, title: string): Curves {
    const [axis, unit, places] = [this.axis(x), y.unit, values(at)];
    const curves = rows.map((row): Curve => {
      const name = this.text(row.name);
      return { name, signals: [name], unit, right: false, ghost: null, ...this.row(row, places.length) };
    });
    const uprights = this.levels(limits, true);
    const edges = curves.flatMap(({ look }) => look?.edges?.flat() ?? []);
    let [low, high] = extent([...Array.from(places), ...edges]) ?? [0, 1];
    const span = high - low;
    for (const { value } of uprights) {
      if (value < low - span || value > high + span) continue;
      [low, high] = [Math.min(low, value), Math.max(high, value)];
    }
    const margin = uprights.length ? 0.02 * (high - low) : 0;
    const ends = names ? ([0, names.length] as const) : ([low - margin, high + margin || low + 1] as const);
    return {
      title,
      units: [unit],
      x: ascending(axis, places, ends),
      curves,
      vectors: [],
      levels: this.levels(limits, false).map((level) => ({ ...level, right: false })),
      marks: [],
      uprights,
      ...(names ? { names: names.map((each) => this.text(each)) } : {}),
    };
  }

  plane({ x, y, fine, layers, equal = false, limits = [], box }: RawPlane, title: string): Plane {
    const made = layers.map((layer) => this.layer(layer, fine));
    const levels = this.levels(limits, false);
    const seen = box ?? around(made, levels);
    return { title, x: this.axis(x), y: this.axis(y), layers: made, equal, limits: levels, box: seen };
  }

  private row(row: RawRow, count: number): Pick<Curve, "values" | "look"> {
    const { look = "line", dash = 0, low, of } = row;
    const sparse = of && Array.from({ length: count }, (): number | null => null);
    of?.forEach((k, i) => (sparse![k] = row.values[i] ?? null));
    const edges = row.edges && Array.from(values(row.edges), Number);
    const pairs = row.pairs && Array.from(values(row.pairs), Number);
    const bars = edges
      ? edges.slice(1).map((to, k) => [edges[k]!, to] as const)
      : pairs && Array.from({ length: count }, (_, k) => [pairs[2 * k]!, pairs[2 * k + 1]!] as const);
    const drawn: Look = {
      kind: look,
      colour: colour(row.colour),
      dash,
      ...(low ? { low } : {}),
      ...(bars ? { edges: bars } : {}),
    };
    return { values: sparse ?? row.values, look: drawn };
  }

  private layer(raw: RawLayer, fine: number): Layer {
    const lines = (numbers: readonly number[]): Line[] => numbers.map((i) => placed(this.paths[i]!, fine));
    if (raw.kind === "field") {
      const axis = this.axis(raw.axis);
      const field = fieldOf(raw, values);
      const { limits = [], paths = [], family = false } = raw;
      const levels = this.levels(limits, false);
      return { kind: "field", name: axis.name, axis, field, limits: levels, lines: lines(paths), family };
    }
    const name = this.text(raw.name);
    if (raw.kind === "coloured") {
      const groups = raw.groups.map(({ value, paths }) => ({ value, lines: lines(paths) }));
      return { kind: "coloured", name, scale: this.scale(raw.scale), groups };
    }
    if (raw.kind === "spots") {
      const { x, y, values = null, scale } = raw;
      const of = scale ? this.scale(scale) : null;
      return { kind: "spots", name, colour: colour(raw.colour), cross: raw.cross, x, y, values, scale: of };
    }
    return { ...raw, name, colour: colour(raw.colour), lines: lines(raw.paths) };
  }

  private scale({ axis, ...scale }: RawScale): Scale {
    return { axis: this.axis(axis), ...scale };
  }

  private levels(limits: readonly RawLimit[], upright: boolean): Level[] {
    const some = limits.filter((limit) => Boolean(limit.upright) === upright);
    return some.map(({ text, value }) => ({ text: this.text(text), value }));
  }

  private axis({ name, unit }: RawAxis): Axis {
    const text = this.text(name);
    return { name: text, unit, label: withUnit(text, unit) };
  }

  private text(number: number): string {
    return this.texts[number] ?? "";
  }
}

/** The box around layers, and limits that aren't far from it, with some room. */
function around(layers: readonly Layer[], levels: readonly Level[]): Box {
  const [xs, ys]: [number[], number[]] = [[], []];
  let room = 0;
  const add = (x: Values, y: Values): void => {
    xs.push(...(extent(x) ?? []));
    ys.push(...(extent(y) ?? []));
  };
  for (const layer of layers) {
    if (layer.kind === "field") add(layer.field.x, layer.field.y);
    else if (layer.kind === "spots") {
      add(layer.x, layer.y);
      if (!layer.cross) room = 0.04;
    } else {
      const lines = layer.kind === "coloured" ? layer.groups.flatMap((group) => group.lines) : layer.lines;
      for (const line of lines) add(line.filter((_, k) => k % 2 === 0), line.filter((_, k) => k % 2 === 1));
    }
  }
  const [x0, x1] = room1(xs, room);
  let [y0, y1] = room1(ys, room);
  const span = y1 - y0;
  for (const { value } of levels) {
    if (value < y0 - span || value > y1 + span) continue;
    [y0, y1] = [Math.min(y0, value - 0.04 * span), Math.max(y1, value + 0.04 * span)];
  }
  return [x0, y0, x1, y1];
}

function room1(some: readonly number[], room: number): [number, number] {
  const [low, high] = extent(some) ?? [0, 1];
  const more = (high > low ? room * (high - low) : 0) || (high > low ? 0 : Math.max(Math.abs(high), 1) * 1e-6);
  return [low - more, high + more];
}
