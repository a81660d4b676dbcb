// A study's plane on the page: the picture, the cursor with what is read there, zoom by drag, keys and Ctrl+wheel.

import { html, svg } from "../drawing/elements.ts";
import { clamp } from "../scene/numbers.ts";
import { fieldPicture } from "./field_picture.ts";
import { figure } from "./figure.ts";
import { lookOf } from "./layer_look.ts";
import { legend } from "./legend.ts";
import { lightColours } from "./looks.ts";
import { planeCsv } from "./plane_csv.ts";
import { planeFile } from "./plane_file.ts";
import { type Frame, frameOf } from "./plane_frame.ts";
import { readingAt } from "./plane_readout.ts";
import type { Drawn, PlaneSheet } from "./plane_sheet.ts";
import { heightOf, planeSvg } from "./plane_svg.ts";
import type { Plane } from "./study.ts";
import type { Box } from "./study_raw.ts";
import { readout, type StudyPlace, type StudyView } from "./study_view.ts";

const DRAG = 6;
const PAPER = 336;
const CLOSEST = 1e-4;
let pictures = 0;

export function planeView(plane: Plane, place: StudyPlace): StudyView {
  const listed = plane.layers.flatMap((layer, i) =>
    layer.kind === "field" ? [] : [{ i, name: layer.name, unit: "", look: lookOf(layer) }],
  );
  const hidden = new Set<number>();
  const shown = (i: number): boolean => !hidden.has(i);
  legend(place.legend, listed, {
    toggle(k, show) {
      const { i } = listed[k]!;
      if (show) hidden.delete(i);
      else hidden.add(i);
      draw();
    },
  });
  const valued = plane.layers.flatMap((layer) => {
    if (layer.kind === "field") return [layer.axis.name];
    return "scale" in layer && layer.scale ? [layer.scale.axis.name] : [];
  });
  const outputs = readout(place.legend, [plane.x.name, plane.y.name, ...new Set(valued)]);
  const names = [...new Set(valued)];
  const picture = svg("svg", { class: "plane-picture", role: "img", tabindex: 0, "aria-label": place.label });
  const content = svg("g", {}, picture);
  const cursor = svg("path", { class: "plane-cursor" }, picture);
  const selection = svg("rect", { class: "plane-selection" }, picture);
  html("div", { class: "plane-area lw" }, place.area).append(picture);
  const id = `plane-${pictures++}`;
  const sheet = (colour: PlaneSheet["colour"], width: number, own: string): PlaneSheet => ({
    width,
    colour,
    shown,
    id: own,
    picture: ({ field }, frame) => fieldPicture(field, frame),
  });
  let box: Box = plane.box;
  let frame: Frame;
  let at: [number, number] | null = null;
  let inSight = false;

  const draw = (): void => {
    const width = place.area.clientWidth || 400;
    const on = sheet((name) => `var(--lw-${name})`, width, id);
    frame = frameOf(plane, box, width);
    const still = (): Drawn => ({ inside: "", height: heightOf(plane, frame, on) });
    const { inside, height } = inSight ? planeSvg(plane, frame, on) : still();
    picture.setAttribute("viewBox", `0 0 ${width} ${height}`);
    content.innerHTML = inside;
    follow();
  };
  const follow = (): void => {
    cursor.setAttribute("d", "");
    if (!at) return;
    const reading = readingAt(plane, frame, at, shown);
    const [x, y] = [frame.across(reading.x), frame.up(reading.y)];
    const visible = x >= frame.left && x <= frame.right && y >= frame.top && y <= frame.bottom;
    if (visible) cursor.setAttribute("d", `M${x} ${frame.top}V${frame.bottom}M${frame.left} ${y}H${frame.right}`);
    outputs[0]!.textContent = `${figure(reading.x)} ${plane.x.unit}`.trim();
    outputs[1]!.textContent = `${figure(reading.y)} ${plane.y.unit}`.trim();
    names.forEach((name, k) => {
      outputs[2 + k]!.textContent = reading.values.find((each) => each.name === name)?.text ?? "–";
    });
  };
  const zoom = (to: Box): void => {
    const [wide, tall] = [plane.box[2] - plane.box[0], plane.box[3] - plane.box[1]];
    if (to[2] - to[0] < CLOSEST * wide && to[3] - to[1] < CLOSEST * tall) return;
    box = to[2] - to[0] >= wide && to[3] - to[1] >= tall ? plane.box : to;
    place.zoomed(box === plane.box);
    draw();
  };
  const reset = (): void => zoom(plane.box);
  /** Closer by a factor about a place. */
  const closer = (factor: number, [x, y]: readonly [number, number]): void => {
    const [x0, y0, x1, y1] = box;
    zoom([x + factor * (x0 - x), y + factor * (y0 - y), x + factor * (x1 - x), y + factor * (y1 - y)]);
  };
  const middle = (): [number, number] => [(box[0] + box[2]) / 2, (box[1] + box[3]) / 2];

  const pixel = (event: MouseEvent): [number, number] => {
    const { left, top, width } = picture.getBoundingClientRect();
    const per = (picture.viewBox.baseVal.width || width) / (width || 1);
    const [x, y] = [(event.clientX - left) * per, (event.clientY - top) * per];
    return [clamp(x, frame.left, frame.right), clamp(y, frame.top, frame.bottom)];
  };
  const goTo = (event: PointerEvent): void => {
    const [x, y] = pixel(event);
    at = [frame.x(x), frame.y(y)];
    follow();
  };
  let start: [number, number] | null = null;
  const dragged = (event: PointerEvent): { x: number; y: number; width: number; height: number } | null => {
    if (!start) return null;
    const [x, y] = pixel(event);
    const [width, height] = [Math.abs(x - start[0]), Math.abs(y - start[1])];
    return width > DRAG && height > DRAG ? { x: Math.min(x, start[0]), y: Math.min(y, start[1]), width, height } : null;
  };
  const select = (some: { x: number; y: number; width: number; height: number } | null): void => {
    for (const key of ["x", "y", "width", "height"] as const) selection.setAttribute(key, String(some?.[key] ?? 0));
  };
  picture.addEventListener("pointermove", (event) => {
    if (event.pointerType !== "mouse" && !event.buttons) return;
    goTo(event);
    select(dragged(event));
  });
  picture.addEventListener("pointerdown", (event) => {
    if (event.button !== 0) return;
    goTo(event);
    if (event.pointerType !== "mouse") return;
    picture.setPointerCapture(event.pointerId);
    start = pixel(event);
  });
  picture.addEventListener("pointerup", (event) => {
    const some = dragged(event);
    start = null;
    select(null);
    if (!some) return;
    zoom([frame.x(some.x), frame.y(some.y + some.height), frame.x(some.x + some.width), frame.y(some.y)]);
  });
  picture.addEventListener("pointercancel", () => {
    start = null;
    select(null);
  });
  picture.addEventListener("dblclick", reset);
  picture.addEventListener(
    "wheel",
    (event) => {
      if (!event.ctrlKey) return;
      event.preventDefault();
      const [x, y] = pixel(event);
      closer(event.deltaY < 0 ? 0.8 : 1.25, [frame.x(x), frame.y(y)]);
    },
    { passive: false },
  );
  draw();
  return {
    seen() {
      if (inSight) return;
      inSight = true;
      draw();
    },
    reset,
    sized() {
      if (place.area.clientWidth && place.area.clientWidth !== picture.viewBox.baseVal.width) draw();
    },
    key(key, far) {
      const step = (far ? 0.1 : 0.01) * (box[2] - box[0]);
      const rise = (far ? 0.1 : 0.01) * (box[3] - box[1]);
      const moves: Readonly<Record<string, [number, number]>> = {
        ArrowLeft: [-step, 0],
        ArrowRight: [step, 0],
        ArrowUp: [0, rise],
        ArrowDown: [0, -rise],
      };
      const move = moves[key];
      if (move) {
        const [x, y] = at ?? middle();
        at = [clamp(x + move[0], frame.box[0], frame.box[2]), clamp(y + move[1], frame.box[1], frame.box[3])];
        follow();
      } else if (key === "+" || key === "=") closer(0.5, at ?? middle());
      else if (key === "-") closer(2, at ?? middle());
      else if (key === "Escape") reset();
      else return false;
      return true;
    },
    themed() {},
    csv: () => planeCsv(plane),
    svg: (width) => planeFile(plane, box, sheet(lightColours(), Math.max(width, 480), `${id}-file`)),
    toPaper() {
      const paper = html("div", { class: "chart-paper plane-paper" });
      place.area.after(paper);
      const on = frameOf(plane, box, PAPER);
      const { inside, height } = planeSvg(plane, on, {
        ...sheet(lightColours(), PAPER, `${id}-paper`),
        picture: ({ field }) => fieldPicture(field, on, 2),
      });
      paper.innerHTML = `<svg viewBox="0 0 ${PAPER} ${height}">${inside}</svg>`;
      return () => paper.remove();
    },
    remove: () => place.area.replaceChildren(),
  };
}
