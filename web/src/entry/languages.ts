// Every page: its language, before anything else looks at it.

import { chooseLanguage } from "../panels/languages.ts";
import type { PageWords } from "../panels/page_data.ts";

globalThis.linkwrightWords = chooseLanguage() as PageWords;
