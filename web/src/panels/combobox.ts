// An entry with a list below it that shrinks to what fits, by mouse and by keyboard.

import { html } from "../drawing/elements.ts";

/** How many options are shown at most. */
const MOST = 60;

export interface Option {
  readonly name: string;
  readonly detail: string;
}

export interface ComboboxOptions<O extends Option> {
  readonly label: string;
  /** What stands where nothing fits. */
  readonly none: string;
  /** What fits a query. */
  readonly found: (query: string) => readonly O[];
  readonly chosen: (option: O) => void;
  /** Escape, with an empty entry. */
  readonly left?: () => void;
}

let count = 0;

export function combobox<O extends Option>(
  parent: Element,
  { label, none, found, chosen, left }: ComboboxOptions<O>,
): HTMLInputElement {
  const id = `options-${count++}`;
  const box = html("span", { class: "combobox" }, parent);
  const entry = html("input", {
    type: "text",
    role: "combobox",
    placeholder: label,
    "aria-label": label,
    "aria-autocomplete": "list",
    "aria-expanded": "false",
    "aria-controls": id,
    autocomplete: "off",
    spellcheck: "false",
  }, box);
  const list = html("ul", { id, role: "listbox", "aria-label": label, hidden: "" }, box);
  let options: readonly O[] = [];
  let at = -1;
  const point = (to: number): void => {
    at = options.length ? (to + options.length) % options.length : -1;
    [...list.children].forEach((each, i) => each.setAttribute("aria-selected", String(i === at)));
    if (at >= 0) entry.setAttribute("aria-activedescendant", `${id}-${at}`);
    else entry.removeAttribute("aria-activedescendant");
    list.children[at]?.scrollIntoView({ block: "nearest" });
  };
  const unpoint = (): void => {
    at = -1;
    entry.removeAttribute("aria-activedescendant");
    list.scrollTop = 0;
  };
  const close = (): void => {
    list.hidden = true;
    entry.setAttribute("aria-expanded", "false");
    entry.removeAttribute("aria-activedescendant");
  };
  const choose = (option: O | undefined): void => {
    if (!option) return;
    entry.value = "";
    close();
    chosen(option);
  };
  const open = (): void => {
    options = found(entry.value).slice(0, MOST);
    list.replaceChildren();
    options.forEach((option, i) => {
      const item = html("li", { id: `${id}-${i}`, role: "option" }, list);
      html("span", {}, item, option.name);
      html("span", { class: "note" }, item, option.detail);
      // Before the entry loses the focus.
      item.addEventListener("pointerdown", (event) => event.preventDefault());
      item.addEventListener("click", () => choose(option));
    });
    if (!options.length) html("li", { class: "note", role: "presentation" }, list, none);
    list.hidden = false;
    entry.setAttribute("aria-expanded", "true");
    // Nothing is chosen until something is asked for.
    if (entry.value) point(0);
    else unpoint();
  };
  entry.addEventListener("input", open);
  entry.addEventListener("focus", open);
  entry.addEventListener("click", () => list.hidden && open());
  entry.addEventListener("blur", close);
  entry.addEventListener("keydown", (event) => {
    const { key } = event;
    if (key === "ArrowDown" || key === "ArrowUp") {
      if (list.hidden) open();
      point(key === "ArrowDown" ? at + 1 : at < 0 ? -1 : at - 1);
    } else if (key === "Enter") {
      if (!list.hidden) choose(options[at]);
    } else if (key === "Escape") {
      if (!list.hidden && entry.value) entry.value = "";
      else left?.();
      close();
    } else return;
    event.preventDefault();
  });
  return entry;
}
