// One button per curve: shows its line and its value at the cursor, and hides or shows it.

import { html, svg } from "../drawing/elements.ts";
import { colourOf, dashOf } from "./looks.ts";
import "./of_studies.ts";
import { type Look, OPACITY } from "./outline.ts";

export interface Entry {
  readonly name: string;
  /** Of a plot with two units. */
  readonly unit: string;
  readonly look?: Look | undefined;
}

export interface LegendOptions {
  /** Hides or shows a curve. */
  readonly toggle: (curve: number, show: boolean) => void;
  /** The button that removes a curve from its plot, if a reader may. */
  readonly remove?: ((curve: number) => { readonly label: string; readonly act: () => void }) | undefined;
}

/** Fills the box; gives the places of the values. */
export function legend(
  box: Element,
  entries: readonly Entry[],
  { toggle, remove }: LegendOptions,
): HTMLOutputElement[] {
  box.replaceChildren();
  return entries.map((entry, i) => {
    const { name, unit } = entry;
    const item = html("span", { class: "entry" }, box);
    const button = html("button", { type: "button", "aria-pressed": "true" }, item);
    button.append(swatch(entry, i));
    html("span", {}, button, name);
    const value = html("output", { "aria-live": "off" }, button);
    if (unit) html("span", { class: "unit" }, button, unit);
    button.addEventListener("click", () => {
      const show = button.getAttribute("aria-pressed") !== "true";
      button.setAttribute("aria-pressed", String(show));
      toggle(i, show);
    });
    const removal = remove?.(i);
    if (removal) {
      const { label, act } = removal;
      const named = { type: "button", class: "remove screen", "aria-label": label, title: label };
      html("button", named, item, "×").addEventListener("click", act);
    }
    return value;
  });
}

/** What a curve looks like, in small. */
export function swatch(entry: Pick<Entry, "look">, i: number): SVGSVGElement {
  const { look } = entry;
  const drawing = svg("svg", { viewBox: "0 0 26 8", "aria-hidden": "true" });
  const colour = `var(--lw-${colourOf(entry, i)})`;
  if (!globalThis.WITHOUT_STUDIES && look && look.kind !== "line") {
    const place = look.kind === "dots" ? "M13 1a3 3 0 1 0 .01 0Z" : "M0 0H26V8H0Z";
    const shape = svg("path", { d: place, class: "filled", opacity: OPACITY[look.kind] }, drawing);
    shape.style.fill = colour;
    return drawing;
  }
  const line = svg("path", { d: "M0 4H26", "stroke-dasharray": dashOf(entry, i).join(" ") }, drawing);
  line.style.stroke = colour;
  return drawing;
}
