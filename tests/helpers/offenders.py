"""One test for a rule about many things: all that break it are listed, each with the reason."""

from __future__ import annotations

from collections.abc import Collection, Mapping


def nobody_breaks(rule: Mapping[str, Collection[str]]) -> None:
    """Fail with all things that have faults, given by name; and where there is nothing to hold to the rule."""
    assert rule, "nothing is held to this rule"
    wrong = [f"{name}: {', '.join(faults)}" for name, faults in rule.items() if faults]
    assert not wrong, "\n".join(wrong)
