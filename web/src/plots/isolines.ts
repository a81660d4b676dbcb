// Where a field is zero: marching squares (W. E. Lorensen and H. E. Cline, Computer Graphics 21 (1987) 163-169, in the
// plane), the pieces joined to lines. A cell with a corner that has no value has no line.

export interface Rows {
  readonly x: readonly number[];
  readonly y: readonly number[];
  /** Row by row, NaN where there is none. */
  readonly rows: Float64Array;
}

/** Lines as places x, y, x, y and so on. */
export function isolines({ x, y, rows }: Rows): Float64Array[] {
  const wide = x.length;
  const ends = new Map<number, [number, number]>(); // by the side of a cell: its place
  const next = new Map<number, number[]>(); // by the side of a cell: the sides to which pieces lead
  /** The place on a side, which is numbered by its first corner and its direction: 0 to the right, 1 up. */
  const side = (i: number, j: number, up: number): number => {
    const key = 2 * (j * wide + i) + up;
    if (!ends.has(key)) {
      const [a, b] = [rows[j * wide + i]!, rows[(j + up) * wide + i + 1 - up]!];
      const f = a / (a - b);
      ends.set(key, up ? [x[i]!, y[j]! + f * (y[j + 1]! - y[j]!)] : [x[i]! + f * (x[i + 1]! - x[i]!), y[j]!]);
    }
    return key;
  };
  const join = (from: number, to: number): void => {
    for (const [a, b] of [[from, to], [to, from]] as const) next.set(a, [...(next.get(a) ?? []), b]);
  };
  for (let j = 0; j + 1 < y.length; j++) {
    for (let i = 0; i + 1 < wide; i++) {
      const k = j * wide + i;
      const [a, b, c, d] = [rows[k]!, rows[k + 1]!, rows[k + wide + 1]!, rows[k + wide]!]; // around the cell
      const sum = a + b + c + d;
      if (Number.isNaN(sum)) continue;
      const signs = Number(a >= 0) | (Number(b >= 0) << 1) | (Number(c >= 0) << 2) | (Number(d >= 0) << 3);
      if (signs === 0 || signs === 15) continue;
      const crossed = [
        (signs & 1) !== ((signs >> 1) & 1) ? side(i, j, 0) : -1,
        ((signs >> 1) & 1) !== ((signs >> 2) & 1) ? side(i + 1, j, 1) : -1,
        ((signs >> 2) & 1) !== ((signs >> 3) & 1) ? side(i, j + 1, 0) : -1,
        ((signs >> 3) & 1) !== (signs & 1) ? side(i, j, 1) : -1,
      ];
      const some = crossed.filter((key) => key >= 0);
      if (some.length === 2) join(some[0]!, some[1]!);
      else {
        // A saddle: the middle belongs to the corners of its sign.
        const turned = sum >= 0 === a >= 0;
        join(crossed[0]!, crossed[turned ? 1 : 3]!);
        join(crossed[2]!, crossed[turned ? 3 : 1]!);
      }
    }
  }
  return chains(ends, next);
}

function chains(ends: ReadonlyMap<number, readonly [number, number]>, next: Map<number, number[]>): Float64Array[] {
  const found: Float64Array[] = [];
  const walk = (start: number): void => {
    const line = [...ends.get(start)!];
    let here = start;
    for (let to = next.get(here)?.pop(); to !== undefined; to = next.get(here)?.pop()) {
      const back = next.get(to)!;
      back.splice(back.indexOf(here), 1);
      line.push(...ends.get(to)!);
      here = to;
    }
    if (line.length > 2) found.push(Float64Array.from(line));
  };
  for (const [key, to] of next) if (to.length === 1) walk(key); // open lines from their ends
  for (const [key, to] of next) if (to.length) walk(key);
  return found;
}
