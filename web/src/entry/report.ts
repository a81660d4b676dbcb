// The report: a drawing that moves and one for paper, plots on the same time, and what else its page can do.

import { type Drawing, render } from "../drawing/render.ts";
import { still } from "../drawing/still.ts";
import { copyButtons } from "../panels/copy.ts";
import { openLinkedParts } from "../panels/folded.ts";
import { found } from "../panels/found.ts";
import { pageData } from "../panels/page_data.ts";
import { whenPrinted } from "../panels/print.ts";
import { stacks } from "../panels/stacks.ts";
import { charts } from "../plots/charts.ts";
import { coloursAt } from "../plots/looks.ts";

const words = linkwrightWords;
const { time, scene, plots } = pageData(words);
const drawing = render({ model: scene, el: found("#drawing"), words: words.texts, time, autoplay: true });
still({ model: scene, el: found("#still"), words: words.texts });
const shown = charts(document.querySelectorAll<HTMLElement>("figure.plot"), {
  time,
  plots,
  axis: words.axis,
  labels: words.labels,
  colour: coloursAt(found("#drawing .lw")),
  drawing,
  whole: document.querySelector<HTMLElement>("#whole"),
});
whenPrinted(shown);
copyButtons(
  (button) => button.dataset["copy"] ?? "",
  () => words.texts["report.copied"] ?? "",
);
stacks();
openLinkedParts();

declare global {
  /** For the browser's console and for tests. */
  var linkwright: { drawing: Drawing; charts: typeof shown.all };
}
globalThis.linkwright = { drawing, charts: shown.all };
