// Pictures for several values of parameters: sliders choose the one that is seen. Without scripts, and on paper, all
// of them stand beside each other.

import { found } from "./found.ts";

export function stacks(): void {
  for (const box of document.querySelectorAll(".stacks")) step(box);
}

function step(box: Element): void {
  const sliders = [...box.querySelectorAll<HTMLInputElement>("input[type=range]")];
  const pictures = box.querySelectorAll<HTMLElement>("[data-step]");
  const show = (): void => {
    const chosen = sliders.map((slider) => slider.value).join(" ");
    for (const picture of pictures) picture.classList.toggle("shown", picture.dataset["step"] === chosen);
    for (const slider of sliders) {
      const text = slider.getAttribute(`data-text-${slider.value}`) ?? "";
      slider.setAttribute("aria-valuetext", text);
      found(`output[for="${slider.id}"]`, box).textContent = text;
    }
  };
  for (const slider of sliders) slider.addEventListener("input", show);
  box.classList.add("stepped");
  found<HTMLElement>(".sliders", box).hidden = false;
  show();
}
