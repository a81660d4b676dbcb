// The tools in the head of a plot: fold, view, overlay, files, remove.

import { html, svg } from "../drawing/elements.ts";
import type { Say } from "../drawing/words.ts";
import { combobox } from "../panels/combobox.ts";
import { found } from "../panels/found.ts";
import { type Card, joins } from "./card.ts";
import { type Choice, overlaid, type View, viewOf } from "./choice.ts";
import type { Entries } from "./entries.ts";
import type { FileKind } from "./files.ts";
import type { Signals } from "./signals.ts";
import { areVectors } from "./vectors.ts";

const VIEWS = ["components", "magnitude", "polar"] as const;
const FILES = ["csv", "png", "svg"] as const;
/** Signs of buttons, drawn: few fonts have them. */
const SIGNS = { overlay: "M9 3v12M3 9h12", save: "M9 2v9M5 8l4 4 4-4M3 15h12", remove: "M4 4l10 10M14 4L4 14" };

/** All of it: four corners. */
export const WHOLE = "M3 7V3h4M11 3h4v4M15 11v4h-4M7 15H3v-4";

export interface ToolsOptions {
  readonly signals: Signals;
  readonly say: Say;
  readonly entries: Entries | null;
  /** A reader chose something; null where nothing can be chosen. */
  readonly edited: ((choice: Choice) => void) | null;
  readonly removed: () => void;
  readonly save: (kind: FileKind) => void;
}

export interface Tools {
  update(): void;
}

export function tools(card: Card, { signals, say, entries, edited, removed, save }: ToolsOptions): Tools {
  const head = found<HTMLElement>("figcaption", card.box);
  const fold = edited ? folder(head, card, edited) : null;
  const bar = html("span", { class: "plot-tools screen" }, head);
  const view = html("select", { "aria-label": say("plots.view") }, bar);
  const names: Record<View, string> = {
    components: say("plots.components"),
    magnitude: say("plots.magnitude"),
    polar: say("plots.polar"),
  };
  for (const each of VIEWS) html("option", { value: each }, view, names[each]);
  const choose = (choice: Choice): void => (edited ? edited(choice) : card.update(choice));
  view.addEventListener("change", () => {
    choose({ ...card.choice, view: view.value as View });
    update();
  });
  if (edited && entries) {
    const add = button(bar, say("plots.overlay"), SIGNS.overlay);
    add.addEventListener("click", () => {
      if (card.box.querySelector(".overlay")) return card.box.querySelector(".overlay")!.remove();
      const box = html("div", { class: "overlay screen" });
      head.after(box);
      const able = joins(card.choice, signals);
      const entry = combobox(box, {
        label: say("plots.overlay"),
        none: say("plots.no_match"),
        found: (query) => entries.found(query).filter(({ signals: of }) => of.every(able)),
        chosen({ signals: of }) {
          box.remove();
          edited({ ...overlaid(card.choice, of), open: true });
          add.focus();
        },
        left() {
          box.remove();
          add.focus();
        },
      });
      entry.focus();
    });
  }
  menu(bar, say("plots.export"), save);
  if (edited) {
    const gone = button(bar, say("plots.remove"), SIGNS.remove);
    gone.classList.add("remove");
    gone.addEventListener("click", removed);
  }
  const update = (): void => {
    const { choice } = card;
    view.hidden = !areVectors(choice.signals) || !choice.open;
    view.value = viewOf(choice);
    fold?.setAttribute("aria-expanded", String(choice.open));
  };
  update();
  return { update };
}

/** Makes the title a button that folds the plot. */
function folder(head: HTMLElement, card: Card, edited: (choice: Choice) => void): HTMLButtonElement {
  const made = html("button", { type: "button", class: "fold" });
  made.append(...head.childNodes);
  head.append(made);
  made.addEventListener("click", () => edited({ ...card.choice, open: !card.choice.open }));
  return made;
}

/** A button with a sign; `label` is what it does. */
export function button(bar: Element, label: string, sign: string): HTMLButtonElement {
  const made = html("button", { type: "button", "aria-label": label, title: label }, bar);
  picture(made, sign);
  return made;
}

const picture = (parent: Element, d: string): void => {
  svg("path", { d }, svg("svg", { viewBox: "0 0 18 18", "aria-hidden": "true" }, parent));
};

/** The files of a plot; `kinds` are those that it has. */
export function menu(
  bar: Element,
  label: string,
  save: (kind: FileKind) => void,
  kinds: readonly FileKind[] = FILES,
): void {
  const box = html("details", { class: "menu" }, bar);
  picture(html("summary", { "aria-label": label, title: label }, box), SIGNS.save);
  const list = html("span", {}, box);
  for (const kind of kinds) {
    html("button", { type: "button" }, list, kind.toUpperCase()).addEventListener("click", () => {
      box.open = false;
      save(kind);
    });
  }
  const close = (): void => {
    box.open = false;
  };
  box.addEventListener("keydown", ({ key }) => {
    if (key !== "Escape") return;
    close();
    box.querySelector("summary")!.focus();
  });
  box.addEventListener("focusout", ({ relatedTarget }) => {
    if (relatedTarget instanceof Node && !box.contains(relatedTarget)) close();
  });
  document.addEventListener("pointerdown", ({ target }) => {
    if (box.open && !box.contains(target as Node)) close();
  });
}
