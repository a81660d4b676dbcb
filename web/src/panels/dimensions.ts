// The numbers of the model file: a slider and an entry for each, which hold it against drags, and bring it back.

import { html, svg, write } from "../drawing/elements.ts";
import type { LiveNumber } from "../live/live_data.ts";
import type { LiveModel } from "../live/live_model.ts";
import { nice, sixDigits } from "../scene/numbers.ts";
import { filled, type Say } from "../drawing/words.ts";
import { entered } from "./number_entry.ts";

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
  const bounds = tolerances(box, numbers, say, () => rows.forEach((_, i) => place(i)));
  /** The values that the rows show: what stays isn't written again, a browser lays it out anew. */
  const shown = new Float64Array(numbers.length).fill(NaN);
  const marked = numbers.map(() => false);
  const place = (i: number): void => {
    const { slider, entry, back } = rows[i]!;
    const number = numbers[i]!;
    const value = live.value(i);
    const text = sixDigits(value / number.size);
    const typing = document.activeElement === entry;
    shown[i] = typing ? NaN : value;
    const [low, high] = bounds(number);
    const { min, max } = span(Math.min(low, value), Math.max(high, value), number.size);
    slider.min = String(min);
    slider.max = String(max);
    slider.value = String(value / number.size);
    slider.setAttribute("aria-valuetext", `${text} ${number.unit}`);
    if (!typing) entry.value = text;
    const same = !live.moved(i);
    marked[i] = !same;
    back.hidden = same;
    slider.parentElement!.classList.toggle("changed", !same);
  };
  return {
    held: (i) => rows[i]!.hold.getAttribute("aria-pressed") === "true",
    update: () => rows.forEach((_, i) => (live.value(i) !== shown[i] || live.moved(i) !== marked[i]) && place(i)),
  };
}

function row(parent: Element, live: LiveModel, i: number, say: Say, why: string): Row {
  const number = live.data.numbers[i]!;
  const { label, unit, size, locked } = number;
  const line = html("div", { class: "dimension" }, parent);
  const id = `number-${i}`;
  const name = html("label", { for: id, title: why || `${label}` }, line);
  for (const part of label.split(/(?<=\.)/)) {
    name.append(part);
    html("wbr", {}, name);
  }
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
    const value = entered(entry.value, unit, size);
    entry.setAttribute("aria-invalid", String(value === null));
    wrong.hidden = value !== null;
    write(wrong, value === null ? filled(say("live.no_number"), { value: entry.value.trim(), unit }) : "");
    if (value !== null && sixDigits(live.value(i) / size) !== sixDigits(value)) live.set(i, value * size);
  };
  const wrong = html("output", { class: "note bad", hidden: "" }, line);
  entry.addEventListener("change", take);
  entry.addEventListener("keydown", (event) => {
    if (event.key === "Escape") entry.value = sixDigits(live.value(i) / size);
    if (event.key === "Enter" || event.key === "Escape") entry.blur();
  });
  entry.addEventListener("blur", () => {
    if (entry.getAttribute("aria-invalid") === "true") entry.value = sixDigits(live.value(i) / size);
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

/** A box to tick that keeps sliders within tolerances, if there are any; gives the ends of a number's slider, and calls
 * back when they change. */
function tolerances(
  box: Element,
  numbers: readonly LiveNumber[],
  say: Say,
  changed: () => void,
): (number: LiveNumber) => readonly [number, number] {
  let tick: HTMLInputElement | null = null;
  if (numbers.some((number) => number.tolerance)) {
    const label = html("label", { class: "within" }, box);
    tick = html("input", { type: "checkbox" }, label);
    label.append(say("live.within_tolerances"));
    tick.addEventListener("change", changed);
  }
  return ({ low, high, tolerance }) => (tick?.checked && tolerance) || [low, high];
}
