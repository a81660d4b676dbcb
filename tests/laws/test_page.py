"""The table of laws in docs/how-to/motion-laws.md; ``python tests/laws/test_page.py`` writes it anew."""

from __future__ import annotations

import math
import re
from pathlib import Path

from linkwright.laws import LAWS
from linkwright.laws.scca import MEMBERS

PAGE = Path(__file__).parents[2] / "docs" / "how-to" / "motion-laws.md"
TABLE = re.compile(r"\| law \| Cv \|.*?\n\|---.*?\n(?:\|.*\n)*")


def rendered() -> str:
    """The table, the SCCA family first; of laws that aren't symmetric both signs of the acceleration, and both ends."""
    rows = ["| law | Cv | Ca | Cj | ends |", "|---|---|---|---|---|"]
    for name in [*MEMBERS, *sorted(LAWS.keys() - MEMBERS.keys())]:
        law = LAWS[name]
        factors = ["inf" if math.isinf(law.factor(k)) else f"{law.factor(k):.6g}" for k in (1, 2, 3)]
        if law.mirrored:
            low, high = law.peaks(2)
            factors[1] = f"{high.value:.6g}, {low.value:.6g}"
        start, _, end = law.continuity
        rows.append(f"| `{name}` | {' | '.join(factors)} | C{start}{f', C{end}' if end != start else ''} |")
    return "\n".join(rows) + "\n"


def test_the_table_of_the_page_is_that_of_the_registry() -> None:
    found = TABLE.search(PAGE.read_text(encoding="utf-8"))
    assert found is not None
    assert found[0] == rendered(), "run python tests/laws/test_page.py"


if __name__ == "__main__":
    text = PAGE.read_text(encoding="utf-8")
    PAGE.write_text(TABLE.sub(lambda _: rendered(), text, count=1), encoding="utf-8", newline="\n")
