// What the page brings for its scripts: the data as JSON, its words in the language that is shown.

import type { LiveData } from "../live/live_data.ts";
import { type List, type Packed, signalsOf, timesOf, unpacked } from "../live/packed.ts";
import type { LiveMeasure, LiveNumber, LiveRow } from "../measures/measure.ts";
import type { Plot, Scene, Texts, TimeAxis } from "../scene/data.ts";
import type { RawCharts } from "../plots/study_raw.ts";
import type { Sought } from "../plots/signals.ts";
import { found } from "./found.ts";

export interface PageData {
  readonly time: TimeAxis;
  readonly scene: Scene;
  readonly plots: readonly Sought[];
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
  /** By what else each plot is looked for. */
  readonly also?: readonly string[];
  /** What a plot shows, with places for its {title}, {unit} and {signals}. */
  readonly label: string;
  readonly label_unit: string;
  readonly areas: readonly string[];
  /** By the key of a study's chart its title, then its texts. */
  readonly charts: Readonly<Record<string, readonly string[]>>;
  /** The kinds of elements in words. */
  readonly kinds: Readonly<Record<string, string>>;
  /** How a column of times is called in files. */
  readonly column: string;
  /** Of each number that can be moved why it is locked, else an empty text. */
  readonly locked: readonly string[];
  /** What each of them is called where that isn't its label, else an empty text. */
  readonly names?: readonly string[];
  /** Of each condition on numbers what is wrong where it isn't met. */
  readonly faults: List<string>;
  /** Of each dyad with two modes its links and its outer joints. */
  readonly groups: readonly (readonly [string, string])[];
  /** What there is to say of a dyad that can't close, where it must span too much and where too little. */
  readonly gap: readonly string[];
}

declare global {
  /** Set by the script that chooses the language, before all others. */
  var linkwrightWords: PageWords;
}

/** The data as they stand in the page, without words. */
type Stated = Omit<PageData, "live" | "plots"> & { plots: readonly Omit<Plot, "title">[]; live?: boolean };

/** The data in the words of the language. */
export function pageData(words: PageWords): PageData {
  const { time, scene, plots, first = [], live } = read("#data") as Stated;
  // Rows of arrows stand without the name that they begin with.
  const whole = (name: string) => (row: string): string => (row.startsWith(".") ? name + row : row);
  const arrows = scene.arrows?.map((arrow) => ({ ...arrow, rows: arrow.rows.map(whole(arrow.name)) }));
  const areas = scene.areas?.map((area, i) => ({ ...area, name: words.areas[i] ?? area.name }));
  const data = live ? liveData(read("#live") as Packed, words.names ?? []) : null;
  const values = data ? data.times.map((each) => each / data.second) : time.values;
  return {
    time: { ...time, values, label: words.time },
    scene: { ...scene, ...(areas ? { areas } : {}), ...(arrows ? { arrows } : {}) },
    plots: plots.map((plot, i) => ({ ...plot, title: words.titles[i] ?? "", also: words.also?.[i] ?? "" })),
    first,
    ...(data ? { live: data } : {}),
  };
}

/** The charts of studies, on a page that has some. */
export const chartData = (): RawCharts => read("#charts") as RawCharts;

function liveData(data: Packed, names: readonly string[]): LiveData {
  const size = ({ unit = "" }: { unit?: string }): { size: number } => ({ size: data.unit_sizes[unit]! });
  const measures = data.measures.map((one) => ({ ...NOTHING, ...size(one), ...one, ...stated(one) }));
  const numbers = data.numbers.map((number, i) => {
    const whole = { ...PLAIN, ...size(number), ...number };
    return { ...whole, label: names[i] || whole.label };
  });
  const conditions = { places: data.conditions.places, sizes: unpacked(data.conditions.sizes) };
  const lists = { ...signalsOf(data.signals), sizes: unpacked(data.sizes), units: unpacked(data.units) };
  return { ...data, ...lists, times: timesOf(data.times), measures, numbers, conditions };
}

const PLAIN = { tolerance: null, named: false, drawn: false, locked: false, unit: "" };
const NOTHING = { reason: null, watched: [], window: null, numbers: {}, words: {}, wrap: null, requirement: null };

/** The parts of a measure in which something may be absent. */
function stated(measure: Partial<LiveMeasure>): Partial<LiveMeasure> {
  const row = (one: Partial<LiveRow> & Pick<LiveRow, "row">): LiveRow => ({ jumps: false, angle: false, ...one });
  const number = (one: Partial<LiveNumber>): LiveNumber => ({ value: null, row: null, ...one });
  const { rows = {}, window, numbers = {}, wrap, requirement } = measure;
  return {
    rows: Object.fromEntries(Object.entries(rows).map(([key, one]) => [key, row(one)])),
    numbers: Object.fromEntries(Object.entries(numbers).map(([key, one]) => [key, number(one)])),
    ...(window
      ? {
          window: {
            row: window.row ? row(window.row) : null,
            ends: [number(window.ends[0]), number(window.ends[1])],
            turning: Boolean(window.turning),
          },
        }
      : {}),
    ...(wrap ? { wrap: [number(wrap[0]), number(wrap[1])] } : {}),
    ...(requirement
      ? {
          requirement: {
            text: requirement.text,
            low: requirement.low ? number(requirement.low) : null,
            high: requirement.high ? number(requirement.high) : null,
          },
        }
      : {}),
  };
}

const read = (selector: string): unknown => JSON.parse(found(selector).textContent ?? "");
