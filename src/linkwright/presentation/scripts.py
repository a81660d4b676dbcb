"""Scripts that stand in a page, and the policy by which the browser runs these and no others.

The policy names each by its hash (Content Security Policy Level 3, 2.3.1: ``hash-source``). What gets into the page by
other ways, an element or an attribute with code in it, doesn't run; nothing is loaded; no text becomes code.
"""

from __future__ import annotations

import base64
import hashlib
import re
from collections.abc import Iterable
from importlib.resources import files

_ENDS = re.compile(r"</script|<!--", re.IGNORECASE)
"""What would end a script before its end, or hide it."""


def policy(scripts: Iterable[str]) -> str:
    """The policy of a page that holds these scripts: the browser itself is told to load nothing and to run no other, so
    that the file stays self-contained whatever is put into it. Drawings and plots set styles as they move."""
    hashes = [f"'sha256-{base64.b64encode(hashlib.sha256(code.encode()).digest()).decode()}'" for code in scripts]
    allowed = " ".join(dict.fromkeys(hashes)) or "'none'"
    rules = [
        "default-src 'none'",
        f"script-src {allowed}",
        "style-src 'unsafe-inline'",
        "img-src data:",
        "base-uri 'none'",
        "form-action 'none'",
    ]
    return "; ".join(rules)


def element(code: str) -> str:
    """A script as an element of a page, its text to the letter, as its hash demands."""
    if _ENDS.search(code) or "\r" in code:
        raise ValueError(f"this can't stand in a page as it is: {code[:80]!r}")
    return f"<script>{code}</script>"


def built(package: str, name: str) -> str:
    """The text of a script or a style sheet that is built from ``web/``, without the line on what it was built from."""
    head, text = files(package).joinpath(name).read_text("utf-8").split("\n", 1)
    assert head.startswith("/* built ")
    return text.strip()
