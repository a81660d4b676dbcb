// The whole drawing, layer upon layer.

import { clamp } from "../scene/numbers.ts";
import { backdrop } from "./backdrop.ts";
import { bodies } from "./bodies.ts";
import { shown, svg } from "./elements.ts";
import { labels } from "./labels.ts";
import { openings } from "./openings.ts";
import { areas, centrodes, traces } from "./paths.ts";
import { pinCircles } from "./pin_circles.ts";
import { springs } from "./springs.ts";
import type { Box, Facts } from "./survey.ts";
import { fit, type Move, type View } from "./view.ts";
import type { Say } from "./words.ts";

/** A drawing that `show` moves to sample k + f, with the groups that can be switched. */
export interface Picture {
  readonly show: Move;
  readonly areas: readonly SVGGElement[];
  readonly traces: readonly SVGGElement[];
  readonly centrodes: readonly SVGGElement[];
}

export interface Size {
  readonly width: number;
  /** The most that it may be high. */
  readonly most: number;
  /** What of the world is to be seen, if not all the motion. */
  readonly box?: Box;
  /** What is to be compared with, as it was: a faint drawing behind. */
  readonly original?: Facts | null;
  /** The drawing of before, of which that is taken over where it is the same. */
  readonly before?: Drawn | null;
}

/** A drawing that `show` moves, and how the world lies on its screen. */
export interface Drawn extends Picture {
  readonly view: View;
  readonly original: Original | null;
}

interface Original {
  readonly facts: Facts;
  readonly group: SVGGElement;
  readonly move: Move;
}

/** Fills `root` anew. `ghosts`: samples drawn faintly. */
export function draw(
  root: SVGSVGElement,
  facts: Facts,
  { width, most, box, original = null, before = null }: Size,
  say: Say,
  ghosts: readonly number[] = [],
): Drawn {
  const view = fit(facts, width, most, box);
  const r = clamp(width / 90, 4.5, 7);
  root.replaceChildren();
  root.setAttribute("viewBox", `0 0 ${view.width} ${view.height}`);
  backdrop(facts, view, svg("g", {}, root));
  const behind = areas(facts, view, root);
  for (const sample of ghosts) bodies(facts, view, r, svg("g", { class: "lw-ghost" }, root))(sample, 0);
  const compared = original && originalOf(original, view, r, before);
  if (compared) root.append(compared.group);
  const paths = traces(facts, view, root);
  const rolling = centrodes(facts, view, root);
  const moves = [
    compared?.move ?? (() => {}),
    paths.move,
    rolling.move,
    bodies(facts, view, r, svg("g", {}, root)),
    springs(facts, view, r, root),
    pinCircles(facts, view, r, root),
    openings(facts, view, svg("g", {}, root)),
    labels(facts, view, r, svg("g", { class: "lw-labels" }, root)),
  ];
  const note = svg("text", { class: "lw-note", x: width / 2, y: 24, "text-anchor": "middle" }, root);
  note.textContent = say("not_assembled");
  const show: Move = (sample, f) => {
    for (const move of moves) move(sample, f);
    shown(note, Boolean(facts.gaps[sample] || (f && facts.gaps[sample + 1])));
  };
  return { show, view, original: compared, areas: behind, traces: paths.groups, centrodes: rolling.groups };
}

/** The mechanism as it was, and the paths of its points. */
function originalOf(facts: Facts, view: View, r: number, before: Drawn | null): Original {
  const kept = before?.original;
  const { k, width, height } = before?.view ?? { k: 0, width: 0, height: 0 };
  if (kept?.facts === facts && k === view.k && width === view.width && height === view.height) return kept;
  const group = svg("g", { class: "lw-original" });
  traces(facts, view, group);
  return { facts, group, move: bodies(facts, view, r, group) };
}
