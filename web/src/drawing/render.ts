// A mechanism as an animated SVG drawing, from plain scene data:
//
//   const drawing = render({ model: scene, el, words, time, autoplay });
//   drawing.setTime(t); drawing.setIndex(i); drawing.on("time", (t, index) => ...); drawing.destroy();

import { clamp } from "../scene/numbers.ts";
import { locate } from "../scene/times.ts";
import type { Arrow } from "./arrows.ts";
import { controls } from "./controls.ts";
import type { Drawing, Listener, RenderOptions } from "./drawing.ts";
import { frame } from "./frame.ts";
import { hover } from "./hover.ts";
import { type Drawn, draw } from "./picture.ts";
import { arrowAt, onPicture, pinAt } from "./pick.ts";
import type { Pin } from "./pins.ts";
import { playback } from "./playback.ts";
import { usual } from "./seen.ts";
import { showRow } from "./show_row.ts";
import { SECONDS } from "./speeds.ts";
import { type Facts, survey, together } from "./survey.ts";
import { viewing } from "./viewing.ts";
import { speaker } from "./words.ts";

export type { Drawing, Listener, RenderOptions } from "./drawing.ts";

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
  const first = facts.times[0]!;
  /** A motion of other numbers may last longer, in as many poses. */
  const end = (): number => facts.times.at(-1)!;
  const second = SECONDS[time.unit];
  const perSecond = second ? 1 / second : (end() - first) / 4;
  const { root, stage, drawing } = frame(el, say);
  const ui = controls(root, facts, { say, time, real: (end() - first) / perSecond });
  const seen = usual();
  let drawn = 0;
  const decimals = clamp(1 - Math.floor(Math.log10((end() - first) / (facts.times.length - 1) || 1)), 0, 9);
  const listeners = new Set<Listener>();
  let picture: Drawn | undefined;
  let now = first;

  const show = (): number => {
    const { k, f, nearest } = locate(facts.times, now);
    picture!.show(k, f);
    pointed.update(facts, picture!.view, k, f);
    const figure = now.toFixed(decimals);
    ui.slider.value = String(nearest);
    ui.readout.textContent = `${time.label} ${figure} ${time.unit}`.trim();
    const note = facts.gaps[nearest] ? ` ${say("not_assembled")}` : "";
    ui.slider.setAttribute("aria-valuetext", `${figure} ${time.unit}${note}`);
    return nearest;
  };
  const goTo = (t: number): void => {
    now = clamp(t, first, end());
    const nearest = show();
    for (const listener of listeners) listener(now, nearest);
  };
  const switches = (): void => {
    for (const kind of ["areas", "traces"] as const) {
      picture![kind].forEach((group, i) => group.classList.toggle("lw-hidden", !ui[kind][i]!.checked));
    }
  };
  /** Of the stage, as it was last measured: to ask for it at each change would make the browser lay out twice. */
  let width = 0;
  const layout = (): void => {
    cancelAnimationFrame(drawn);
    drawn = 0;
    const { camera } = viewed;
    const wide = Math.round(width || stage.clientWidth) || 640;
    const rolling = ui.centrodes.map((each) => each.checked);
    const box = rolling.includes(true) ? facts.wide : facts.box;
    const before = picture ?? null;
    const size = { width: wide, ...viewed.heights(), box, camera, seen, rolling, original, before };
    picture = draw(drawing, facts, size, say);
    switches();
    show();
    row.update(facts, wide);
    viewed.update();
  };
  /** Draws anew in the next frame, once however often it is asked. */
  const redraw = (): void => {
    drawn ||= requestAnimationFrame(layout);
  };
  const fitAll = (): void => {
    viewed.home();
    const fresh = survey(facts.scene);
    const { box, wide, size } = original ? together(fresh, survey(original.scene)) : fresh;
    facts = { ...facts, box, wide, size };
    layout();
  };
  const pick = (x: number, y: number, within: number): Pin | null =>
    pinAt(facts, picture!.view, facts.times, now, onPicture(drawing, x, y), within);
  const viewed = viewing({
    root,
    stage,
    drawing,
    say,
    facts: () => facts,
    fitted: () => picture!.fitted,
    pick,
    redraw,
    fit: fitAll,
  });
  const row = showRow(root, facts, seen, say, layout);
  const pickArrow = (x: number, y: number, within: number): Arrow | null =>
    arrowAt(facts, picture!.view, seen.arrows, now, onPicture(drawing, x, y), within);
  const pointed = hover({ stage, picture: drawing, say, pick, pickArrow, changed: () => show() });
  const frames = playback(
    (seconds) => goTo(first + ((now - first + seconds * perSecond * Number(ui.speed.value)) % (end() - first))),
    (playing) => {
      ui.play.setAttribute("aria-pressed", String(playing));
      ui.play.setAttribute("aria-label", say(playing ? "pause" : "play"));
    },
  );
  const play = (): void => {
    if (end() !== first) frames.start();
  };
  const pause = (): void => frames.stop();
  const setTime = (t: number): void => {
    pause();
    goTo(t);
  };
  const setIndex = (i: number): void => setTime(facts.times[clamp(Math.round(i), 0, facts.times.length - 1)]!);

  ui.play.addEventListener("click", () => (frames.running ? pause() : play()));
  ui.slider.addEventListener("input", () => setIndex(Number(ui.slider.value)));
  for (const box of [...ui.areas, ...ui.traces]) box.addEventListener("change", switches);
  for (const box of ui.centrodes) box.addEventListener("change", layout); // they may need more room
  const watcher = new ResizeObserver(() => {
    if (!stage.clientWidth || stage.clientWidth === width) return;
    width = stage.clientWidth;
    layout();
  });
  layout();
  watcher.observe(root);
  root.addEventListener("fullscreenchange", layout);
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
    seen,
    get scene() {
      return facts.scene;
    },
    fit: fitAll,
    update(scene, before) {
      const lasted = end();
      facts = survey(scene, facts);
      now = clamp(now * (end() / lasted || 1), first, end()); // the pose stays
      ui.mark(facts.gaps);
      if (original?.scene !== before) original = before && survey(before, facts);
      layout();
    },
    place(x, y) {
      return picture!.view.toWorld(onPicture(drawing, x, y));
    },
    pick,
    on(event, callback) {
      if (event !== "time") throw new Error(`unknown event: ${event as string}`);
      listeners.add(callback);
      return () => listeners.delete(callback);
    },
    destroy() {
      pause();
      cancelAnimationFrame(drawn);
      watcher.disconnect();
      listeners.clear();
      el.replaceChildren();
    },
  };
}
