// The search of signals: all words of a query must be found; a name that begins with one comes before one that has it.

import type { Listed } from "./signals.ts";

/** How well an entry fits one word; the smaller the better, null where it doesn't. */
function fit({ name, unit, element, quantity = "" }: Listed, word: string): number | null {
  const own = named(name.toLowerCase(), word);
  if (own !== null) return own;
  // A force between two links stands in the list once: the other way round it is the opposite.
  const swapped = name.toLowerCase().replace(/^force\((.+), (.+)\)/, "force($2, $1)");
  if (named(swapped, word) !== null) return 3;
  if (`${element} ${quantity}`.toLowerCase().includes(word)) return 4;
  return unit.toLowerCase() === word ? 4 : null;
}

/** The same of a name. */
function named(text: string, word: string): number | null {
  if (text === word) return 0;
  if (text.startsWith(word)) return 1;
  let inside = false;
  for (let at = text.indexOf(word); at >= 0; at = text.indexOf(word, at + 1)) {
    if (!/[\p{L}\p{N}_]/u.test(text[at - 1]!)) return 2;
    inside = true;
  }
  return inside ? 3 : null;
}

/** The entries that have all words of a query, the best first, else in their own order. */
export function search<E extends Listed>(entries: readonly E[], query: string): E[] {
  const words = query.toLowerCase().split(/\s+/).filter(Boolean);
  const found: { entry: E; score: number; at: number }[] = [];
  entries.forEach((entry, at) => {
    let score = 0;
    for (const word of words) {
      const each = fit(entry, word);
      if (each === null) return;
      score += each;
    }
    found.push({ entry, score, at });
  });
  return found.sort((a, b) => a.score - b.score || a.at - b.at).map(({ entry }) => entry);
}
