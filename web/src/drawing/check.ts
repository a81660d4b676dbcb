// Boxes to tick, one by one or many to choose from.

import { html } from "./elements.ts";
import type { Say } from "./words.ts";

/** Above this many entries a list is folded and can be searched. */
const FEW = 8;

export interface Entry {
  readonly name: string;
  readonly colour: string;
  readonly checked: boolean;
}

/** A box to tick, before its label and, if there is one, a swatch of a colour. */
export function check(parent: Element, text: string, checked = true, colour: string | null = null): HTMLInputElement {
  const label = html("label", {}, parent);
  const box = html("input", { type: "checkbox" }, label);
  box.checked = checked;
  if (colour !== null) html("span", { class: `lw-swatch ${colour}` }, label);
  label.append(text);
  return box;
}

/** A group of boxes, one an entry; of many a folded list with a search. */
export function choices(parent: Element, title: string, entries: readonly Entry[], say: Say): HTMLInputElement[] {
  if (entries.length > FEW) return chooser(parent, title, entries, say);
  const group = html("span", { class: "lw-paths", role: "group", "aria-label": title }, parent);
  if (entries.length) html("span", {}, group, title);
  return entries.map(({ name, colour, checked }) => check(group, name, checked, colour));
}

function chooser(parent: Element, title: string, entries: readonly Entry[], say: Say): HTMLInputElement[] {
  const details = html("details", { class: "lw-chooser" }, parent);
  const summary = html("summary", {}, details);
  const panel = html("div", { role: "group", "aria-label": title }, details);
  const label = say("find_name");
  const search = html("input", { type: "search", placeholder: label, "aria-label": label }, panel);
  const list = html("div", { class: "lw-list" }, panel);
  const boxes = entries.map(({ name, colour, checked }) => check(list, name, checked, colour));
  const count = (): void => {
    summary.textContent = `${title} ${boxes.filter((box) => box.checked).length}/${boxes.length}`;
  };
  const found = (i: number): boolean => entries[i]!.name.toLowerCase().includes(search.value.trim().toLowerCase());
  search.addEventListener("input", () => {
    boxes.forEach((box, i) => box.parentElement!.classList.toggle("lw-hidden", !found(i)));
  });
  const all = (text: string, checked: boolean): void => {
    const button = html("button", { type: "button" }, panel, text);
    button.addEventListener("click", () => {
      boxes.forEach((box, i) => found(i) && (box.checked = checked));
      for (const box of boxes) box.dispatchEvent(new Event("change", { bubbles: true }));
    });
  };
  all(say("choose_all"), true);
  all(say("choose_none"), false);
  list.addEventListener("change", count);
  details.addEventListener("keydown", (event) => {
    if (event.key !== "Escape") return;
    details.open = false;
    summary.focus();
  });
  count();
  return boxes;
}
