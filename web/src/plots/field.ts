// Values on a grid: between the places, in bands of colours, and where they are equal to a level.

import { known, type Values } from "../scene/data.ts";

export interface Bands {
  readonly levels: readonly number[];
  /** One more than the levels. */
  readonly colours: readonly string[];
  /** Whether values are even between places by their ratios. */
  readonly ratios: boolean;
  /** Values at these ends may lie beyond them; null where none does. */
  readonly ends: readonly [number, number] | null;
}

/** Places to a side between which values are looked at for a line. */
const [LEAST, MOST] = [96, 240];

export class Field implements Bands {
  readonly x: readonly number[];
  readonly y: readonly number[];
  readonly levels: readonly number[];
  readonly colours: readonly string[];
  readonly ratios: boolean;
  readonly ends: Bands["ends"];
  /** Row by row: values, or their logarithms. */
  private readonly rows: Float64Array;
  private readonly cuts: readonly number[];

  constructor(x: readonly number[], y: readonly number[], values: Values, bands: Bands) {
    [this.x, this.y] = [x, y];
    this.levels = bands.levels;
    this.colours = bands.colours;
    this.ratios = bands.ratios;
    this.ends = bands.ends;
    this.rows = Float64Array.from({ length: values.length }, (_, k) => this.scaled(known(values, k) ?? NaN));
    this.cuts = this.levels.map((level) => this.scaled(level));
  }

  /** The value of a place of the grid. */
  value(column: number, row: number): number | null {
    const found = this.rows[row * this.x.length + column]!;
    return Number.isNaN(found) ? null : this.plain(found);
  }

  /** The value anywhere; null outside, and where the places around have none. */
  at(x: number, y: number): number | null {
    const found = this.between(locate(this.x, x), locate(this.y, y));
    return Number.isNaN(found) ? null : this.plain(found);
  }

  /** The numbers of the bands over columns and rows of places: -1 for none. */
  bandsOver(xs: readonly number[], ys: readonly number[]): Int8Array {
    const columns = xs.map((x) => locate(this.x, x));
    const found = new Int8Array(xs.length * ys.length);
    let k = 0;
    for (const y of ys) {
      const row = locate(this.y, y);
      for (const column of columns) {
        const value = this.between(column, row);
        let band = Number.isNaN(value) ? -1 : 0;
        while (band >= 0 && band < this.cuts.length && value >= this.cuts[band]!) band++;
        found[k++] = band;
      }
    }
    return found;
  }

  /** The field minus a level, on places close enough for lines. */
  finer(level: number): { readonly x: readonly number[]; readonly y: readonly number[]; readonly rows: Float64Array } {
    const [x, y] = [refined(this.x), refined(this.y)];
    const [columns, cut] = [x.map((each) => locate(this.x, each)), this.scaled(level)];
    const rows = new Float64Array(x.length * y.length);
    let k = 0;
    for (const each of y) {
      const row = locate(this.y, each);
      for (const column of columns) rows[k++] = this.between(column, row) - cut;
    }
    return { x, y, rows };
  }

  private scaled(value: number): number {
    return this.ratios ? Math.log(value) : value;
  }

  private plain(value: number): number {
    return this.ratios ? Math.exp(value) : value;
  }

  /** Bilinear within four places; of three, linear in their triangle. */
  private between(column: Place | null, row: Place | null): number {
    if (!column || !row) return NaN;
    const { k: i, f: u } = column;
    const { k: j, f: v } = row;
    const wide = this.x.length;
    const first = j * wide + i;
    const right = i + 1 < wide ? 1 : 0;
    const above = j + 1 < this.y.length ? wide : 0;
    const [a, b] = [this.rows[first]!, this.rows[first + right]!];
    const [c, d] = [this.rows[first + above]!, this.rows[first + above + right]!];
    // A place on a side of the cell needs that side alone.
    const low = u === 0 ? a : u === 1 ? b : (1 - u) * a + u * b;
    const high = u === 0 ? c : u === 1 ? d : (1 - u) * c + u * d;
    const found = v === 0 ? low : v === 1 ? high : (1 - v) * low + v * high;
    if (!Number.isNaN(found)) return found;
    if (Number.isNaN(d)) return u + v <= 1 ? a + u * (b - a) + v * (c - a) : NaN;
    if (Number.isNaN(a)) return u + v >= 1 ? d + (1 - u) * (c - d) + (1 - v) * (b - d) : NaN;
    if (Number.isNaN(b)) return u <= v ? c + u * (d - c) + (1 - v) * (a - c) : NaN;
    return u >= v ? b + (1 - u) * (a - b) + v * (d - b) : NaN;
  }
}

interface Place {
  readonly k: number;
  readonly f: number;
}

/** Between which places of an axis a value lies, and where. */
function locate(axis: readonly number[], value: number): Place | null {
  const last = axis.length - 1;
  const edge = 1e-9 * (axis[last]! - axis[0]!);
  if (!(value >= axis[0]! - edge && value <= axis[last]! + edge) || last < 1) return null;
  let [low, high] = [0, last];
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (axis[middle]! <= value) low = middle;
    else high = middle;
  }
  const f = (value - axis[low]!) / (axis[high]! - axis[low]!);
  return { k: low, f: Math.min(Math.max(f, 0), 1) };
}

/** The places of an axis and so many between each two. */
function refined(axis: readonly number[]): number[] {
  const cells = axis.length - 1;
  const parts = Math.max(1, Math.min(Math.ceil(LEAST / cells), Math.floor(MOST / cells)));
  const found = [axis[0]!];
  for (let k = 0; k < cells; k++) {
    for (let i = 1; i <= parts; i++) found.push(axis[k]! + ((axis[k + 1]! - axis[k]!) * i) / parts);
  }
  return found;
}
