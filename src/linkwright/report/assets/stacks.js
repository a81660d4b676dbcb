// Pictures for several values of parameters: sliders choose the one that is seen. Without this script, and on paper, all
// of them stand beside each other.

for (const stacks of document.querySelectorAll(".stacks")) {
  const sliders = [...stacks.querySelectorAll("input[type=range]")];
  const pictures = stacks.querySelectorAll("[data-step]");
  const show = () => {
    const step = sliders.map((slider) => slider.value).join(" ");
    for (const picture of pictures) picture.classList.toggle("shown", picture.dataset.step === step);
    for (const slider of sliders) {
      const text = slider.getAttribute(`data-text-${slider.value}`);
      slider.setAttribute("aria-valuetext", text);
      stacks.querySelector(`output[for="${slider.id}"]`).textContent = text;
    }
  };
  for (const slider of sliders) slider.addEventListener("input", show);
  stacks.classList.add("stepped");
  stacks.querySelector(".sliders").hidden = false;
  show();
}
