// The report: a drawing that moves and one for paper, plots on the same time, and what else its page can do.

import { type Drawing, render } from "../drawing/render.ts";
import { speaker } from "../drawing/words.ts";
import { still } from "../drawing/still.ts";
import { filled } from "../drawing/words.ts";
import { LiveModel } from "../live/live_model.ts";
import { livePage } from "../live/live_page.ts";
import { liveSignals } from "../live/live_signals.ts";
import { sceneOf } from "../live/live_scene.ts";
import { unpacked } from "../live/packed.ts";
import { copyButtons } from "../panels/copy.ts";
import { openLinkedParts } from "../panels/folded.ts";
import { found } from "../panels/found.ts";
import { pageData } from "../panels/page_data.ts";
import { kept } from "../panels/kept.ts";
import { whenPrinted } from "../panels/print.ts";
import { stacks } from "../panels/stacks.ts";
import { charts } from "../plots/charts.ts";
import { keyOf } from "../plots/choice.ts";
import { coloursAt } from "../plots/looks.ts";
import { recordedSignals } from "../plots/signals.ts";

const words = linkwrightWords;
const page = pageData(words);
const live = page.live ? new LiveModel(page.live, linkwrightPrograms) : null;
const { time, plots } = page;
const scene = live ? sceneOf(page.scene, live) : page.scene;
const drawing = render({ model: scene, el: found("#drawing"), words: words.texts, time, autoplay: true });
/** The picture for paper shows what the one on the screen does. */
const toPaper = () => still({ model: drawing.scene, el: found("#still"), words: words.texts, seen: drawing.seen });
toPaper();
const own = Array.from(document.querySelectorAll<HTMLElement>("figure.plot[data-plot]"), (box) => {
  const i = Number(box.dataset["plot"]);
  const signals = plots[i]!.series.map(({ name }) => name);
  const first = !live || page.first.includes(i);
  const choice = { of: keyOf(signals), signals, view: "components", top: first, open: first } as const;
  const { title, unit } = plots[i]!;
  const label = filled(unit ? words.label_unit : words.label, { title, unit, signals: signals.join(", ") });
  return { box, title, label, choice };
});
const bar = document.querySelector("#plot-bar");
const shown = charts({
  time,
  axis: words.axis,
  column: words.column,
  own,
  signals: live ? liveSignals(live, words.kinds, plots) : recordedSignals(plots),
  colour: coloursAt(found("#drawing .lw")),
  say: speaker(words.texts),
  drawing,
  whole: document.querySelector<HTMLElement>("#whole"),
  choosing: live && bar ? { bar, top: found("#first-plots"), kept: kept(`linkwright plots ${document.title}`) } : null,
});
if (live) {
  const { texts, locked, groups, gap } = words;
  const stateWords = { faults: unpacked(words.faults), groups, gap };
  livePage({ live, drawing, charts: shown, scene: page.scene, time, texts, locked, stateWords });
}
whenPrinted({
  toPaper() {
    toPaper();
    shown.toPaper();
  },
  toScreen: () => shown.toScreen(),
});
copyButtons(
  (button) => button.dataset["copy"] ?? "",
  () => words.texts["report.copied"] ?? "",
);
stacks();
openLinkedParts();

declare global {
  /** For the browser's console and for tests. */
  var linkwright: { drawing: Drawing; readonly charts: typeof shown.all; live: LiveModel | null };
}
globalThis.linkwright = {
  drawing,
  get charts() {
    return shown.all;
  },
  live,
};
