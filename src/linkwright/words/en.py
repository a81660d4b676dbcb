"""English words, by key. Chinese and others follow as modules beside this one."""

WORDS: dict[str, str] = {}
