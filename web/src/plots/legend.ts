// One button per curve: shows its line and its value at the cursor, and hides or shows it.

import { html, svg } from "../drawing/elements.ts";
import { colourName, dash } from "./looks.ts";

export interface Entry {
  readonly name: string;
  /** Of a plot with two units. */
  readonly unit: string;
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
  return entries.map(({ name, unit }, i) => {
    const item = html("span", { class: "entry" }, box);
    const button = html("button", { type: "button", "aria-pressed": "true" }, item);
    button.append(swatch(i));
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

function swatch(i: number): SVGSVGElement {
  const drawing = svg("svg", { viewBox: "0 0 26 8", "aria-hidden": "true" });
  const line = svg("path", { d: "M0 4H26", "stroke-dasharray": dash(i).join(" ") }, drawing);
  line.style.stroke = `var(--lw-${colourName(i)})`;
  return drawing;
}
