// The live report: one change of a number moves the drawing, the plots, and what the page says of them.

import { html, write } from "../drawing/elements.ts";
import type { Drawing } from "../drawing/render.ts";
import { still } from "../drawing/still.ts";
import { filled, type Say, speaker } from "../drawing/words.ts";
import { dimensions } from "../panels/dimensions.ts";
import { found } from "../panels/found.ts";
import { liveState } from "../panels/live_state.ts";
import { measured } from "../panels/measured.ts";
import type { StateWords } from "../panels/state_line.ts";
import type { Charts } from "../plots/charts.ts";
import type { Scene, Texts, TimeAxis } from "../scene/data.ts";
import { dragging } from "./dragging.ts";
import type { Hindrance, LiveModel } from "./live_model.ts";
import { sceneOf } from "./live_scene.ts";
import { sixDigits } from "../scene/numbers.ts";

/** After so long without a change (ms) the picture for paper is drawn. */
const RESTING = 300;

export interface LivePage {
  readonly live: LiveModel;
  readonly drawing: Drawing;
  readonly charts: Charts;
  readonly scene: Scene;
  readonly time: TimeAxis;
  readonly texts: Texts;
  /** Of each number why it is locked, else an empty text. */
  readonly locked: readonly string[];
  readonly stateWords: StateWords;
}

export function livePage({ live, drawing, charts, scene, time, texts, locked, stateWords }: LivePage): void {
  const say = speaker(texts);
  const box = found("#numbers");
  const original = sceneOf(scene, live);
  const bar = html("div", { class: "live-bar" }, box);
  const state = liveState(found("#state"), bar, live, say, time.unit, stateWords);
  const panel = dimensions(box, live, say, locked);
  const table = measured(live, say, time);
  const { shapes, hint } = modes(found("#drawing .lw"), drawing, say);
  const caption = found<HTMLElement>("figure.paper figcaption");
  const captioned = caption.textContent;
  let resting = 0;
  /** The picture for paper follows when the numbers rest. */
  const toPaper = (now: Scene): void => {
    still({ model: now, el: found("#still"), words: texts, seen: drawing.seen });
    caption.textContent = live.changed ? `◐ ${say("live.changed")}. ${captioned}` : captioned;
  };
  let now = original;
  const update = (): void => {
    // Numbers that make no sense have no picture: the last one stays.
    const kind = live.motion.failure?.kind;
    if (kind !== "number" && kind !== "parameter") now = live.changed ? sceneOf(scene, live) : original;
    drawing.update(now, live.changed ? original : null);
    panel.update();
    state.update(now);
    clearTimeout(resting);
    const last = now;
    resting = window.setTimeout(() => toPaper(last), RESTING);
  };
  live.on(inTurns(update, [() => charts.update(), () => table.update()]));
  dragging({
    live,
    drawing,
    held: panel.held,
    shapes,
    said: (off, by) => {
      hint.hidden = off === null;
      if (off === null) return;
      const far = `${Number((off / live.data.length).toPrecision(4))} ${scene.length_unit}`;
      write(hint, hindered(live, say, far, by));
    },
  });
  panel.update();
  state.update(original);
}

/** Why a point is still so far from the pointer. */
function hindered(live: LiveModel, say: Say, off: string, by?: Hindrance): string {
  if (by?.locked) return filled(say("live.out_of_reach_locked"), { off });
  const [first] = by?.ended ?? [];
  if (first === undefined) return filled(say("live.out_of_reach"), { off });
  const { label, size, unit } = live.data.numbers[first]!;
  const value = `${sixDigits(live.value(first) / size)} ${unit}`.trim();
  return filled(say("live.out_of_reach_end"), { off, name: label, value });
}

/** What is called after each change: `first` in the next frame, the others one a frame after it, so that no frame has
 * to do everything. Those that a next change keeps waiting come first then. */
function inTurns(first: () => void, others: readonly (() => void)[]): () => void {
  let [changed, waiting] = [false, false];
  let due: (() => void)[] = [];
  const wait = (): void => {
    if (!waiting) requestAnimationFrame(frame);
    waiting = true;
  };
  const frame = (): void => {
    waiting = false;
    if (changed) {
      first();
      due = [...due, ...others.filter((each) => !due.includes(each))];
    }
    changed = false;
    due.shift()?.();
    if (due.length) wait();
  };
  return () => {
    changed = true;
    wait();
  };
}

/** The choice of what a drag does, above the drawing's controls, and the place where a drag says what hinders it. */
function modes(root: Element, drawing: Drawing, say: Say): { shapes(): boolean; hint: HTMLElement } {
  const bar = html("div", { class: "lw-modes", role: "group", "aria-label": say("live.drag") });
  root.insertBefore(bar, root.querySelector(".lw-bar"));
  html("span", {}, bar, say("live.drag"));
  const buttons = (["shape", "move"] as const).map((mode) => {
    const pressed = String(mode === "shape");
    const button = html("button", { type: "button", "aria-pressed": pressed }, bar, say(`live.${mode}`));
    button.addEventListener("click", () => {
      for (const each of buttons) each.setAttribute("aria-pressed", String(each === button));
    });
    return button;
  });
  const hint = html("output", { class: "lw-hint", hidden: "" }, bar);
  drawing.picture.classList.add("lw-live");
  return { shapes: () => buttons[0]!.getAttribute("aria-pressed") === "true", hint };
}
