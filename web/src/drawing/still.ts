// One pose with faint others, for paper.

import type { Scene, Texts } from "../scene/data.ts";
import { arrowKeys } from "./arrow_keys.ts";
import { frame } from "./frame.ts";
import { draw } from "./picture.ts";
import { type Seen, usual } from "./seen.ts";
import { survey } from "./survey.ts";
import { speaker } from "./words.ts";

export interface StillOptions {
  readonly model: Scene;
  readonly el: Element;
  readonly words?: Texts;
  readonly width?: number;
  readonly height?: number;
  readonly ghosts?: number;
  readonly seen?: Seen;
}

/** Draws the scene once, at its first pose that can be assembled, with `ghosts` faint poses over the motion. */
export function still(options: StillOptions): SVGSVGElement {
  const { model, el, words = {}, width = 690, height = 430, ghosts = 8, seen = usual() } = options;
  const say = speaker(words);
  const facts = survey(model);
  const sound = [...facts.times.keys()].filter((k) => !facts.gaps[k]);
  const count = Math.max(Math.min(ghosts, sound.length - 1), 0);
  const faint = Array.from({ length: count }, (_, i) => sound[Math.floor(((i + 1) * sound.length) / (count + 1))]!);
  const { drawing } = frame(el, say);
  const { show, view } = draw(drawing, facts, { width, most: height, seen }, say, faint);
  arrowKeys(facts, view, seen.arrows, say, drawing);
  show(sound[0] ?? 0, 0);
  return drawing;
}
