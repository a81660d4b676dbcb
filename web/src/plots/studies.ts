// All charts of studies on a page: each is drawn when it comes into sight.

import type { Say } from "../drawing/words.ts";
import type { Colour } from "./looks.ts";
import { type StudyChart, studyChart } from "./study_chart.ts";
import { studyOf } from "./study_data.ts";
import type { RawCharts } from "./study_raw.ts";

export interface StudyCharts {
  readonly all: readonly StudyChart[];
  toPaper(): void;
  toScreen(): void;
}

/** `words`: by the key of a chart its title and its texts. */
export function studyCharts(
  data: RawCharts,
  words: Readonly<Record<string, readonly string[]>>,
  context: { readonly say: Say; readonly colour: Colour },
): StudyCharts {
  const all = Array.from(document.querySelectorAll<HTMLElement>("figure.study"), (box) => {
    const key = box.dataset["chart"] ?? "";
    return studyChart(box, studyOf(data, key, words[key] ?? []), context);
  });
  const byBox = new Map<Element, StudyChart>(all.map((chart) => [chart.box, chart]));
  const near = new Set<StudyChart>();
  /** Of charts for other values of parameters the one that is chosen is seen. */
  const draw = (): void => {
    for (const chart of near) {
      if (getComputedStyle(chart.box).visibility === "visible") chart.seen();
    }
  };
  const sight = new IntersectionObserver((changes) => {
    for (const { target, isIntersecting } of changes) {
      const chart = byBox.get(target)!;
      if (isIntersecting) near.add(chart);
      else near.delete(chart);
    }
    draw();
  });
  for (const sliders of document.querySelectorAll(".sliders")) sliders.addEventListener("input", draw);
  const sized = new ResizeObserver((changes) => {
    for (const { target } of changes) byBox.get(target)?.sized();
  });
  for (const { box } of all) {
    sight.observe(box);
    sized.observe(box);
  }
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => {
    for (const chart of all) chart.themed();
  });
  return {
    all,
    toPaper() {
      for (const chart of all) chart.toPaper();
    },
    toScreen() {
      for (const chart of all) chart.toScreen();
    },
  };
}
