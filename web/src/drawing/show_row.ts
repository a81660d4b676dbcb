// The row of what a drawing shows besides the mechanism: arrows by kind with their scales, dimensions, names.

import type { ArrowKind } from "../scene/data.ts";
import { nice } from "../scene/numbers.ts";
import { ARROW_KINDS, arrowPath, arrowScale } from "./arrows.ts";
import { check } from "./check.ts";
import { figure } from "./dimension_lines.ts";
import { html, svg } from "./elements.ts";
import type { Seen } from "./seen.ts";
import type { Facts } from "./survey.ts";
import type { Say } from "./words.ts";

/** How long the key of a scale may be, in pixels. */
const KEY = 46;

export interface ShowRow {
  /** Keys of the scales follow the drawing's width. */
  update(facts: Facts, width: number): void;
}

/** `seen` is changed by the row; `changed` is called after that. */
export function showRow(root: Element, facts: Facts, seen: Seen, say: Say, changed: () => void): ShowRow {
  const names: Readonly<Record<ArrowKind, string>> = {
    velocity: say("arrow_velocity"),
    acceleration: say("arrow_acceleration"),
    reaction: say("arrow_reaction"),
    load: say("arrow_load"),
    weight: say("arrow_weight"),
  };
  const row = html("div", { class: "lw-options lw-show", role: "group", "aria-label": say("show") }, root);
  html("span", {}, row, say("show"));
  const switched = (box: HTMLInputElement, act: (on: boolean) => void): void =>
    box.addEventListener("change", () => {
      act(box.checked);
      changed();
    });
  switched(check(row, say("point_names"), seen.points), (on) => (seen.points = on));
  switched(check(row, say("link_names"), seen.links), (on) => (seen.links = on));
  switched(check(row, say("dimension_lines"), seen.dimensions), (on) => (seen.dimensions = on));
  const kinds = ARROW_KINDS.filter((kind) => facts.longest.has(kind)).map((kind) => {
    const group = html("span", { class: `lw-kind lw-${kind}` }, row);
    const box = check(group, names[kind], false, "");
    const scale = html("span", { class: "lw-scale-of", hidden: "" }, group);
    const label = say("arrow_length").replace("{name}", names[kind]);
    const slider = html("input", { type: "range", min: -2, max: 2, step: 0.25, value: 0, "aria-label": label }, scale);
    const key = svg("svg", { class: "lw-key", height: 10, "aria-hidden": "true" }, scale);
    const text = html("output", { "aria-live": "off" }, scale);
    const write = (): void => {
      scale.hidden = !box.checked;
      if (box.checked) seen.arrows.set(kind, 2 ** Number(slider.value));
      else seen.arrows.delete(kind);
    };
    switched(box, write);
    slider.addEventListener("input", () => {
      write();
      changed();
    });
    return { kind, arrow: svg("path", { class: `lw-arrow lw-${kind}` }, key), key, text };
  });
  const update = (now: Facts, width: number): void => {
    for (const { kind, arrow, key, text } of kinds) {
      const factor = seen.arrows.get(kind);
      if (factor === undefined) continue;
      const pixels = arrowScale(now.longest, kind, factor, width);
      const value = nice(KEY / pixels);
      arrow.setAttribute("d", arrowPath([0, 5], [pixels * value, 0]));
      key.setAttribute("width", String(Math.ceil(pixels * value)));
      text.textContent = `${figure(value)} ${now.longest.get(kind)!.unit}`;
    }
  };
  return { update };
}
