// The report with charts of studies: all that a report does, and these.

import { speaker } from "../drawing/words.ts";
import { found } from "../panels/found.ts";
import { chartData } from "../panels/page_data.ts";
import { whenPrinted } from "../panels/print.ts";
import { coloursAt } from "../plots/looks.ts";
import { stillPicture } from "../plots/still_picture.ts";
import { studyCharts } from "../plots/studies.ts";
import "./report.ts";

const { charts, texts } = linkwrightWords;
const shown = studyCharts(chartData(), charts, { say: speaker(texts), colour: coloursAt(found("#drawing .lw")) });
for (const picture of document.querySelectorAll<SVGSVGElement>(".chart-still > svg[data-plane]")) {
  stillPicture(picture.parentElement!, picture, speaker(texts));
}
whenPrinted({ toPaper: () => shown.toPaper(), toScreen: () => shown.toScreen() });

declare global {
  /** For the browser's console and for tests. */
  var linkwrightStudies: typeof shown.all;
}
globalThis.linkwrightStudies = shown.all;
