// How a plot looks, on the screen and, enlarged for its finer dots, on paper.

import uPlot from "uplot";
import { type Curve, type Curves, limits, sideExtent } from "./curves.ts";
import { shortened, tick } from "./figure.ts";
import { clipped, scaled, trace } from "./traces.ts";
import { type Colour, colourOf, dashOf, faded } from "./looks.ts";
import "./of_studies.ts";
import { OPACITY, outline } from "./outline.ts";

const MOUSE = ["mousedown", "mouseup", "mousemove", "mouseleave", "mouseenter", "click", "dblclick"] as const;
const FONTS =
  'system-ui, -apple-system, "Segoe UI", Roboto, Arial, ' +
  '"PingFang SC", "Microsoft YaHei", "Noto Sans CJK SC", sans-serif';

export interface ChartSize {
  readonly width: number;
  readonly height: number;
  /** Enlarges all of it. */
  readonly scale?: number;
}

/** What of a plot may change while it keeps its options. */
export interface Shown {
  curves: Curves;
  /** What is in sight of the horizontal axis. */
  window: readonly [number, number];
  /** The sample at the cursor. */
  index: number;
}

/** Plots with the same key differ in values alone. */
export const chartKey = ({ curves, units, x }: Curves): string =>
  JSON.stringify([x.label, units, ...curves.map(({ name, right }) => [name, right])]);

export function chartOptions(shown: Shown, colour: Colour, { width, height, scale = 1 }: ChartSize): uPlot.Options {
  const { curves, units, x, names, vertical: called } = shown.curves;
  const font = `${11 * scale}px ${FONTS}`;
  const axis: uPlot.Axis = {
    font,
    labelFont: font,
    stroke: () => colour("muted"),
    grid: { stroke: () => colour("grid"), width: scale },
    ticks: { stroke: () => colour("line"), width: scale, size: 5 * scale },
    gap: 4 * scale,
    values: (_, splits) => splits.map(tick),
  };
  const longest: uPlot.Axis.Size = (_, values) =>
    Math.max(...(values ?? [""]).map((text) => String(text).length), 3) * 6.4 * scale + 14 * scale;
  const side = (right: boolean): uPlot.Scale.Range => (u) => {
    const ends = sideExtent(shown.curves, right, shown.window, (i) => u.series[i + 1]?.show !== false);
    return ends ? uPlot.rangeNum(...limits(...ends), 0.08, true) : [-1, 1];
  };
  const unitLabel = (i: number): Partial<uPlot.Axis> => {
    const label = called ?? (units.length > 1 ? units[i] : "");
    return label ? { label, labelSize: 15 * scale, labelGap: 0 } : {};
  };
  const horizontal = { ...axis, ...(!globalThis.WITHOUT_STUDIES ? below(names) : {}), label: x.label };
  const vertical = { ...axis, space: 25 * scale, size: longest };
  const other: uPlot.Axis = { ...vertical, ...unitLabel(1), scale: "right", side: 1, grid: { show: false } };
  return {
    width: width * scale,
    height: height * scale,
    // Half of a label at the end of the horizontal axis lies beyond it.
    padding: [8 * scale, () => Math.max(10, 3.4 * endLabel(shown, names) + 3) * scale, 0, 0],
    legend: { show: false },
    focus: { alpha: 1 },
    cursor: {
      y: false,
      drag: { x: false, y: false, setScale: false },
      points: { size: 7 },
      dataIdx: () => shown.index,
      bind: Object.fromEntries(MOUSE.map((name) => [name, () => null])), // pointing.ts takes over
    },
    scales: {
      x: { time: false, range: () => [...shown.window] },
      y: { range: side(false) },
      ...(units.length > 1 ? { right: { range: side(true) } } : {}),
    },
    axes: [
      { ...horizontal, space: 46 * scale, size: 22 * scale, labelSize: 16 * scale, labelGap: 0 },
      { ...vertical, ...unitLabel(0) },
      ...(units.length > 1 ? [other] : []),
    ],
    hooks: { drawAxes: [(u) => ghosts(u, shown.curves, colour, scale)] },
    series: [
      {},
      ...curves.map(
        (curve, i): uPlot.Series => ({
          label: curve.name,
          scale: curve.right ? "right" : "y",
          stroke: () => colour(colourOf(curve, i)),
          width: 1.7 * scale,
          pxAlign: 0,
          dash: dashOf(curve, i).map((part) => part * scale),
          points: { show: x.values.length < 2 && !curve.look },
          ...(x.ascends ? {} : { paths: overAxis(shown) }),
          ...(!globalThis.WITHOUT_STUDIES && filled(curve) ? filledLook(shown, i, colour, scale) : {}),
        }),
      ),
    ],
  };
}

/** How many letters the longer label at an end of the horizontal axis has. */
const endLabel = ({ window }: Shown, names: readonly string[] | undefined): number =>
  names ? 0 : Math.max(...window.map((end) => tick(Number(end.toPrecision(2))).length));

/** Names in place of numbers, as long as there is room for them. */
const below = (names: readonly string[] | undefined): Partial<uPlot.Axis> =>
  names
    ? {
        splits: () => names.map((_, i) => i + 0.5),
        grid: { show: false },
        values: ({ bbox }) => names.map((name) => shortened(name, bbox.width / devicePixelRatio / names.length / 7)),
      }
    : {};

const filled = ({ look }: Curve): boolean => look !== undefined && look.kind !== "line";

/** A look that is filled. */
const filledLook = (shown: Shown, i: number, colour: Colour, scale: number): Partial<uPlot.Series> => ({
  width: 0,
  fill: () => {
    const curve = shown.curves.curves[i]!;
    return faded(colour(colourOf(curve, i)), OPACITY[curve.look!.kind]);
  },
  paths: (u) => {
    const { curves, x } = shown.curves;
    const { look, values, right } = curves[i]!;
    const [across, up] = [scaled(u, "x"), scaled(u, right ? "right" : "y")];
    return { stroke: null, fill: new Path2D(outline(look!, x.values, values, across, up, scale * devicePixelRatio)) };
  },
});

/** Curves over values that go up and down, in the order of the samples. */
const overAxis =
  (shown: Shown): uPlot.Series.PathBuilder =>
  (u, series) => {
    const { curves, x } = shown.curves;
    const curve = curves[series - 1]!;
    return { stroke: trace(u, curve.right, x.values, curve.values) };
  };

/** The curves of the original behind those of a changed model. */
function ghosts(u: uPlot, { curves, x }: Curves, colour: Colour, scale: number): void {
  const { ctx } = u;
  curves.forEach(({ ghost, right }, i) => {
    if (!ghost || u.series[i + 1]?.show === false) return;
    clipped(u, () => {
      ctx.strokeStyle = colour("muted");
      ctx.globalAlpha = 0.75;
      ctx.lineWidth = scale * devicePixelRatio;
      ctx.setLineDash([4 * scale * devicePixelRatio, 3 * scale * devicePixelRatio]);
      ctx.stroke(trace(u, right, x.ghost ?? x.values, ghost));
    });
  });
}

export const columns = ({ x, curves }: Curves): uPlot.AlignedData =>
  [x.values, ...curves.map((curve) => curve.values)] as uPlot.AlignedData;

