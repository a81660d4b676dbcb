// A chart of a study on the page: its head with tools, and the view that its reader chose.

import { html } from "../drawing/elements.ts";
import type { Say } from "../drawing/words.ts";
import { download, fileName, png } from "../panels/download.ts";
import { found } from "../panels/found.ts";
import { familyCurves, familyOf } from "./family.ts";
import type { FileKind } from "./files.ts";
import { graphView } from "./graph_view.ts";
import type { Colour } from "./looks.ts";
import { planeView } from "./plane_view.ts";
import type { Study } from "./study.ts";
import type { StudyPlace, StudyView } from "./study_view.ts";
import { button, menu, WHOLE } from "./tools.ts";

export interface StudyChart {
  readonly box: HTMLElement;
  /** What its curves are, of one that has curves; for tests and the console. */
  readonly study: Study;
  /** Draws it, once it is in sight. */
  seen(): void;
  sized(): void;
  themed(): void;
  toPaper(): void;
  toScreen(): void;
}

export function studyChart(box: HTMLElement, study: Study, { say, colour }: { say: Say; colour: Colour }): StudyChart {
  const [area, legend] = [found<HTMLElement>(".chart", box), found<HTMLElement>(".legend", box)];
  const head = found<HTMLElement>("figcaption", box);
  const title = "curves" in study ? study.curves.title : study.plane.title;
  const family = "plane" in study ? familyOf(study.plane) : null;
  const bar = html("span", { class: "plot-tools screen" }, head);
  let asFamily = false;
  let leave: (() => void) | null = null;

  const place: StudyPlace = {
    box,
    area,
    legend,
    colour,
    say,
    label: "curves" in study ? `${title}: ${study.curves.curves.map(({ name }) => name).join(", ")}` : title,
    zoomed(whole) {
      back.hidden = whole;
    },
  };
  const make = (): StudyView => {
    if ("curves" in study) return graphView(study.curves, place);
    return family && asFamily ? graphView(familyCurves(study.plane, family), place) : planeView(study.plane, place);
  };
  if (family) {
    const select = html("select", { "aria-label": say("plots.view") }, bar);
    html("option", { value: "" }, select, say("plots.contour"));
    html("option", { value: "family" }, select, say("plots.family"));
    select.addEventListener("change", () => {
      asFamily = select.value === "family";
      view.remove();
      area.replaceChildren();
      back.hidden = true;
      view = make();
      view.seen();
    });
  }
  const back = button(bar, say("plots.reset_zoom"), WHOLE);
  back.hidden = true;
  back.addEventListener("click", () => view.reset());
  menu(bar, say("plots.export"), (kind) => void save(kind));
  let view = make();
  area.addEventListener("keydown", (event) => {
    if (event.altKey || event.ctrlKey || event.metaKey) return;
    if (view.key(event.key, event.shiftKey)) event.preventDefault();
  });

  const save = async (kind: FileKind): Promise<void> => {
    const name = `${fileName(title)}.${kind}`;
    if (kind === "csv") return download(name, new Blob([view.csv()], { type: "text/csv" }));
    const text = view.svg(Math.max(320, Math.round(box.clientWidth || 480)));
    download(name, kind === "svg" ? new Blob([text], { type: "image/svg+xml" }) : await png(text));
  };
  return {
    box,
    study,
    seen: () => view.seen(),
    sized: () => view.sized(),
    themed: () => view.themed(),
    toPaper() {
      leave ??= view.toPaper();
    },
    toScreen() {
      leave?.();
      leave = null;
    },
  };
}
