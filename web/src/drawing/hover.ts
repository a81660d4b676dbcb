// A small readout beside a point or an arrow, where the mouse is or a finger tapped. Plots have the same values: screen
// readers don't hear of it.

import type { ArrowData, Point } from "../scene/data.ts";
import { type Arrow, beginning } from "./arrows.ts";
import { figure } from "./dimension_lines.ts";
import { html } from "./elements.ts";
import type { Pin } from "./pins.ts";
import { type Quantity, readout, valueOf } from "./readout.ts";
import type { Facts } from "./survey.ts";
import type { View } from "./view.ts";
import type { Say } from "./words.ts";

/** How near to a point and to an arrow one has to be, in pixels: with a mouse, with a finger. */
const NEAR = { mouse: { pin: 12, arrow: 5 }, touch: { pin: 24, arrow: 12 } };

export interface Hover {
  /** Follows the time. */
  update(facts: Facts, view: View, k: number, f: number): void;
}

export interface HoverOptions {
  readonly stage: HTMLElement;
  readonly picture: SVGSVGElement;
  readonly say: Say;
  readonly pick: (x: number, y: number, within: number) => Pin | null;
  readonly pickArrow: (x: number, y: number, within: number) => Arrow | null;
  /** Asks for an update. */
  readonly changed: () => void;
}

/** A box's head, its place in the world and its lines: what, and the value. */
interface Told {
  readonly name: string;
  readonly at: Point;
  readonly lines: readonly (readonly [string, Quantity])[];
}

export function hover({ stage, picture, say, pick, pickArrow, changed }: HoverOptions): Hover {
  const box = html("div", { class: "lw-hover", "aria-hidden": "true", hidden: "" }, stage);
  /** The name of the point, or the arrow. */
  let chosen: string | ArrowData | null = null;
  const choose = (now: string | ArrowData | null): void => {
    if (now === chosen) return;
    chosen = now;
    changed();
  };
  const at = ({ clientX: x, clientY: y }: PointerEvent, near: (typeof NEAR)["mouse"]): string | ArrowData | null =>
    pick(x, y, near.pin)?.name ?? pickArrow(x, y, near.arrow)?.data ?? null;
  picture.addEventListener("pointermove", (event) => {
    if (event.pointerType === "mouse" && !event.buttons) choose(at(event, NEAR.mouse));
  });
  picture.addEventListener("pointerdown", (event) => {
    if (event.pointerType !== "mouse") choose(at(event, NEAR.touch));
  });
  picture.addEventListener("pointerleave", (event) => {
    if (event.pointerType === "mouse" && !event.buttons) choose(null);
  });
  const ofPoint = (facts: Facts, name: string, k: number, f: number): Told | null => {
    const pin = facts.pins.find((each) => each.name === name);
    const found = pin ? readout(facts, pin, k, f) : null;
    if (!found) return null;
    const unit = facts.scene.length_unit;
    const lines: (readonly [string, Quantity])[] = [
      ["x", { value: found.at[0], unit }],
      ["y", { value: found.at[1], unit }],
      ...(found.speed ? [[say("hover_speed"), found.speed] as const] : []),
      ...(found.reaction ? [[say("hover_reaction"), found.reaction] as const] : []),
      ...found.moments,
    ];
    return { name: found.name, at: found.at, lines };
  };
  const ofArrow = (facts: Facts, data: ArrowData, k: number, f: number): Told | null => {
    const arrow = facts.arrows.find((each) => each.data === data);
    const from = arrow ? beginning(arrow, facts.times, k, f) : null;
    const value = arrow && from ? valueOf(facts, arrow, k, f) : null;
    if (!from || !value) return null;
    return { name: data.name, at: from, lines: [[say(arrow?.y ? "hover_magnitude" : "hover_moment"), value]] };
  };
  const update: Hover["update"] = (facts, view, k, f) => {
    const said =
      chosen === null ? null : typeof chosen === "string" ? ofPoint(facts, chosen, k, f) : ofArrow(facts, chosen, k, f);
    box.hidden = !said;
    if (!said) return;
    const [x, y] = view.toScreen(said.at);
    box.replaceChildren(html("b", {}, null, said.name));
    for (const [what, value] of said.lines) {
      html("span", {}, box, what);
      html("span", {}, box, quantity(value));
    }
    // On the side with more room, as the drawing may be wider on the screen than in its own pixels.
    const share = (value: number, whole: number) => `${(value / whole) * 100}%`;
    const [right, below] = [x < view.width / 2, y < view.height / 2];
    box.style.left = right ? `calc(${share(x, view.width)} + 14px)` : "";
    box.style.right = right ? "" : `calc(${share(view.width - x, view.width)} + 14px)`;
    box.style.top = below ? `calc(${share(y, view.height)} + 10px)` : "";
    box.style.bottom = below ? "" : `calc(${share(view.height - y, view.height)} + 10px)`;
  };
  return { update };
}

const quantity = ({ value, unit }: Quantity): string => `${figure(value, 4)} ${unit}`;
