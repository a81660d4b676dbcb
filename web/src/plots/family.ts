// A field as a family of curves: over the horizontal axis, one for each value of the other.

import type { Curves } from "./curves.ts";
import { tick } from "./figure.ts";
import type { FieldLayer, Plane } from "./study.ts";
import { ascending } from "./study_data.ts";

/** The field that may be shown so. */
export const familyOf = ({ layers }: Plane): (FieldLayer) | null =>
  layers.find((each): each is FieldLayer => each.kind === "field" && each.family) ?? null;

export function familyCurves(plane: Plane, { axis, field, limits }: FieldLayer): Curves {
  const { x, y } = field;
  const curves = y.map((value, row) => ({
    name: `${plane.y.name} = ${tick(Number(value.toPrecision(6)))} ${plane.y.unit}`.trim(),
    signals: [],
    unit: axis.unit,
    right: false,
    values: x.map((_, column) => field.value(column, row)),
    ghost: null,
  }));
  return {
    title: plane.title,
    units: [axis.unit],
    vertical: axis.label,
    x: ascending(plane.x, x, [x[0]!, x.at(-1)!]),
    curves,
    vectors: [],
    levels: limits.map((level) => ({ ...level, right: false })),
    marks: [],
  };
}
