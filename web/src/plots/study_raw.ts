// The data of study charts as presentation/chart_data.py writes them: texts and lines by their numbers.

import type { Values } from "../scene/data.ts";
import type { RawField } from "./field_data.ts";
import type { Look } from "./outline.ts";

/** Least x, least y, largest x, largest y. */
export type Box = readonly [number, number, number, number];

export type Steps = Values | { readonly from: number; readonly to: number; readonly count: number };
export interface RawAxis {
  readonly name: number;
  readonly unit: string;
}
export interface RawLimit {
  readonly text: number;
  readonly value: number;
  readonly upright?: boolean;
}
export interface RawRow {
  readonly name: number;
  readonly colour: number | string;
  readonly look?: Look["kind"];
  readonly dash?: number;
  readonly values: Values;
  /** The samples of the values, where few have one. */
  readonly of?: readonly number[];
  readonly low?: Values;
  readonly edges?: Steps;
  readonly pairs?: Steps;
}
export interface RawScale {
  readonly axis: RawAxis;
  readonly low: number;
  readonly high: number;
  readonly stops: readonly string[];
}
export type RawLayer =
  | {
      readonly kind: "region";
      readonly name: number;
      readonly colour: number | string;
      readonly paths: readonly number[];
    }
  | {
      readonly kind: "lines";
      readonly name: number;
      readonly colour: number | string;
      readonly dash: number;
      readonly width: number;
      readonly paths: readonly number[];
    }
  | {
      readonly kind: "coloured";
      readonly name: number;
      readonly scale: RawScale;
      readonly groups: readonly { readonly value: number; readonly paths: readonly number[] }[];
    }
  | {
      readonly kind: "spots";
      readonly name: number;
      readonly colour: number | string;
      readonly cross: boolean;
      readonly x: Values;
      readonly y: Values;
      readonly values?: Values;
      readonly scale?: RawScale;
    }
  | ({ readonly kind: "field"; readonly axis: RawAxis; readonly limits?: readonly RawLimit[] } & RawField<Steps>);
export interface RawGraph {
  readonly x: RawAxis;
  readonly at: Steps;
  readonly y: RawAxis;
  readonly rows: readonly RawRow[];
  readonly limits?: readonly RawLimit[];
  readonly names?: readonly number[];
}
export interface RawPlane {
  readonly x: RawAxis;
  readonly y: RawAxis;
  readonly fine: number;
  readonly layers: readonly RawLayer[];
  readonly equal?: boolean;
  readonly limits?: readonly RawLimit[];
  readonly box?: Box;
}

/** The charts of a page by their keys; `paths` are the lines of all. */
export interface RawCharts {
  readonly charts: Readonly<Record<string, RawGraph | RawPlane>>;
  readonly paths: readonly string[];
}
