// Buttons on the drawing: nearer, farther, all of it, the whole screen.

import { html, svg } from "./elements.ts";
import { CLOSER } from "./keyboard.ts";
import type { Say } from "./words.ts";

export interface ViewTools {
  /** Has the buttons show what the view is. */
  update(state: { readonly fits: boolean }): void;
}

export interface ViewToolOptions {
  readonly stage: HTMLElement;
  /** What fills the screen. */
  readonly root: HTMLElement;
  readonly say: Say;
  readonly zoom: (factor: number) => void;
  readonly fit: () => void;
}

const SIGNS = {
  in: "M8 3v10M3 8h10",
  out: "M3 8h10",
  full: "M2.5 6V2.5H6M10 2.5h3.5V6M13.5 10v3.5H10M6 13.5H2.5V10",
};

export function viewTools({ stage, root, say, zoom, fit }: ViewToolOptions): ViewTools {
  const bar = html("div", { class: "lw-tools", role: "group", "aria-label": say("view") }, stage);
  const button = (label: string, act: () => void, sign: string | null = null): HTMLButtonElement => {
    const made = html("button", { type: "button", title: label, ...(sign ? { "aria-label": label } : {}) }, bar);
    if (sign) svg("path", { d: sign }, svg("svg", { viewBox: "0 0 16 16", "aria-hidden": "true" }, made));
    made.addEventListener("click", act);
    return made;
  };
  button(say("zoom_in"), () => zoom(CLOSER), SIGNS.in);
  button(say("zoom_out"), () => zoom(1 / CLOSER), SIGNS.out);
  const all = button(say("fit_all"), fit);
  all.textContent = say("fit");
  if (document.fullscreenEnabled) {
    const inside = (): boolean => document.fullscreenElement === root;
    const full = button(
      say("full_screen"),
      () => void (inside() ? document.exitFullscreen() : root.requestFullscreen()).catch(() => {}),
      SIGNS.full,
    );
    full.setAttribute("aria-pressed", "false");
    root.addEventListener("fullscreenchange", () => full.setAttribute("aria-pressed", String(inside())));
  }
  return { update: ({ fits }) => all.classList.toggle("lw-idle", fits) };
}
