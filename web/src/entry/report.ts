// The report: a drawing that moves and one for paper, plots on the same time, and what else its page can do.

import { type Drawing, render } from "../drawing/render.ts";
import { still } from "../drawing/still.ts";
import { LiveModel } from "../live/live_model.ts";
import { livePage } from "../live/live_page.ts";
import { plotsOf, sceneOf } from "../live/live_scene.ts";
import { copyButtons } from "../panels/copy.ts";
import { openLinkedParts } from "../panels/folded.ts";
import { found } from "../panels/found.ts";
import { pageData } from "../panels/page_data.ts";
import { whenPrinted } from "../panels/print.ts";
import { stacks } from "../panels/stacks.ts";
import { charts } from "../plots/charts.ts";
import { coloursAt } from "../plots/looks.ts";

const words = linkwrightWords;
const page = pageData(words);
const live = page.live ? new LiveModel(page.live, linkwrightPrograms) : null;
const { time, plots } = page;
const scene = live ? sceneOf(page.scene, live) : page.scene;
const drawing = render({ model: scene, el: found("#drawing"), words: words.texts, time, autoplay: true });
/** The picture for paper shows what the one on the screen does. */
const toPaper = () => still({ model: drawing.scene, el: found("#still"), words: words.texts, seen: drawing.seen });
toPaper();
const shown = charts(document.querySelectorAll<HTMLElement>("figure.plot"), {
  time,
  plots: live ? plotsOf(plots, live) : plots,
  axis: words.axis,
  labels: words.labels,
  colour: coloursAt(found("#drawing .lw")),
  drawing,
  whole: document.querySelector<HTMLElement>("#whole"),
});
if (live) {
  const { texts, locked } = words;
  livePage({ live, drawing, charts: shown, scene: page.scene, plots, time, texts, locked });
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
  var linkwright: { drawing: Drawing; charts: typeof shown.all; live: LiveModel | null };
}
globalThis.linkwright = { drawing, charts: shown.all, live };
