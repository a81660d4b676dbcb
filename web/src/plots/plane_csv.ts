// A plane as a table: the places of a grid or of dots with their values, else the places of its lines.

import { known, type Values } from "../scene/data.ts";
import { cell, head, tableText } from "./csv.ts";
import type { ColouredLayer, FieldLayer, Line, Plane, SpotsLayer } from "./study.ts";

export function planeCsv(plane: Plane): string {
  const grid = plane.layers.find((each): each is FieldLayer => each.kind === "field");
  if (grid) return ofGrid(plane, grid);
  const dots = plane.layers.find((each): each is SpotsLayer => each.kind === "spots" && !each.cross);
  return dots ? ofDots(plane, dots) : ofLines(plane);
}

/** Maps within an outline have the places with a value, others all places. */
function ofGrid(plane: Plane, { axis, field, lines }: FieldLayer): string {
  const [x, y, values]: [number[], number[], (number | null)[]] = [[], [], []];
  field.y.forEach((up, row) => {
    field.x.forEach((across, column) => {
      const value = field.value(column, row);
      if (value === null && lines.length) return;
      x.push(across);
      y.push(up);
      values.push(value);
    });
  });
  return tableText([
    { ...plane.x, values: x },
    { ...plane.y, values: y },
    { ...axis, values },
  ]);
}

function ofDots(plane: Plane, { x, y, values, scale }: SpotsLayer): string {
  const columns: { name: string; unit: string; values: Values }[] = [
    { ...plane.x, values: x },
    { ...plane.y, values: y },
  ];
  if (values && scale) columns.push({ ...scale.axis, values });
  return tableText(columns);
}

/** A row for each place: of which line, which part of it, the value by which it is coloured. */
function ofLines({ x, y, layers }: Plane): string {
  const scale = layers.find((each): each is ColouredLayer => each.kind === "coloured")?.scale;
  const heads = ["curve", "part", head(x.name, x.unit), head(y.name, y.unit)];
  if (scale) heads.push(head(scale.axis.name, scale.axis.unit));
  const rows = [heads.join(",")];
  let part = 0;
  const add = (name: string, lines: readonly Line[], value: number | null): void => {
    for (const line of lines) {
      part++;
      for (let k = 0; k < line.length; k += 2) {
        const places = [line[k]!, line[k + 1]!].map((place) => Number(place.toPrecision(9)));
        rows.push([cell(name), part, ...places, ...(scale ? [value ?? ""] : [])].join(","));
      }
    }
  };
  for (const layer of layers) {
    if (layer.kind === "coloured") for (const { value, lines } of layer.groups) add(layer.name, lines, value);
    else if (layer.kind === "lines" || layer.kind === "region") add(layer.name, layer.lines, null);
    else if (layer.kind === "spots") {
      const places = Array.from(layer.x, (_, k) => Float64Array.of(known(layer.x, k) ?? NaN, known(layer.y, k) ?? NaN));
      add(layer.name, places, null);
    }
  }
  return `${rows.join("\n")}\n`;
}
