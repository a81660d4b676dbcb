// The whole drawing, layer upon layer.

import { clamp } from "../scene/numbers.ts";
import { arrows } from "./arrows.ts";
import { backdrop } from "./backdrop.ts";
import { bodies } from "./bodies.ts";
import { type Camera, HOME, through } from "./camera.ts";
import { thinned } from "./crowding.ts";
import { dimensionLines } from "./dimension_lines.ts";
import { set, shown, svg, write } from "./elements.ts";
import { type Labels, labels } from "./labels.ts";
import { openings } from "./openings.ts";
import { areas, centrodes, traces } from "./paths.ts";
import { pinCircles } from "./pin_circles.ts";
import { put, refilled } from "./reused.ts";
import { type Seen, usual } from "./seen.ts";
import { springs } from "./springs.ts";
import type { Box, Facts } from "./survey.ts";
import { fit, type Move, sameView, type View } from "./view.ts";
import type { Say } from "./words.ts";

/** A drawing that `show` moves to sample k + f, with the groups that can be switched. */
export interface Picture {
  readonly show: Move;
  readonly areas: readonly SVGGElement[];
  readonly traces: readonly SVGGElement[];
}

export interface Size {
  readonly width: number;
  /** The most that it may be high. */
  readonly most: number;
  /** The least that it may be high, if that isn't as usual. */
  readonly least?: number;
  readonly camera?: Camera;
  readonly seen?: Seen;
  /** Which centrodes are to be seen. */
  readonly rolling?: readonly boolean[];
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
  /** The view that fits all, on which the camera is. */
  readonly fitted: View;
  readonly original: Original | null;
  /** On which side of its pin each name stands. */
  readonly directions: Labels["directions"];
}

interface Original {
  readonly facts: Facts;
  readonly group: SVGGElement;
  readonly move: Move;
}

/** Fills `root` anew. `ghosts`: samples drawn faintly. */
export const draw = (
  root: SVGSVGElement,
  facts: Facts,
  size: Size,
  say: Say,
  ghosts: readonly number[] = [],
): Drawn => refilled(root, () => filled(root, facts, size, say, ghosts));

function filled(
  root: SVGSVGElement,
  facts: Facts,
  { width, most, least, box, camera = HOME, seen = usual(), rolling = [], original = null, before = null }: Size,
  say: Say,
  ghosts: readonly number[],
): Drawn {
  const fitted = fit(facts, width, most, box, least);
  const view = through(fitted, camera);
  const r = clamp(width / 90, 4.5, 7);
  set(root, "viewBox", `0 0 ${view.width} ${view.height}`);
  backdrop(facts, view, svg("g", {}, root));
  const behind = areas(facts, view, root);
  for (const sample of ghosts) bodies(facts, view, r, svg("g", { class: "lw-ghost" }, root))(sample, 0);
  const compared = original && originalOf(original, view, r, before);
  if (compared) put(compared.group, root);
  const paths = traces(facts, view, root);
  const rolled = centrodes(facts, view, rolling, root);
  const layer = (name: string) => svg("g", { class: name }, root);
  const moves = [
    compared?.move ?? (() => {}),
    paths.move,
    rolled,
    bodies(facts, view, r, svg("g", {}, root)),
    springs(facts, view, r, root),
    pinCircles(facts, view, r, root),
    openings(facts, view, svg("g", {}, root)),
    arrows(facts, view, seen.arrows, layer("lw-arrows")),
  ];
  const lengths = seen.dimensions ? dimensionLines(facts, original, view, layer("lw-dimensions")) : null;
  const names = labels(facts, view, r, layer("lw-labels"), original ? before?.directions : undefined);
  if (lengths) moves.push(lengths.move);
  moves.push(names.move);
  const [pins, links] = [seen.points ? names.pins : [], seen.links ? names.links : []];
  for (const { text } of [...(seen.points ? [] : names.pins), ...(seen.links ? [] : names.links)]) shown(text, false);
  const thin = thinned([...pins, ...(lengths?.texts ?? []), ...links]);
  const note = svg("text", { class: "lw-note", x: width / 2, y: 24, "text-anchor": "middle" }, root);
  write(note, say("not_assembled"));
  const show: Move = (sample, f) => {
    for (const move of moves) move(sample, f);
    thin();
    shown(note, Boolean(facts.gaps[sample] || (f && facts.gaps[sample + 1])));
  };
  const groups = { areas: behind, traces: paths.groups };
  return { show, view, fitted, original: compared, ...groups, directions: names.directions };
}

/** The mechanism as it was, and the paths of its points. */
function originalOf(facts: Facts, view: View, r: number, before: Drawn | null): Original {
  if (before && sameView(before.view, view) && before.original?.facts === facts) return before.original;
  const group = svg("g", { class: "lw-original" });
  traces(facts, view, group);
  return { facts, group, move: bodies(facts, view, r, group) };
}
