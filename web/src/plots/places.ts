// Where the plots of the report stand: among the first ones, or in the group of their kind.

import type { Choice } from "./choice.ts";

/** A plot that the page has: its figure, its title, and what it shows for those who don't see it. */
export interface Own {
  readonly box: HTMLElement;
  readonly title: string;
  readonly label: string;
  readonly choice: Choice;
}

/** The group of a figure: the place of all others of its kind; its own place where there is none. */
export const groupOf = (box: HTMLElement): Element =>
  document.querySelector(`[data-of="${box.dataset["group"]}"]`) ?? box.parentElement!;

const number = (figure: Element): number => Number((figure as HTMLElement).dataset["plot"]);

/** Puts a figure into a place: at its end, or in the order of the report. */
export function place(box: HTMLElement, into: Element, ordered: boolean): void {
  const after = ordered ? [...into.children].find((each) => number(each) > number(box)) : null;
  into.insertBefore(box, after ?? null);
}
