"""The language itself: its own name, its tag (BCP 47), and the word before a choice of languages."""

TEXTS: dict[str, str] = {
    "language.name": "简体中文",
    "language.tag": "zh-CN",
    "language.choice": "语言",
}
