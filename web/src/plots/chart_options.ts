// How a plot looks, on the screen and, enlarged for its finer dots, on paper.

import uPlot from "uplot";
import type { Plot, TimeAxis } from "../scene/data.ts";
import { tick } from "./figure.ts";
import { type Colour, colourName, dash } from "./looks.ts";

const MOUSE = ["mousedown", "mouseup", "mousemove", "mouseleave", "mouseenter", "click", "dblclick"] as const;
const FONTS =
  'system-ui, -apple-system, "Segoe UI", Roboto, Arial, ' +
  '"PingFang SC", "Microsoft YaHei", "Noto Sans CJK SC", sans-serif';

/** What all plots of a page share. */
export interface Shared {
  readonly time: TimeAxis;
  /** Name and unit of the time's axis. */
  readonly axis: string;
  readonly colour: Colour;
}

export interface ChartSize {
  readonly width: number;
  readonly height: number;
  /** Enlarges all of it. */
  readonly scale?: number;
}

export function chartOptions(
  plot: Plot,
  { time, axis: label, colour }: Shared,
  { width, height, scale = 1 }: ChartSize,
): uPlot.Options {
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
  return {
    width: width * scale,
    height: height * scale,
    padding: [8 * scale, 10 * scale, 0, 0],
    legend: { show: false },
    focus: { alpha: 1 },
    cursor: {
      y: false,
      drag: { x: false, y: false, setScale: false },
      points: { size: 7 },
      bind: Object.fromEntries(MOUSE.map((name) => [name, () => null])), // pointing.ts takes over
    },
    scales: { x: { time: false }, y: { range: limits } },
    axes: [
      { ...axis, space: 46 * scale, size: 22 * scale, labelSize: 16 * scale, labelGap: 0, label },
      { ...axis, space: 25 * scale, size: longest },
    ],
    series: [
      {},
      ...plot.series.map(
        (series, i): uPlot.Series => ({
          label: series.name,
          stroke: () => colour(colourName(i)),
          width: 1.7 * scale,
          pxAlign: 0,
          dash: dash(i).map((part) => part * scale),
          points: { show: time.values.length < 2 },
        }),
      ),
    ],
  };
}

/** Limits of the value axis: round-off around a constant is shown as a constant. */
function limits(_: uPlot, low: number | null, high: number | null): uPlot.Range.MinMax {
  if (low == null || high == null) return [-1, 1];
  const size = Math.max(Math.abs(low), Math.abs(high));
  const nought = size < 1e-10;
  const spread = high - low < 1e-8 * size || nought ? Math.max(0.1 * size, nought ? 1 : 0) : 0;
  return uPlot.rangeNum(low - spread, high + spread, 0.08, true);
}

export const columns = (plot: Plot, time: TimeAxis): uPlot.AlignedData =>
  [time.values, ...plot.series.map((series) => series.values)] as uPlot.AlignedData;
