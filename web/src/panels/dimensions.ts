// The numbers of the model file: a slider and an entry for each, which hold it against drags, and bring it back.

import { html, svg } from "../drawing/elements.ts";
import type { LiveNumber } from "../live/live_data.ts";
import type { LiveModel } from "../live/live_model.ts";
import { nice } from "../scene/numbers.ts";
import type { Say } from "../drawing/words.ts";

/** In how many steps a slider goes at least from end to end. */
const STEPS = 400;

export interface Dimensions {
  /** Whether a number is held against drags. */
  held(number: number): boolean;
  /** Show the values of the moment. */
  update(): void;
}

interface Row {
  readonly slider: HTMLInputElement;
  readonly entry: HTMLInputElement;
  readonly hold: HTMLButtonElement;
  readonly back: HTMLButtonElement;
}

/** Fills the box. `why`: of each number the reason for which it is locked, else an empty text. */
export function dimensions(box: Element, live: LiveModel, say: Say, why: readonly string[]): Dimensions {
  const { numbers } = live.data;
  const named = html("div", { class: "numbers" }, box);
  const anyNamed = numbers.some((number) => number.named);
  const more = html("details", {}, box);
  html("summary", {}, more, say("live.others"));
  const others = html("div", { class: "numbers" }, more);
  more.open = !anyNamed;
  const rows = numbers.map((number, i) =>
    row(number.named ? named : others, live, i, say, why[i] ?? ""),
  );
  if (!others.childElementCount) more.remove();
  const within = tolerances(box, numbers, rows, live, say);
  return {
    held: (i) => rows[i]!.hold.getAttribute("aria-pressed") === "true",
    update() {
      rows.forEach(({ slider, entry, back }, i) => {
        const number = numbers[i]!;
        const value = live.value(i) / number.size;
        slider.value = String(value);
        slider.setAttribute("aria-valuetext", `${written(value)} ${number.unit}`);
        if (document.activeElement !== entry) entry.value = written(value);
        const same = live.value(i) === number.value;
        back.hidden = same;
        slider.parentElement!.classList.toggle("changed", !same);
      });
      within();
    },
  };
}

/** A value as it is shown: six significant digits. */
export const written = (value: number): string => String(Number(value.toPrecision(6)));

function row(parent: Element, live: LiveModel, i: number, say: Say, why: string): Row {
  const number = live.data.numbers[i]!;
  const { label, unit, size, locked } = number;
  const line = html("div", { class: "dimension" }, parent);
  const id = `number-${i}`;
  html("label", { for: id, title: why || `${label}` }, line, label);
  const slider = html("input", { type: "range", "aria-label": label, ...span(number.low, number.high, size) }, line);
  const entry = html("input", { id, type: "text", inputmode: "decimal", autocomplete: "off" }, line);
  html("span", { class: "unit" }, line, unit);
  const hold = button(line, "hold", say("live.hold"), LOCK);
  const back = button(line, "back", say("live.reset_one"), BACK);
  hold.setAttribute("aria-pressed", "false");
  hold.addEventListener("click", () => {
    hold.setAttribute("aria-pressed", String(hold.getAttribute("aria-pressed") !== "true"));
  });
  back.addEventListener("click", () => live.reset(i));
  slider.addEventListener("input", () => live.set(i, Number(slider.value) * size));
  const take = (): void => {
    const value = Number(entry.value.trim().replace("−", "-").replace(",", "."));
    const good = entry.value.trim() !== "" && Number.isFinite(value);
    entry.setAttribute("aria-invalid", String(!good));
    if (good && written(live.value(i) / size) !== written(value)) live.set(i, value * size);
  };
  entry.addEventListener("change", take);
  entry.addEventListener("keydown", (event) => {
    if (event.key === "Escape") entry.value = written(live.value(i) / size);
    if (event.key === "Enter" || event.key === "Escape") entry.blur();
  });
  entry.addEventListener("blur", () => {
    if (entry.getAttribute("aria-invalid") === "true") entry.value = written(live.value(i) / size);
    entry.removeAttribute("aria-invalid");
  });
  if (locked) {
    for (const input of [slider, entry, hold]) input.disabled = true;
    line.classList.add("locked");
    html("span", { class: "note" }, line, why);
  }
  return { slider, entry, hold, back };
}

/** Signs of buttons, drawn: few fonts have them. */
const LOCK = "M5 9V6.5a4 4 0 0 1 8 0V9M3.5 9h11v7h-11z";
const BACK = "M4 8a5.5 5.5 0 1 1-.5 3M4 3.5V8h4.5";

function button(parent: Element, kind: string, label: string, sign: string): HTMLButtonElement {
  const made = html("button", { type: "button", class: kind, "aria-label": label, title: label }, parent);
  svg("path", { d: sign }, svg("svg", { viewBox: "0 0 18 18", "aria-hidden": "true" }, made));
  return made;
}

/** The ends and the step of a slider, in the number's unit. */
function span(low: number, high: number, size: number): { min: number; max: number; step: string } {
  const [min, max] = [low / size, high / size];
  const step = max > min ? nice((max - min) / STEPS) : 1;
  const round = (value: number, to: (x: number) => number): number => Number((to(value / step) * step).toPrecision(12));
  return { min: round(min, Math.floor), max: round(max, Math.ceil), step: "any" };
}

/** A box to tick that keeps sliders within tolerances, if there are any; gives what updates the ends of sliders: they
 * reach as far as a value that was typed. */
function tolerances(
  box: Element,
  numbers: readonly LiveNumber[],
  rows: readonly Row[],
  live: LiveModel,
  say: Say,
): () => void {
  let tick: HTMLInputElement | null = null;
  if (numbers.some((number) => number.tolerance)) {
    const label = html("label", { class: "within" }, box);
    tick = html("input", { type: "checkbox" }, label);
    label.append(say("live.within_tolerances"));
  }
  const update = (): void => {
    rows.forEach(({ slider }, i) => {
      const { low, high, size, tolerance } = numbers[i]!;
      const ends = (tick?.checked && tolerance) || [low, high];
      const { min, max } = span(Math.min(ends[0], live.value(i)), Math.max(ends[1], live.value(i)), size);
      slider.min = String(min);
      slider.max = String(max);
      slider.value = String(live.value(i) / size);
    });
  };
  tick?.addEventListener("change", update);
  return update;
}
