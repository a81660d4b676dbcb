// Elements that the page's markup promises.

/** The first element of a selector; its absence is a mistake of ours. */
export function found<E extends Element>(selector: string, within: ParentNode = document): E {
  const element = within.querySelector<E>(selector);
  if (!element) throw new Error(`not on this page: ${selector}`);
  return element;
}
