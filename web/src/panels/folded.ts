// Folded parts of the page, which a link to them opens.

/** Opens the part to which the page's address leads, and those whose links are clicked. */
export function openLinkedParts(): void {
  const open = (hash: string): void => {
    const part = document.getElementById(decodeURIComponent(hash.slice(1)));
    part?.querySelector(":scope > details")?.setAttribute("open", "");
  };
  open(location.hash);
  document.addEventListener("click", ({ target }) => {
    const link = target instanceof Element ? target.closest<HTMLAnchorElement>("a[href^='#']") : null;
    if (link) open(link.hash);
  });
}
