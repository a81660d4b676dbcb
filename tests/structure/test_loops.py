"""Loops of four links: each once, over four different joints."""

from __future__ import annotations

from typing import Any

import linkwright as lw
from linkwright.structure import Topology
from linkwright.structure.loops import MOST, loops_of_four


def topology(**links: list[str]) -> Topology:
    """Links by their points; equal names are pinned."""
    data: dict[str, Any] = {
        link: {"points": {p: [i, 0] for i, p in enumerate(points)}} for link, points in links.items()
    }
    return Topology(lw.Document.model_validate({"links": data}))


def test_a_four_bar_is_one_loop() -> None:
    (loop,) = loops_of_four(topology(frame=["A", "D"], crank=["A", "B"], coupler=["B", "C"], rocker=["C", "D"]))
    assert loop.links == ("frame", "crank", "coupler", "rocker")
    assert [joint.joint for joint in loop.joints] == ["A", "B", "C", "D"]
    assert loop.turning == (True,) * 4
    assert loop.rotated(1).links == ("crank", "coupler", "rocker", "frame")
    assert [joint.joint for joint in loop.rotated(1).joints] == ["B", "C", "D", "A"]


def test_three_links_on_one_pin_make_no_loop_of_their_own() -> None:
    """A third link on pin C closes loops over other pins only."""
    links = {
        "frame": ["A", "D", "E"],
        "crank": ["A", "B"],
        "coupler": ["B", "C"],
        "rocker": ["C", "D"],
        "rod": ["C", "E"],
    }
    found = {frozenset(loop.links) for loop in loops_of_four(topology(**links))}
    assert found == {
        frozenset({"frame", "crank", "coupler", "rocker"}),
        frozenset({"frame", "crank", "coupler", "rod"}),
    }


def test_many_links_between_the_same_pins_are_bounded() -> None:
    links = {f"l{i}{pins}": list(pins) for i in range(8) for pins in ("AB", "BC", "CD", "DA")}
    assert len(loops_of_four(topology(**links))) == MOST
