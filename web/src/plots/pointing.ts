// Pointing into a plot: the mechanism goes to that time; a mouse drag enlarges a span; a double click ends that.

import type uPlot from "uplot";
import { clamp } from "../scene/numbers.ts";
import type { Held } from "./held.ts";

/** Pixels that tell a drag from a click. */
const DRAG = 6;

export interface Pointed extends Held {
  goTo(time: number): void;
  zoom(from: number, to: number): void;
  unzoom(): void;
}

export function pointing(uplot: uPlot, pointed: Pointed): void {
  const { over } = uplot;
  const position = (event: PointerEvent): number => {
    const { left, width } = over.getBoundingClientRect();
    return clamp(event.clientX - left, 0, width);
  };
  const goTo = (event: PointerEvent): void => pointed.goTo(uplot.posToVal(position(event), "x"));
  let start: number | null = null; // where a mouse drag began, in pixels
  /** The span of a drag, if it is one. */
  const span = (event: PointerEvent): { left: number; width: number } | null => {
    if (start === null) return null;
    const here = position(event);
    const width = Math.abs(here - start);
    return width > DRAG ? { left: Math.min(start, here), width } : null;
  };
  const select = (left: number, width: number): void =>
    uplot.setSelect({ left, width, top: 0, height: over.clientHeight }, false);

  over.addEventListener("pointermove", (event) => {
    if (event.pointerType !== "mouse" && !event.buttons) return;
    pointed.hold();
    goTo(event);
    if (start === null) return;
    const dragged = span(event);
    select(dragged?.left ?? start, dragged?.width ?? 0);
  });
  over.addEventListener("pointerdown", (event) => {
    if (event.button !== 0) return;
    pointed.hold();
    goTo(event);
    if (event.pointerType === "mouse") {
      over.setPointerCapture(event.pointerId);
      start = position(event);
    } else pointed.keep();
  });
  over.addEventListener("pointerup", (event) => {
    const dragged = span(event);
    if (dragged) {
      const { left, width } = dragged;
      pointed.zoom(uplot.posToVal(left, "x"), uplot.posToVal(left + width, "x"));
    } else pointed.keep();
    start = null;
    select(0, 0);
  });
  over.addEventListener("pointerleave", () => {
    if (start === null) pointed.release();
  });
  over.addEventListener("pointercancel", () => {
    start = null;
    pointed.drop();
    select(0, 0);
  });
  over.addEventListener("dblclick", () => pointed.unzoom());
}
