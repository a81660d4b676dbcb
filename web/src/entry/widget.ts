// The drawing alone, as a module: for notebook widgets (anywidget) and for pages of one's own.

import { type Drawing, render } from "../drawing/render.ts";
import { still } from "../drawing/still.ts";
import type { Scene, Texts } from "../scene/data.ts";

export { render, still };

/** A widget's model: its scene is under "scene", texts are under "words". */
interface WidgetModel {
  get(key: string): unknown;
  on(event: string, callback: () => void): void;
  off(event: string, callback: () => void): void;
}

/** Draws a widget's scene, and each new one, until the function that it gives is called; a plain scene is drawn too. */
function widget({ model, el }: { model: WidgetModel | Scene; el: Element }): Drawing | (() => void) {
  if (!("get" in model)) return render({ model, el });
  let drawing: Drawing | null = null;
  const fresh = (): void => {
    drawing?.destroy();
    const words = (model.get("words") ?? {}) as Texts;
    drawing = render({ model: model.get("scene") as Scene, el, words });
  };
  fresh();
  model.on("change:scene", fresh);
  return () => {
    model.off("change:scene", fresh);
    drawing?.destroy();
  };
}

export default { render: widget };
