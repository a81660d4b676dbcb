// Buttons that copy text to the clipboard.

/** Shows the buttons. `textOf`: what one copies; `copied`: what it says for a while when it has done so. */
export function copyButtons(
  textOf: (button: HTMLButtonElement) => string,
  copied: (button: HTMLButtonElement) => string,
): void {
  for (const button of document.querySelectorAll<HTMLButtonElement>("button.copy")) {
    button.hidden = false;
    const said = button.textContent;
    button.addEventListener("click", async () => {
      await copy(textOf(button));
      button.textContent = copied(button);
      setTimeout(() => (button.textContent = said), 2000);
    });
  }
}

/** Text to the clipboard; where a browser gives a page from disk none, by a selection. */
export async function copy(text: string): Promise<void> {
  try {
    await navigator.clipboard.writeText(text);
  } catch {
    const area = document.createElement("textarea");
    area.value = text;
    document.body.append(area);
    area.select();
    document.execCommand("copy");
    area.remove();
  }
}
