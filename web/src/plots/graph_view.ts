// A study's curves over an axis, drawn as the plots of the cycle are, with a cursor of their own.

import { clamp } from "../scene/numbers.ts";
import { nearest } from "../scene/times.ts";
import { type Chart, chart, HEIGHT } from "./chart.ts";
import { chartSvg } from "./chart_svg.ts";
import { csvText } from "./csv.ts";
import type { Curves } from "./curves.ts";
import { figure } from "./figure.ts";
import { legend } from "./legend.ts";
import { lightColours } from "./looks.ts";
import { paperChart } from "./paper.ts";
import { pointing } from "./pointing.ts";
import { readout, type StudyPlace, type StudyView } from "./study_view.ts";

export function graphView(curves: Curves, place: StudyPlace): StudyView {
  const { x } = curves;
  const at = Array.from(x.values, Number);
  const hidden = new Set<number>();
  let window = x.ends;
  let index = -1;
  const entries = curves.curves.map(({ name, look }) => ({ name, unit: "", look }));
  const outputs = legend(place.legend, entries, {
    toggle(i, show) {
      if (show) hidden.delete(i);
      else hidden.add(i);
      drawn?.uplot.setSeries(i + 1, { show });
    },
  });
  const [place_] = readout(place.legend, [x.name]);
  let drawn: Chart | null = null;
  const show = (): void => {
    drawn?.follow(index);
    const value = at[index];
    const name = curves.names?.[index] ?? (value === undefined ? "–" : `${figure(value)} ${x.unit}`.trim());
    place_!.textContent = name;
    curves.curves.forEach(({ values, look, unit }, i) => {
      const low = look?.low ? `${figure(look.low[index])} … ` : "";
      outputs[i]!.textContent = index < 0 ? "" : `${low}${figure(values[index])} ${unit}`.trim();
    });
  };
  const goTo = (to: number): void => {
    index = nearest(at, to);
    show();
  };
  const zoom = (from: number, to: number): void => {
    window = [from, to];
    drawn?.zoom(window);
    place.zoomed(from === x.ends[0] && to === x.ends[1]);
    requestAnimationFrame(() => drawn?.follow(index));
  };
  const reset = (): void => zoom(...x.ends);
  const nothing = (): void => {};
  const draw = (): Chart => {
    const made = chart(place.area, curves, place.label, { colour: place.colour, window, goTo });
    hidden.forEach((i) => made.uplot.setSeries(i + 1, { show: false }));
    made.follow(index);
    pointing(made.uplot, { goTo, zoom, unzoom: reset, hold: nothing, release: nothing, keep: nothing, drop: nothing });
    made.uplot.over.tabIndex = 0;
    return made;
  };
  const steps = (by: number): void => {
    index = index < 0 ? nearest(at, (window[0] + window[1]) / 2) : clamp(index + by, 0, at.length - 1);
    show();
  };
  const closer = (factor: number): void => {
    const middle = at[index] ?? (window[0] + window[1]) / 2;
    const [low, high] = window.map((end) => middle + factor * (end - middle)) as [number, number];
    zoom(Math.max(low, x.ends[0]), Math.min(high, x.ends[1]));
  };
  return {
    seen() {
      drawn ??= draw();
    },
    reset,
    key(key, far) {
      const by = far ? 10 : 1;
      if (key === "ArrowLeft") steps(-by);
      else if (key === "ArrowRight") steps(by);
      else if (key === "+" || key === "=") closer(0.5);
      else if (key === "-") closer(2);
      else if (key === "Escape") reset();
      else return false;
      return true;
    },
    sized: () => drawn?.sized(),
    themed: () => drawn?.uplot.redraw(false),
    csv: () => csvText(curves, { name: x.name, unit: x.unit, values: x.values }, ""),
    svg: (width) =>
      chartSvg(curves, {
        width,
        height: HEIGHT + 20,
        colour: lightColours(),
        window,
        index: 0,
        note: "",
        shown: (i) => !hidden.has(i),
      }),
    toPaper() {
      const paper = paperChart(place.area, curves, window, place.colour);
      return () => paper.remove();
    },
    remove: () => drawn?.destroy(),
  };
}
