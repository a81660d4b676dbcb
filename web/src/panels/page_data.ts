// What the page brings for its scripts: the data as JSON, its words in the language that is shown.

import type { LiveData } from "../live/live_data.ts";
import type { Plot, Scene, Texts, TimeAxis } from "../scene/data.ts";
import { found } from "./found.ts";

export interface PageData {
  readonly time: TimeAxis;
  readonly scene: Scene;
  readonly plots: readonly Plot[];
  /** The numbers of the plots that a live page shows first, unfolded. */
  readonly first: readonly number[];
  /** What the page needs to compute all values itself: without them scene and plots have none. */
  readonly live?: LiveData;
}

/** The words of report/page.py; those of data in the data's order. */
export interface PageWords {
  readonly texts: Texts;
  readonly time: string;
  readonly axis: string;
  readonly titles: readonly string[];
  readonly labels: readonly string[];
  readonly areas: readonly string[];
  /** The kinds of elements in words. */
  readonly kinds: Readonly<Record<string, string>>;
  /** How a column of times is called in files. */
  readonly column: string;
  /** Of each number that can be moved why it is locked, else an empty text. */
  readonly locked: readonly string[];
}

declare global {
  /** Set by the script that chooses the language, before all others. */
  var linkwrightWords: PageWords;
}

/** The data in the words of the language. */
export function pageData(words: PageWords): PageData {
  const { time, scene, plots, first = [], live } = read("#data") as Omit<PageData, "live"> & { live?: boolean };
  const areas = scene.areas?.map((area, i) => ({ ...area, name: words.areas[i] ?? area.name }));
  const data = live ? (read("#live") as LiveData) : null;
  const values = data ? data.times.map((each) => each / data.second) : time.values;
  return {
    time: { ...time, values, label: words.time },
    scene: areas ? { ...scene, areas } : scene,
    plots: plots.map((plot, i) => ({ ...plot, title: words.titles[i] ?? plot.title })),
    first,
    ...(data ? { live: data } : {}),
  };
}

const read = (selector: string): unknown => JSON.parse(found(selector).textContent ?? "");
