// What the page says of a model that was changed: that nothing verifies it, what it can't do, how to get back, and the
// lines of the file that would make it so.

import { html, write } from "../drawing/elements.ts";
import type { Say } from "../drawing/words.ts";
import type { LiveModel } from "../live/live_model.ts";
import { changedLines } from "../live/changed_lines.ts";
import type { Scene } from "../scene/data.ts";
import { copy } from "./copy.ts";
import { type StateWords, stateLine } from "./state_line.ts";

export interface LiveState {
  update(scene: Scene): void;
}

/** Fills the boxes: a badge in the page's head, and a bar above the numbers. */
export function liveState(
  badges: Element,
  bar: Element,
  live: LiveModel,
  say: Say,
  unit: string,
  words: StateWords,
): LiveState {
  const badge = html("span", { class: "mark changed", role: "status", hidden: "" }, badges);
  const errors = badges.querySelector<HTMLElement>("#count-errors");
  const line = html("p", { class: "live-line", role: "status" }, bar);
  const tools = html("p", { class: "live-tools screen" }, bar);
  const tool = (key: string, act: () => void): HTMLButtonElement => {
    const button = html("button", { type: "button" }, tools, say(key));
    button.addEventListener("click", act);
    return button;
  };
  const undo = tool("live.undo", () => live.undo());
  document.addEventListener("keydown", (event) => {
    const typing = event.target instanceof HTMLInputElement && event.target.type === "text";
    if (event.key === "z" && (event.ctrlKey || event.metaKey) && !event.shiftKey && !typing && live.undo()) {
      event.preventDefault();
    }
  });
  const reset = tool("live.reset", () => live.reset());
  const back = tool("live.back", () => live.back());
  const copied = tool("live.copy", async () => {
    await copy(changedLines(live).join("\n"));
    copied.textContent = say("copied");
    setTimeout(() => (copied.textContent = say("live.copy")), 2000);
  });
  const lines = html("pre", { class: "live-lines" }, bar);
  /** What takes longer than a frame has waits until the numbers rest. */
  let waiting = 0;
  const later = (scene: Scene): void => {
    lines.textContent = live.changed ? changedLines(live).join("\n") : "";
    line.textContent = live.sound ? stateLine(live, say, unit, scene, words) : say("live.unsound");
  };
  const update = (scene: Scene): void => {
    const { changed, motion } = live;
    document.documentElement.classList.toggle("live-changed", changed);
    badge.hidden = !changed;
    // What kept the file's links from closing is mended.
    if (errors) errors.hidden = Boolean(live.original.failure) && !motion.failure;
    write(badge, `◐ ${say("live.changed")}`);
    for (const button of [reset, copied]) button.hidden = !changed;
    const quiet = !changed && live.sound && !motion.failure;
    bar.toggleAttribute("hidden", quiet && !live.undoable);
    undo.hidden = !live.undoable;
    back.hidden = !motion.failure || !live.closed;
    lines.hidden = !changed;
    line.hidden = quiet;
    line.classList.toggle("bad", Boolean(motion.failure) || !live.sound);
    clearTimeout(waiting);
    waiting = window.setTimeout(() => later(scene), 80);
  };
  return { update };
}
