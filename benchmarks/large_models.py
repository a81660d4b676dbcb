"""Mechanisms of many links as data of model files, sound or with a fault, for the benchmarks and the fuzzer.

Each class gives a mechanism with about so many moving links: ``chain`` of four-bars, one driving the next; ``ring`` of
links closed in itself, a single group; ``grid`` of quadrangles two high; ``two_tree``, dyads hung on random links
placed before. The links are drawn by a sketch, so that each can be assembled as drawn.
"""

from __future__ import annotations

import math
import random
from collections.abc import Callable
from typing import Any

Data = dict[str, Any]
Place = tuple[float, float]


class Drawn:
    """A mechanism under way: places of pins, links by their pins, the frame and a crank to begin with."""

    def __init__(self) -> None:
        self.places: dict[str, Place] = {"O": (0.0, 0.0), "K": (20.0, 30.0)}
        self.links: dict[str, list[str]] = {"frame": ["O"], "crank": ["O", "K"]}

    def pin(self, name: str, x: float, y: float, *links: str) -> str:
        """A pin at a place (mm), on links that there are."""
        self.places[name] = (x, y)
        for link in links:
            self.links[link].append(name)
        return name

    def link(self, *pins: str) -> str:
        """A new link on pins."""
        name = f"l{len(self.links) - 2}"
        self.links[name] = [*pins]
        return name

    def data(self) -> Data:
        """The model file."""
        return {
            "linkwright": 1,
            "units": {"length": "mm", "angle": "deg", "mass": "kg"},
            "sketch": {pin: [round(x, 3), round(y, 3)] for pin, (x, y) in self.places.items()},
            "links": {name: {"points": pins} for name, pins in self.links.items()},
            "drives": {"motor": {"turns": "crank", "on": "frame", "speed": "1 deg/s"}},
            "studies": {"cycle": {"duration": "1 s", "samples": 5}},
        }


def chain(links: int, seed: int = 0) -> Data:
    """Four-bars in a row: each rocker moves the coupler of the next."""
    drawn, random_ = Drawn(), random.Random(seed)
    at = "K"
    for i in range(links // 2):
        x = 100.0 * (i + 1)
        coupler = drawn.link(at)
        rocker = drawn.link()
        drawn.pin(f"C{i}", x + random_.uniform(-8, 8), 60 + random_.uniform(-8, 8), coupler, rocker)
        drawn.pin(f"D{i}", x, 0, rocker, "frame")
        at = drawn.pin(f"E{i}", x + 30, 50 + random_.uniform(-8, 8), rocker)
    return drawn.data()


def ring(links: int, seed: int = 0) -> Data:
    """Links pinned each to the next and the last to the first, every other one to the frame, the first to the crank."""
    drawn, random_ = Drawn(), random.Random(seed)
    count = links // 2 * 2
    radius = 20.0 * count
    names = [drawn.link() for _ in range(count)]
    for i, name in enumerate(names):
        around = 2 * math.pi * i / count
        wide = radius * (1 + 0.05 * random_.uniform(-1, 1))
        drawn.pin(f"P{i}", wide * math.cos(around), wide * math.sin(around), name, names[i - 1])
        if i % 2 == 0 and i:
            drawn.pin(
                f"F{i}", 1.3 * radius * math.cos(around + 0.1), 1.3 * radius * math.sin(around + 0.1), name, "frame"
            )
    drawn.links[names[0]].append("K")
    return drawn.data()


def grid(links: int, seed: int = 0) -> Data:
    """A row of quadrangles: bars above and below, posts between them, every other bar below pinned to the frame too."""
    drawn, random_ = Drawn(), random.Random(seed)
    low, high = "O", "K"
    for i in range(links // 6 * 2):
        x = 60.0 * (i + 1)
        bottom, top, post = drawn.link(low), drawn.link(high), drawn.link()
        low = drawn.pin(f"B{i}", x, random_.uniform(-6, 6), bottom, post)
        high = drawn.pin(f"T{i}", x, 50 + random_.uniform(-6, 6), top, post)
        if i % 2:
            drawn.pin(f"H{i}", x - 20, -60 + random_.uniform(-6, 6), bottom, "frame")
    return drawn.data()


def two_tree(links: int, seed: int = 0) -> Data:
    """Dyads, each on two random links placed before."""
    drawn, random_ = Drawn(), random.Random(seed)
    for i in range(links // 2):
        a, b = random_.sample([*drawn.links], 2)
        x, y = random_.uniform(-400, 400), random_.uniform(-400, 400)
        first, second = drawn.link(), drawn.link()
        drawn.pin(f"A{i}", x, y, a, first)
        drawn.pin(f"B{i}", x + 150 + random_.uniform(-40, 40), y + random_.uniform(-40, 40), b, second)
        drawn.pin(f"M{i}", x + 75, y + 120 + random_.uniform(-40, 40), first, second)
    return drawn.data()


CLASSES: dict[str, Callable[[int, int], Data]] = {"chain": chain, "ring": ring, "grid": grid, "two_tree": two_tree}


def misspelled(data: Data, seed: int = 0) -> Data:
    """One point of one link under a name that no other link has."""
    random_ = random.Random(seed)
    link = random_.choice([name for name in data["links"] if name not in ("frame", "crank")])
    points = data["links"][link]["points"]
    at = random_.randrange(len(points))
    data["sketch"][f"{points[at]}x"] = data["sketch"][points[at]]
    points[at] = f"{points[at]}x"
    return data


def held(data: Data, seed: int = 0) -> Data:
    """One bar more between two random links."""
    random_ = random.Random(seed)
    a, b = random_.sample([name for name in data["links"] if name not in ("frame", "crank")], 2)
    data["sketch"] |= {"X0": [random_.uniform(-90, 90), 40], "X1": [random_.uniform(300, 400), 70]}
    data["links"][a]["points"].append("X0")
    data["links"][b]["points"].append("X1")
    data["links"]["bar"] = {"points": ["X0", "X1"]}
    return data


def apart(data: Data, seed: int = 0) -> Data:
    """A four-bar besides that hangs on nothing."""
    data["sketch"] |= {f"Z{i}": [50 * i, -200 - 30 * (i % 3)] for i in range(4)}
    data["links"] |= {f"z{i}": {"points": [f"Z{i}", f"Z{(i + 1) % 4}"]} for i in range(4)}
    return data


FAULTS: dict[str, Callable[[Data, int], Data]] = {
    "sound": lambda data, seed: data,
    "misspelled": misspelled,
    "held": held,
    "apart": apart,
}
