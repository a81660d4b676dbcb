"""The language itself: its own name, its tag (BCP 47), and the word before a choice of languages."""

TEXTS: dict[str, str] = {
    "language.name": "English",
    "language.tag": "en",
    "language.choice": "Language",
}
