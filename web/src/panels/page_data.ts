// What the page brings for its scripts: the data as JSON, its words in the language that is shown.

import type { Plot, Scene, Texts, TimeAxis } from "../scene/data.ts";
import { found } from "./found.ts";

export interface PageData {
  readonly time: TimeAxis;
  readonly scene: Scene;
  readonly plots: readonly Plot[];
}

/** The words of report/page.py; those of data in the data's order. */
export interface PageWords {
  readonly texts: Texts;
  readonly time: string;
  readonly axis: string;
  readonly titles: readonly string[];
  readonly labels: readonly string[];
  readonly areas: readonly string[];
}

declare global {
  /** Set by the script that chooses the language, before all others. */
  var linkwrightWords: PageWords;
}

/** The data in the words of the language. */
export function pageData(words: PageWords): PageData {
  const { time, scene, plots } = JSON.parse(found("#data").textContent ?? "") as PageData;
  const areas = scene.areas?.map((area, i) => ({ ...area, name: words.areas[i] ?? area.name }));
  return {
    time: { ...time, label: words.time },
    scene: areas ? { ...scene, areas } : scene,
    plots: plots.map((plot, i) => ({ ...plot, title: words.titles[i] ?? plot.title })),
  };
}
