// Lines that are told apart in light, in dark and in black and white.

import { html } from "../drawing/elements.ts";
import type { Look } from "./outline.ts";

const DASHES = [[], [7, 3], [2, 3], [10, 3, 2, 3], [5, 2, 1, 2, 1, 2]] as const;
const COLOURS = 8;

/** The dashes of the i-th curve, in pixels. */
export const dash = (i: number): readonly number[] => DASHES[i % DASHES.length]!;

/** The name of the i-th curve's colour among those of drawings. */
export const colourName = (i: number): string => `c${i % COLOURS}`;

type Drawn = { readonly look?: Look | undefined };

/** The colour's name and the dashes of a curve: those of its look, else of its number. */
export const colourOf = ({ look }: Drawn, i: number): string => look?.colour ?? colourName(i);
export const dashOf = ({ look }: Drawn, i: number): readonly number[] => dash(look?.dash ?? i);

/** A colour #rrggbb with an opacity. */
export const faded = (colour: string, opacity: number): string =>
  opacity < 1 && colour.length === 7 ? colour + Math.round(255 * opacity).toString(16).padStart(2, "0") : colour;

/** A colour of drawings by its name, as it is at the moment. */
export type Colour = (name: string) => string;

/** The colours that hold at an element. They are looked up once for each theme: a look-up takes as long as a curve. */
export function coloursAt(element: Element): Colour {
  const media = ["(prefers-color-scheme: dark)", "print"].map((query) => matchMedia(query));
  const themes = new Map<string, Map<string, string>>();
  return (name) => {
    const theme = [document.documentElement.dataset["theme"], ...media.map(({ matches }) => matches)].join();
    const colours = themes.get(theme) ?? new Map<string, string>();
    themes.set(theme, colours);
    let colour = colours.get(name);
    if (colour === undefined) {
      colour = getComputedStyle(element).getPropertyValue(`--lw-${name}`).trim();
      colours.set(name, colour);
    }
    return colour;
  };
}

/** The colours in light, whatever the page's are. */
export function lightColours(): Colour {
  const outer = html("div", { "data-theme": "light", hidden: "" }, document.body);
  const style = getComputedStyle(html("div", { class: "lw" }, outer));
  const found = new Map<string, string>();
  const curves = Array.from({ length: COLOURS }, (_, i) => colourName(i));
  for (const name of ["ink", "muted", "paper", "line", "grid", "warn", ...curves]) {
    found.set(name, style.getPropertyValue(`--lw-${name}`).trim());
  }
  outer.remove();
  return (name) => found.get(name) ?? "";
}
