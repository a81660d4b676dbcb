// What pages draw and plot: the data of linkwright/report/data.py, name by name. A null or NaN says "no
// value here": a pose that can't be assembled. World: x right, y up, angles in radians, counter-clockwise.

/** A place [x, y], in the scene's length unit. */
export type Point = readonly [number, number];
export type Values = ArrayLike<number | null>;
/** A value of a row, null where there is none. */
export function known(values: Values, i: number): number | null {
  const value = values[i];
  return value == null || Number.isNaN(value) ? null : value;
}

export type Pair<T> = readonly [T, T];

/** Placement of a link's axes over time: world = (x, y) + [[c, -s], [s, c]] local. One entry where it never moves. */
export interface PoseRows {
  readonly x: Values;
  readonly y: Values;
  readonly c: Values;
  readonly s: Values;
}

/** A body with its named points, and closed lines such as those of a cam, in its own axes. */
export interface LinkData {
  readonly name: string;
  readonly fixed: boolean;
  readonly points: Readonly<Record<string, Point>>;
  readonly pose: PoseRows;
  readonly outlines?: readonly (readonly Point[])[];
}

/** Two coincident points. */
export interface RevoluteJoint {
  readonly kind: "revolute";
  readonly name: string;
  readonly links: Pair<string>;
  readonly points: Pair<string>;
}

/** Two coincident lines, each by a point and its direction in its link's axes. */
export interface PrismaticJoint {
  readonly kind: "prismatic";
  readonly name: string;
  readonly links: Pair<string>;
  readonly points: Pair<string>;
  readonly angles: Pair<number>;
  readonly look?: "cylinder";
}

export type JointData = RevoluteJoint | PrismaticJoint;

/** The path of a point in the world. */
export interface Trace {
  readonly name: string;
  readonly x: Values;
  readonly y: Values;
}

/** The paths of a link's instant centre: in the world (x, y) and in the link's own axes (u, v). `point`: one of the
 * link, by whose velocity the centre is found anew. */
export interface Centrode {
  readonly link: string;
  readonly point: string;
  readonly x: Values;
  readonly y: Values;
  readonly u: Values;
  readonly v: Values;
}

export type SpringLook = "coil" | "strut";

export interface SpringData {
  readonly name: string;
  readonly links: Pair<string>;
  readonly points: Pair<string>;
  readonly look: SpringLook;
}

/** What lies behind the mechanism: rings of places, holes among them. */
export interface AreaData {
  readonly name: string;
  readonly rings: readonly (readonly Point[])[];
}

export type ArrowKind = "velocity" | "acceleration" | "reaction" | "load" | "weight" | "moment";

/** An arrow by the labels of the rows of its vector, or of the one of a moment, counter-clockwise positive, in `unit`;
 * it begins at a point of a link, or at other rows. */
export interface ArrowData {
  readonly kind: ArrowKind;
  /** What it belongs to: a point, a reaction, a load, a link, a torque. */
  readonly name: string;
  readonly unit: string;
  readonly rows: readonly string[];
  readonly at?: Pair<string>;
  readonly places?: Pair<string>;
}

export interface Scene {
  readonly length_unit: string;
  /** One entry per pose, increasing. */
  readonly time: readonly number[];
  readonly links: readonly LinkData[];
  readonly joints: readonly JointData[];
  readonly traces: readonly Trace[];
  readonly centrodes?: readonly Centrode[];
  readonly springs?: readonly SpringData[];
  readonly areas?: readonly AreaData[];
  /** The links that drives turn, each with the link against which. */
  readonly driven?: readonly Pair<string>[];
  readonly arrows?: readonly ArrowData[];
  /** The rows that arrows name, where they are known. */
  readonly values?: Readonly<Record<string, Values>>;
  /** By sample: is it open, though its links have poses? Without this, where a link has none. */
  readonly open?: readonly boolean[];
}

/** The axis that all plots and the drawing share. */
export interface TimeAxis {
  readonly values: readonly number[];
  readonly unit: string;
  readonly label: string;
}

export interface Series {
  readonly name: string;
  readonly values: Values;
}

/** Curves of one unit against time. */
export interface Plot {
  readonly title: string;
  readonly group: "motion" | "force";
  readonly unit: string;
  readonly series: readonly Series[];
}

/** Texts by their keys in the catalogue, such as "report.play". */
export type Texts = Readonly<Record<string, string>>;
