// What is at a place of a plane: the value of a map, the nearest dot, the value of the nearest line.

import { known } from "../scene/data.ts";
import { figure } from "./figure.ts";
import type { Frame } from "./plane_frame.ts";
import type { Axis, ColouredLayer, Line, Place, Plane, SpotsLayer } from "./study.ts";

/** Pixels within which something counts as pointed at. */
const NEAR = 24;

export interface Reading {
  readonly x: number;
  readonly y: number;
  /** Names and texts of values. */
  readonly values: readonly { readonly name: string; readonly text: string }[];
}

/** What is read at a place; where a dot is near, at the dot. */
export function readingAt(plane: Plane, frame: Frame, at: Place, shown: (layer: number) => boolean): Reading {
  let place = at;
  const values: { name: string; text: string }[] = [];
  plane.layers.forEach((layer, i) => {
    if (!shown(i)) return;
    if (layer.kind === "spots" && !layer.cross) {
      const k = nearestSpot(layer, frame, at);
      if (k < 0) return;
      place = [known(layer.x, k)!, known(layer.y, k)!];
      if (layer.scale && layer.values) values.push(named(layer.scale.axis, known(layer.values, k)));
    }
    if (layer.kind === "field") {
      const value = layer.lines.length && !inside(layer.lines, at) ? null : layer.field.at(...at);
      const { ends } = layer.field;
      const sign = value === null || !ends ? "" : value >= ends[1] ? "≥ " : value <= ends[0] ? "≤ " : "";
      values.push(named(layer.axis, value, sign, layer.field.ratios || ends ? 3 : 5));
    }
    if (layer.kind === "coloured") {
      const value = nearestLine(layer, frame, at);
      values.push(named(layer.scale.axis, value));
    }
  });
  return { x: place[0], y: place[1], values };
}

function named({ name, unit }: Axis, value: number | null, sign = "", digits = 5): { name: string; text: string } {
  const rounded = value === null ? null : Number(value.toPrecision(digits));
  const number = digits < 5 && rounded !== null ? String(rounded).replace("-", "−") : figure(rounded);
  return { name, text: value === null ? "–" : `${sign}${number}${unit ? ` ${unit}` : ""}` };
}

function nearestSpot({ x, y }: SpotsLayer, { across, up }: Frame, at: Place): number {
  let [best, far] = [-1, NEAR];
  for (let k = 0; k < y.length; k++) {
    const [a, b] = [known(x, k), known(y, k)];
    if (a === null || b === null) continue;
    const away = Math.hypot(across(a) - across(at[0]), up(b) - up(at[1]));
    if (away < far) [best, far] = [k, away];
  }
  return best;
}

function nearestLine({ groups }: ColouredLayer, { across, up }: Frame, at: Place): number | null {
  const [px, py] = [across(at[0]), up(at[1])];
  let [best, far]: [number | null, number] = [null, NEAR / 2];
  for (const { value, lines } of groups) {
    for (const line of lines) {
      let [ax, ay] = [NaN, NaN];
      for (let k = 0; k < line.length; k += 2) {
        const [bx, by] = [across(line[k]!), up(line[k + 1]!)];
        const length = (bx - ax) ** 2 + (by - ay) ** 2;
        const f = length > 0 ? Math.min(Math.max(((px - ax) * (bx - ax) + (py - ay) * (by - ay)) / length, 0), 1) : 0;
        const away = Math.hypot(px - ax - f * (bx - ax), py - ay - f * (by - ay));
        if (away < far) [best, far] = [value, away];
        [ax, ay] = [bx, by];
      }
    }
  }
  return best;
}

/** Whether a place is within rings, by how often a ray to the right crosses them. */
export function inside(rings: readonly Line[], [x, y]: Place): boolean {
  let odd = false;
  for (const ring of rings) {
    for (let k = 0, j = ring.length - 2; k < ring.length; j = k, k += 2) {
      const [ay, by] = [ring[k + 1]!, ring[j + 1]!];
      if (ay > y !== by > y && x < ((ring[j]! - ring[k]!) * (y - ay)) / (by - ay) + ring[k]!) odd = !odd;
    }
  }
  return odd;
}
