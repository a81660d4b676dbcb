// A still picture of a plane, such as that of a cam: zoom by drag, the place at the cursor, files. What moves in it
// when it is clicked goes on doing so.

import { html, svg } from "../drawing/elements.ts";
import type { Say } from "../drawing/words.ts";
import { download, fileName, png } from "../panels/download.ts";
import { found } from "../panels/found.ts";
import { clamp } from "../scene/numbers.ts";
import { figure } from "./figure.ts";
import { readout } from "./study_view.ts";
import { button, menu, WHOLE } from "./tools.ts";

const DRAG = 6;
const KINDS = ["png", "svg"] as const;

/** `picture` states its plane in data-plane: the pixels of the origin, pixels to a unit, the unit. */
export function stillPicture(box: HTMLElement, picture: SVGSVGElement, say: Say): void {
  const [unit = "", ...numbers] = (picture.dataset["plane"] ?? "").split(" ").reverse();
  const [per = 1, oy = 0, ox = 0] = numbers.map(Number);
  const { x, y, width, height } = picture.viewBox.baseVal;
  const whole = [x, y, width, height] as const;
  const caption = found<HTMLElement>("figcaption", box);
  const title = caption.firstChild?.textContent ?? "";
  caption.append(html("span", { class: "plot-tools screen" }));
  const bar = found<HTMLElement>(".plot-tools", caption);
  const outputs = readout(html("div", { class: "legend lw screen" }, box), ["x", "y"]);
  const selection = svg("rect", { class: "plane-selection" }, picture);
  const back = button(bar, say("plots.reset_zoom"), WHOLE);
  back.hidden = true;
  menu(bar, say("plots.export"), (kind) => void save(kind), KINDS);
  picture.classList.add("plane-picture");
  picture.tabIndex = 0;

  const see = (view: readonly [number, number, number, number]): void => {
    picture.setAttribute("viewBox", view.join(" "));
    back.hidden = view === whole;
  };
  const at = (event: MouseEvent): [number, number] => {
    const place = new DOMPoint(event.clientX, event.clientY).matrixTransform(picture.getScreenCTM()!.inverse());
    return [clamp(place.x, x, x + width), clamp(place.y, y, y + height)];
  };
  const show = ([px, py]: readonly [number, number]): void => {
    [(px - ox) / per, (oy - py) / per].forEach((value, i) => {
      outputs[i]!.textContent = `${figure(value)} ${unit}`.trim();
    });
  };
  const closer = (factor: number): void => {
    const view = picture.viewBox.baseVal;
    const [wide, high] = [view.width * factor, view.height * factor];
    if (wide >= width) see(whole);
    else see([view.x + (view.width - wide) / 2, view.y + (view.height - high) / 2, wide, high]);
  };
  let start: [number, number] | null = null;
  const dragged = (event: PointerEvent): DOMRect | null => {
    if (!start) return null;
    const [[px, py], [sx, sy]] = [at(event), start];
    const rect = new DOMRect(Math.min(px, sx), Math.min(py, sy), Math.abs(px - sx), Math.abs(py - sy));
    return rect.width > DRAG && rect.height > DRAG ? rect : null;
  };
  const select = (rect: DOMRect | null): void => {
    for (const key of ["x", "y", "width", "height"] as const) selection.setAttribute(key, String(rect?.[key] ?? 0));
  };
  picture.addEventListener("pointermove", (event) => {
    show(at(event));
    select(dragged(event));
  });
  picture.addEventListener("pointerdown", (event) => {
    show(at(event));
    if (event.pointerType === "mouse" && event.button === 0) start = at(event);
  });
  picture.addEventListener("pointerup", (event) => {
    const rect = dragged(event);
    start = null;
    select(null);
    if (rect) see([rect.x, rect.y, rect.width, rect.height]);
  });
  picture.addEventListener("pointerleave", () => {
    start = null;
    select(null);
  });
  picture.addEventListener("dblclick", () => see(whole));
  picture.addEventListener("keydown", ({ key }) => {
    if (key === "+" || key === "=") closer(0.5);
    else if (key === "-") closer(2);
    else if (key === "Escape") see(whole);
  });
  back.addEventListener("click", () => see(whole));

  const save = async (kind: "csv" | "png" | "svg"): Promise<void> => {
    const copy = picture.cloneNode(true) as SVGSVGElement;
    copy.querySelector(".plane-selection")?.remove();
    const { x: left, y: top, width: wide, height: high } = copy.viewBox.baseVal;
    const size = { xmlns: "http://www.w3.org/2000/svg", width: 560, height: Math.round((560 * high) / wide) };
    for (const [key, value] of Object.entries({ ...size, color: "#1d2733" })) copy.setAttribute(key, String(value));
    copy.prepend(svg("rect", { x: left, y: top, width: wide, height: high, fill: "#fff" }));
    const text = new XMLSerializer().serializeToString(copy);
    const file = kind === "svg" ? new Blob([text], { type: "image/svg+xml" }) : await png(text);
    download(`${fileName(title)}.${kind}`, file);
  };
}
