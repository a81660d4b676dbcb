// Functions given by points: value, derivative and integral of piecewise polynomials.

import type { Table } from "./data.ts";

/** The argument brought into the table by whole periods; NaN outside an open one. */
function within(table: Table, x: number): number {
  const [first, last] = table.ends;
  if (table.period !== null) {
    const past = (x - first) % table.period;
    return first + (past < 0 ? past + table.period : past);
  }
  const slack = 1e-12 * (last - first);
  return x >= first - slack && x <= last + slack ? Math.min(Math.max(x, first), last) : NaN;
}

/** The number of the piece that holds an argument. */
function pieceAt(table: Table, x: number): number {
  let [low, high] = [0, table.powers.length - 1];
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if (table.knots[middle]! <= x) low = middle;
    else high = middle - 1;
  }
  return low;
}

/** A polynomial's integral from 0 to z. */
const integralOf = (powers: number[], z: number): number =>
  powers.reduceRight((sum, power, i) => sum * z + power / (i + 1), 0) * z;

/** The value of a table, or of its integral from the first point on, and its derivative: `[value, slope]`. */
export function answer(table: Table, x: number, integral: boolean): [number, number] {
  const at = within(table, x);
  if (Number.isNaN(at)) return [NaN, NaN];
  const k = pieceAt(table, at);
  const powers = table.powers[k]!;
  const z = at - table.knots[k]!;
  let [value, slope] = [0, 0];
  for (let i = powers.length - 1; i >= 0; i--) {
    slope = slope * z + value;
    value = value * z + powers[i]!;
  }
  return integral ? [integralTo(table, x, k, z), value] : [value, slope];
}

function integralTo(table: Table, x: number, k: number, z: number): number {
  const whole = wholes(table);
  const periods = table.period === null ? 0 : Math.floor((x - table.ends[0]) / table.period);
  return whole[k]! + integralOf(table.powers[k]!, z) + (periods ? periods * whole.at(-1)! : 0);
}

const kept = new WeakMap<Table, number[]>();

/** The integrals up to each knot. */
function wholes(table: Table): number[] {
  let found = kept.get(table);
  if (!found) {
    found = [0];
    table.powers.forEach((powers, k) => {
      found!.push(found![k]! + integralOf(powers, table.knots[k + 1]! - table.knots[k]!));
    });
    kept.set(table, found);
  }
  return found;
}
