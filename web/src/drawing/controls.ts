// What stands below a drawing: play, the time's slider, speed, and what is to be seen.

import type { TimeAxis } from "../scene/data.ts";
import { choices, type Entry } from "./check.ts";
import { html, svg } from "./elements.ts";
import { SECONDS, speeds } from "./speeds.ts";
import { colourOf, type Facts, PALETTE, traceColour } from "./survey.ts";
import type { Say } from "./words.ts";

/** More paths than this would hide the mechanism. */
const MANY = 8;

export interface Controls {
  readonly play: HTMLButtonElement;
  readonly slider: HTMLInputElement;
  /** Marks the stretches of the time in which poses can't be assembled. */
  readonly mark: (gaps: readonly boolean[]) => void;
  readonly readout: HTMLOutputElement;
  readonly speed: HTMLSelectElement;
  readonly areas: readonly HTMLInputElement[];
  readonly traces: readonly HTMLInputElement[];
  readonly centrodes: readonly HTMLInputElement[];
}

export interface ControlOptions {
  readonly say: Say;
  readonly time: Pick<TimeAxis, "unit" | "label">;
  /** How many seconds the motion takes in real time. */
  readonly real: number;
}

export function controls(root: Element, facts: Facts, { say, time, real }: ControlOptions): Controls {
  const bar = html("div", { class: "lw-bar" }, root);
  const play = playButton(bar);
  const { slider, mark } = track(bar, facts, time.label, say);
  const readout = html("output", { class: "lw-time", "aria-live": "off" }, bar);

  const options = html("div", { class: "lw-options" }, root);
  const speedLabel = html("label", {}, options, say("speed"));
  const speed = speedChoice(speedLabel, real, SECONDS[time.unit] ? say("real_time") : null);
  const chosen = (title: string, entries: readonly Entry[]) => choices(options, title, entries, say);
  const areas = chosen(
    say("areas"),
    facts.areas.map(({ name }, i) => ({ name, colour: `lw-c${i % PALETTE}`, checked: true })),
  );
  // A page whose numbers are changed says that these aren't computed anew.
  if (facts.areas.length) html("span", { class: "lw-of-file" }, options, say("areas_of_file"));
  const traces = chosen(say("paths"), paths(facts));
  const centrodes = chosen(
    say("centrodes"),
    (facts.scene.centrodes ?? []).map(({ link }) => {
      return { name: link, colour: colourOf(facts, facts.links.get(link)!), checked: false };
    }),
  );
  const stands = facts.times.length < 2 || facts.times.at(-1) === facts.times[0];
  if (stands) for (const part of [bar, speedLabel]) part.classList.add("lw-hidden");
  return { play, slider, mark, readout, speed, areas, traces, centrodes };
}

/** The paths, all to be seen at first if they are few; else those of points that no joint holds, if there are any. */
function paths(facts: Facts): Entry[] {
  const { traces, joints } = facts.scene;
  const held = new Set(joints.flatMap(({ points }) => points));
  const free = new Set(facts.pins.map(({ name }) => name).filter((name) => !held.has(name)));
  const some = traces.length > MANY && traces.some(({ name }) => free.has(name));
  return traces.map(({ name }, i) => ({ name, colour: traceColour(facts, i), checked: !some || free.has(name) }));
}

function playButton(parent: Element): HTMLButtonElement {
  const play = html("button", { class: "lw-play", type: "button" }, parent);
  const icons = svg("svg", { viewBox: "0 0 38 38", "aria-hidden": "true" }, play);
  svg("path", { class: "lw-icon-play", d: "M15 11.5v15l12-7.5z" }, icons);
  svg("path", { class: "lw-icon-pause", d: "M13 12h4v14h-4zM21 12h4v14h-4z" }, icons);
  return play;
}

/** The time's slider, a step a sample, above marks of the stretches that can't be assembled. */
function track(parent: Element, facts: Facts, label: string, say: Say): Pick<Controls, "slider" | "mark"> {
  const box = html("div", { class: "lw-track" }, parent);
  const last = facts.times.length - 1;
  const slider = html("input", { type: "range", min: 0, max: last, step: 1, value: 0, "aria-label": label }, box);
  const marks = html("div", { class: "lw-gaps" }, box);
  const share = (samples: number) => `${(samples / Math.max(last, 1)) * 100}%`;
  const mark = (gaps: readonly boolean[]): void => {
    marks.replaceChildren();
    gaps.forEach((gap, i) => {
      if (!gap || gaps[i - 1]) return;
      const end = gaps.indexOf(false, i);
      const width = (end < 0 ? last : end - 1) - i;
      html("i", { style: `left:${share(i)};width:${share(width)}`, title: say("not_assembled") }, marks);
    });
  };
  mark(facts.gaps);
  return { slider, mark };
}

function speedChoice(parent: Element, real: number, realTime: string | null): HTMLSelectElement {
  const speed = html("select", {}, parent);
  const { usual, list } = speeds(real);
  for (const factor of list) {
    const text = factor === 1 && realTime !== null ? realTime : `× ${factor}`;
    html("option", { value: factor }, speed, text).selected = factor === usual;
  }
  return speed;
}
