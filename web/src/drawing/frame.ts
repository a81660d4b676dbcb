// The box that holds a drawing, with its styles.

import { html, svg } from "./elements.ts";
import { STYLE } from "./styles.ts";
import type { Say } from "./words.ts";

export interface Frame {
  readonly root: HTMLDivElement;
  /** Holds the drawing and what lies on it. */
  readonly stage: HTMLDivElement;
  readonly drawing: SVGSVGElement;
}

/** An empty drawing in place of what is in `el`. */
export function frame(el: Element, say: Say): Frame {
  const root = html("div", { class: "lw" });
  if (STYLE) html("style", {}, root, STYLE);
  const stage = html("div", { class: "lw-stage" }, root);
  const drawing = svg("svg", { class: "lw-drawing", role: "img", "aria-label": say("drawing") }, stage);
  el.replaceChildren(root);
  return { root, stage, drawing };
}
