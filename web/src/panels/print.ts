// Paper: light, everything unfolded, plots of its own.

export interface Printed {
  toPaper(): void;
  toScreen(): void;
}

/** Calls before and after the page is printed, or shown as it will be. */
export function whenPrinted(printed: Printed): void {
  let printing = false;
  const toPaper = (): void => {
    if (printing) return;
    printing = true;
    document.documentElement.dataset["theme"] = "light";
    printed.toPaper();
    for (const details of document.querySelectorAll<HTMLDetailsElement>("details:not([open])")) {
      details.dataset["opened"] = "";
      details.open = true;
    }
  };
  const toScreen = (): void => {
    if (!printing) return;
    printing = false;
    delete document.documentElement.dataset["theme"];
    printed.toScreen();
    for (const details of document.querySelectorAll<HTMLDetailsElement>("details[data-opened]")) {
      delete details.dataset["opened"];
      details.open = false;
    }
  };
  window.addEventListener("beforeprint", toPaper);
  window.addEventListener("afterprint", toScreen);
  matchMedia("print").addEventListener("change", ({ matches }) => (matches ? toPaper() : toScreen()));
}
