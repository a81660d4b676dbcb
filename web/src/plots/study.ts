// What a chart of a study shows: curves over an axis, or layers of a plane.

import type { Values } from "../scene/data.ts";
import type { Curves } from "./curves.ts";
import type { Field } from "./field.ts";
import type { Level } from "./signals.ts";
import type { Box } from "./study_raw.ts";

/** A place of a plane, or its pixels. */
export type Place = readonly [number, number];

export interface Axis {
  readonly name: string;
  readonly unit: string;
  readonly label: string;
}

/** Places x, y, x, y and so on. */
export type Line = Float64Array;

export interface Scale {
  readonly axis: Axis;
  readonly low: number;
  readonly high: number;
  readonly stops: readonly string[];
}

export type Layer =
  | { readonly kind: "region"; readonly name: string; readonly colour: string; readonly lines: readonly Line[] }
  | {
      readonly kind: "lines";
      readonly name: string;
      readonly colour: string;
      readonly dash: number;
      readonly width: number;
      readonly lines: readonly Line[];
    }
  | {
      readonly kind: "coloured";
      readonly name: string;
      readonly scale: Scale;
      readonly groups: readonly { readonly value: number; readonly lines: readonly Line[] }[];
    }
  | {
      readonly kind: "spots";
      readonly name: string;
      readonly colour: string;
      readonly cross: boolean;
      readonly x: Values;
      readonly y: Values;
      readonly values: Values | null;
      readonly scale: Scale | null;
    }
  | {
      readonly kind: "field";
      readonly name: string;
      readonly axis: Axis;
      readonly field: Field;
      readonly limits: readonly Level[];
      readonly lines: readonly Line[];
      readonly family: boolean;
    };

type Of<K extends Layer["kind"]> = Layer & { readonly kind: K };
export type FieldLayer = Of<"field">;
export type SpotsLayer = Of<"spots">;
export type ColouredLayer = Of<"coloured">;

export interface Plane {
  readonly title: string;
  readonly x: Axis;
  readonly y: Axis;
  readonly layers: readonly Layer[];
  readonly equal: boolean;
  readonly limits: readonly Level[];
  readonly box: Box;
}

export type Study = { readonly curves: Curves } | { readonly plane: Plane };
