// The row of what a drawing shows besides the mechanism: arrows by kind with their scales, dimensions, names.

import { keyOf, kindNames } from "./arrow_keys.ts";
import { ARROW_KINDS } from "./arrows.ts";
import { check } from "./check.ts";
import { html, svg } from "./elements.ts";
import type { Seen } from "./seen.ts";
import type { Facts } from "./survey.ts";
import { filled, type Say } from "./words.ts";

export interface ShowRow {
  /** Keys of the scales follow the drawing's width. */
  update(facts: Facts, width: number): void;
}

/** `seen` is changed by the row; `changed` is called after that. */
export function showRow(root: Element, facts: Facts, seen: Seen, say: Say, changed: () => void): ShowRow {
  const names = kindNames(say);
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
    const round = kind === "moment";
    const label = filled(say(round ? "arrow_radius" : "arrow_length"), { name: names[kind] });
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
      const found = keyOf(now, kind, factor, width);
      if (!found) continue;
      arrow.setAttribute("d", found.path);
      arrow.setAttribute("transform", `translate(0 ${found.high / 2})`);
      key.setAttribute("width", String(Math.ceil(found.pixels)));
      key.setAttribute("height", String(Math.ceil(found.high)));
      text.textContent = found.text;
    }
  };
  return { update };
}
