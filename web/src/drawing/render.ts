// A mechanism as an animated SVG drawing, from plain scene data:
//
//   const drawing = render({ model: scene, el, words, time, autoplay });
//   drawing.setTime(t); drawing.setIndex(i); drawing.on("time", (t, index) => ...); drawing.destroy();

import type { Point, Scene, Texts, TimeAxis } from "../scene/data.ts";
import { clamp } from "../scene/numbers.ts";
import { locate } from "../scene/times.ts";
import { controls } from "./controls.ts";
import { frame } from "./frame.ts";
import { type Drawn, draw } from "./picture.ts";
import { onPicture, pinAt } from "./pick.ts";
import type { Pin } from "./pins.ts";
import { playback } from "./playback.ts";
import { SECONDS } from "./speeds.ts";
import { type Facts, survey } from "./survey.ts";
import { speaker } from "./words.ts";

export interface RenderOptions {
  readonly model: Scene;
  readonly el: Element;
  /** Texts under "report.*" keys. */
  readonly words?: Texts;
  /** Unit and name of the scene's time. */
  readonly time?: Pick<TimeAxis, "unit" | "label">;
  /** Yields to a wish for reduced motion. */
  readonly autoplay?: boolean;
}

export type Listener = (time: number, index: number) => void;

/** A drawing on the page, as callers steer it. */
export interface Drawing {
  readonly playing: boolean;
  readonly time: number;
  play(): void;
  pause(): void;
  /** Setting a time or a sample ends the play. */
  setTime(t: number): void;
  setIndex(i: number): void;
  /** The same links and points in another motion at the same times; `original` is drawn faintly behind it. */
  update(scene: Scene, original: Scene | null): void;
  /** The place in the world of a place in the window. */
  place(x: number, y: number): Point;
  /** The pin or point next to a place in the window, none farther away than some pixels. */
  pick(x: number, y: number, within: number): Pin | null;
  readonly picture: SVGSVGElement;
  /** Calls back when the time changes, until the function that it gives is called. */
  on(event: "time", callback: Listener): () => void;
  destroy(): void;
}

/** Draws the scene `model` into `el`, with play, speed and time controls. */
export function render({
  model,
  el,
  words = {},
  time = { unit: "s", label: "time" },
  autoplay = false,
}: RenderOptions): Drawing {
  const say = speaker(words);
  let facts = survey(model);
  let original: Facts | null = null;
  const { times } = facts;
  const [first, last] = [times[0]!, times.at(-1)!];
  const second = SECONDS[time.unit];
  const perSecond = second ? 1 / second : (last - first) / 4;
  const { root, drawing } = frame(el, say);
  const ui = controls(root, facts, { say, time, real: (last - first) / perSecond });
  const decimals = clamp(1 - Math.floor(Math.log10((last - first) / (times.length - 1) || 1)), 0, 9);
  const listeners = new Set<Listener>();
  let picture: Drawn | undefined;
  let now = first;

  const show = (): number => {
    const { k, f, nearest } = locate(times, now);
    picture!.show(k, f);
    const figure = now.toFixed(decimals);
    ui.slider.value = String(nearest);
    ui.readout.textContent = `${time.label} ${figure} ${time.unit}`.trim();
    const note = facts.gaps[nearest] ? ` ${say("not_assembled")}` : "";
    ui.slider.setAttribute("aria-valuetext", `${figure} ${time.unit}${note}`);
    return nearest;
  };
  const goTo = (t: number): void => {
    now = clamp(t, first, last);
    const nearest = show();
    for (const listener of listeners) listener(now, nearest);
  };
  const switches = (): void => {
    drawing.classList.toggle("lw-no-points", !ui.points.checked);
    drawing.classList.toggle("lw-no-links", !ui.links.checked);
    for (const kind of ["areas", "traces", "centrodes"] as const) {
      picture![kind].forEach((group, i) => group.classList.toggle("lw-hidden", !ui[kind][i]!.checked));
    }
  };
  const layout = (): void => {
    const width = Math.round(root.clientWidth) || 640;
    const box = ui.centrodes.some((each) => each.checked) ? facts.wide : facts.box;
    const most = clamp(window.innerHeight * 0.66, 280, 720);
    picture = draw(drawing, facts, { width, most, box, original, before: picture ?? null }, say);
    switches();
    show();
  };
  const frames = playback(
    (seconds) => goTo(first + ((now - first + seconds * perSecond * Number(ui.speed.value)) % (last - first))),
    (playing) => {
      ui.play.setAttribute("aria-pressed", String(playing));
      ui.play.setAttribute("aria-label", say(playing ? "pause" : "play"));
    },
  );
  const play = (): void => {
    if (last !== first) frames.start();
  };
  const pause = (): void => frames.stop();
  const setTime = (t: number): void => {
    pause();
    goTo(t);
  };
  const setIndex = (i: number): void => setTime(times[clamp(Math.round(i), 0, times.length - 1)]!);

  ui.play.addEventListener("click", () => (frames.running ? pause() : play()));
  ui.slider.addEventListener("input", () => setIndex(Number(ui.slider.value)));
  for (const box of [ui.points, ui.links, ...ui.areas, ...ui.traces]) box.addEventListener("change", switches);
  for (const box of ui.centrodes) box.addEventListener("change", layout); // they may need more room
  let width = 0;
  const watcher = new ResizeObserver(() => {
    if (!root.clientWidth || root.clientWidth === width) return;
    width = root.clientWidth;
    layout();
  });
  layout();
  watcher.observe(root);
  pause();
  if (autoplay && !window.matchMedia("(prefers-reduced-motion: reduce)").matches) play();

  return {
    play,
    pause,
    setTime,
    setIndex,
    get playing() {
      return frames.running;
    },
    get time() {
      return now;
    },
    picture: drawing,
    update(scene, before) {
      facts = survey(scene, facts);
      if (original?.scene !== before) original = before && survey(before, facts);
      layout();
    },
    place(x, y) {
      return picture!.view.toWorld(onPicture(drawing, x, y));
    },
    pick(x, y, within) {
      return pinAt(facts, picture!.view, times, now, onPicture(drawing, x, y), within);
    },
    on(event, callback) {
      if (event !== "time") throw new Error(`unknown event: ${event as string}`);
      listeners.add(callback);
      return () => listeners.delete(callback);
    },
    destroy() {
      pause();
      watcher.disconnect();
      listeners.clear();
      el.replaceChildren();
    },
  };
}
