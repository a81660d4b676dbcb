// One plot over a horizontal axis on the page, with uPlot.

import uPlot from "uplot";
import { type Shown, chartKey, chartOptions, columns } from "./chart_options.ts";
import type { Curves } from "./curves.ts";
import type { Colour } from "./looks.ts";
import { type MarkLayer, markLayer } from "./mark_layer.ts";

export const HEIGHT = 230;

export interface Chart {
  readonly uplot: uPlot;
  readonly key: string;
  /** Shows the same curves with other values. */
  show(curves: Curves): void;
  /** Puts the cursor to a sample. */
  follow(index: number): void;
  zoom(window: readonly [number, number]): void;
  sized(): void;
  destroy(): void;
}

/** `label`: what the plot shows, for those who don't see it. `goTo`: where a click on a mark leads. */
export function chart(
  area: HTMLElement,
  curves: Curves,
  label: string,
  { colour, window, goTo }: { colour: Colour; window: readonly [number, number]; goTo: (time: number) => void },
): Chart {
  const shown: Shown = { curves, window, index: 0 };
  const size = { width: area.clientWidth || 400, height: HEIGHT };
  const options = chartOptions(shown, colour, size);
  let layer: MarkLayer | null = null;
  options.hooks = {
    ...options.hooks,
    draw: [(u) => layer?.update(u, shown.curves)],
    ready: [() => follow(shown.index)], // places on axes are known from now on
  };
  const uplot: uPlot = new uPlot(options, columns(curves), area);
  layer = markLayer(uplot.over, goTo);
  uplot.over.setAttribute("role", "img");
  uplot.over.setAttribute("aria-label", label);
  function follow(index: number): void {
    shown.index = index;
    const place = shown.curves.x.values[index];
    const left = place == null ? -10 : uplot.valToPos(place, "x");
    const inside = left >= 0 && left <= uplot.bbox.width / devicePixelRatio;
    uplot.setCursor({ left: inside ? left : -10, top: 0 }, false);
  }
  return {
    uplot,
    key: chartKey(curves),
    follow,
    show(changed) {
      shown.curves = changed;
      uplot.batch(() => {
        uplot.setData(columns(changed), false);
        uplot.setScale("x", { min: shown.window[0], max: shown.window[1] });
      });
      follow(shown.index);
    },
    zoom(to) {
      shown.window = to;
      uplot.setScale("x", { min: to[0], max: to[1] });
    },
    sized() {
      const width = area.clientWidth;
      if (width && width !== uplot.width) uplot.setSize({ width, height: HEIGHT });
    },
    destroy: () => uplot.destroy(),
  };
}
