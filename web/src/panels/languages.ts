// A page in another language than it is written in: presentation/languages.py says what stands where instead.

import { found } from "./found.ts";

/** By a text what is written instead: everywhere, or at each of its places in their order (null: it stays). */
type Replaced = Readonly<Record<string, string | readonly (string | null)[]>>;

interface OtherLanguage {
  readonly title: string;
  /** What the choice of languages is called. */
  readonly choice: string;
  /** As those of the present language, without their keys. */
  readonly words: unknown;
  readonly texts: Replaced;
  /** By the attribute's name. */
  readonly attributes: Readonly<Record<string, Replaced>>;
  /** By data-place the inside of elements whose own elements differ. */
  readonly inside: Readonly<Record<string, string>>;
}

interface Languages {
  readonly words: unknown;
  /** By the language's tag. */
  readonly others: Readonly<Record<string, OtherLanguage>>;
}

/** Turns the page into the language behind its address (?lang=TAG), if it has it; gives the words for its scripts. */
export function chooseLanguage(): unknown {
  const languages = JSON.parse(found("#languages").textContent ?? "") as Languages;
  const tag = new URLSearchParams(location.search).get("lang") ?? "";
  const other = languages.others[tag];
  const root = document.documentElement;
  const choice = found<HTMLElement>("nav.languages");
  if (other) {
    root.lang = tag;
    document.title = other.title;
    choice.ariaLabel = other.choice;
    translate(other);
  }
  for (const link of choice.querySelectorAll("a")) {
    if (link.lang === root.lang) link.setAttribute("aria-current", "true");
  }
  choice.hidden = false;
  return other ? withKeys(other.words, languages.words) : languages.words;
}

/** Data whose objects are lists of their values, with the keys of other data of this kind. */
export function withKeys(values: unknown, like: unknown): unknown {
  if (!Array.isArray(values) || like === null || typeof like !== "object") return values;
  if (Array.isArray(like)) return values.map((value, i) => withKeys(value, like[i]));
  const keys = Object.keys(like).sort();
  return Object.fromEntries(keys.map((key, i) => [key, withKeys(values[i], like[key as keyof typeof like])]));
}

function translate(other: OtherLanguage): void {
  for (const [place, inside] of Object.entries(other.inside)) found(`[data-place="${place}"]`).innerHTML = inside;
  const texts = replacing(other.texts);
  const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
  while (walker.nextNode()) {
    const node = walker.currentNode as Text;
    const text = node.parentElement?.localName === "script" ? null : texts(node.data);
    if (text !== null) node.data = text;
  }
  for (const [name, replaced] of Object.entries(other.attributes)) {
    const values = replacing(replaced);
    for (const element of document.body.querySelectorAll(`[${CSS.escape(name)}]`)) {
      const value = values(element.getAttribute(name) ?? "");
      if (value !== null) element.setAttribute(name, value);
    }
  }
}

/** A function that is asked for each text in the page's order and gives what stands for it, or null. */
export function replacing(replaced: Replaced): (text: string) => string | null {
  const seen = new Map<string, number>();
  return (text) => {
    const other = Object.hasOwn(replaced, text) ? replaced[text] : undefined;
    if (other === undefined || typeof other === "string") return other ?? null;
    const place = seen.get(text) ?? 0;
    seen.set(text, place + 1);
    return other[place] ?? null;
  };
}
