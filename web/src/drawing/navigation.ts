// Zooming and panning a drawing: wheel with Ctrl, two fingers, dragging its empty ground, a double click.

import type { Point } from "../scene/data.ts";
import { onPicture } from "./pick.ts";

export interface Navigated {
  readonly picture: SVGSVGElement;
  /** Nearer by a factor about a place of the drawing. */
  readonly zoom: (at: Point, factor: number) => void;
  readonly pan: (by: Point) => void;
  readonly fit: () => void;
  /** Whether a drag of the ground pans, and a wheel alone zooms. */
  readonly free: () => boolean;
  readonly alone: () => boolean;
  /** Whether something else lies at a place of the window that is dragged. */
  readonly taken: (event: PointerEvent) => boolean;
}

export function navigation({ picture, zoom, pan, fit, free, alone, taken }: Navigated): void {
  const fingers = new Map<number, Point>();
  let dragged: { id: number; at: Point } | null = null;
  const at = (event: MouseEvent): Point => onPicture(picture, event.clientX, event.clientY);
  picture.addEventListener(
    "wheel",
    (event) => {
      if (!event.ctrlKey && !event.metaKey && !alone()) return;
      event.preventDefault();
      const lines = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? 20 : 1;
      // A pinch on a touchpad comes as small steps, a wheel's notch as one of about 100.
      zoom(at(event), Math.exp(-Math.max(-100, Math.min(event.deltaY * lines, 100)) * 0.003));
    },
    { passive: false },
  );
  picture.addEventListener("dblclick", fit);
  picture.addEventListener("pointerdown", (event) => {
    if (event.pointerType === "touch") {
      fingers.set(event.pointerId, at(event));
      if (fingers.size === 2) dragged = null;
    }
    const sideways = event.button === 1 || (event.button === 0 && event.shiftKey);
    const ground = event.button === 0 && free() && !taken(event);
    if (fingers.size > 1 || !(sideways || ground)) return;
    event.preventDefault();
    dragged = { id: event.pointerId, at: at(event) };
    picture.setPointerCapture(event.pointerId);
    picture.classList.add("lw-panning");
  });
  picture.addEventListener("pointermove", (event) => {
    const here = at(event);
    if (fingers.size === 2 && fingers.has(event.pointerId)) pinch(event.pointerId, here);
    else if (dragged?.id === event.pointerId) {
      if (!event.buttons) return end(event);
      pan([here[0] - dragged.at[0], here[1] - dragged.at[1]]);
      dragged.at = here;
    }
    if (fingers.has(event.pointerId)) fingers.set(event.pointerId, here);
  });
  const pinch = (id: number, here: Point): void => {
    const before = fingers.get(id)!;
    const [, other] = [...fingers].find(([each]) => each !== id)!;
    const apart = (place: Point): number => Math.hypot(place[0] - other[0], place[1] - other[1]) || 1;
    const middle = (place: Point): Point => [(place[0] + other[0]) / 2, (place[1] + other[1]) / 2];
    const [from, to] = [middle(before), middle(here)];
    pan([to[0] - from[0], to[1] - from[1]]);
    zoom(to, apart(here) / apart(before));
  };
  const end = (event: PointerEvent): void => {
    fingers.delete(event.pointerId);
    if (dragged?.id !== event.pointerId) return;
    dragged = null;
    picture.classList.remove("lw-panning");
  };
  for (const kind of ["pointerup", "pointercancel", "lostpointercapture"] as const) picture.addEventListener(kind, end);
}
