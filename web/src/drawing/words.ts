// What a drawing says.

import type { Texts } from "../scene/data.ts";

/** The text of a key of the catalogue's "report." part. */
export type Say = (key: string) => string;

/** Without a text the key itself is said. */
export const speaker =
  (words: Texts): Say =>
  (key) =>
    words[`report.${key}`] ?? key.replaceAll("_", " ");

/** A text with its places filled in: {name}. */
export const filled = (text: string, data: Readonly<Record<string, string>>): string =>
  text.replace(/\{(\w+)\}/g, (_, key: string) => data[key] ?? "");
