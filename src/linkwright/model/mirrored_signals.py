"""What becomes of the signals of a sub-assembly in its mirror image (:mod:`linkwright.elements.mirror`)."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from typing import Any

from linkwright.elements.mirror import HALF_TURN, Mirror, Reflection
from linkwright.elements.points import FRAME
from linkwright.expressions.fields import FrozenDict, Position
from linkwright.model.cylinders import with_cylinders
from linkwright.model.mechanism import Mechanism

_ANGLES = {"angle": Reflection(True, HALF_TURN), **dict.fromkeys(("omega", "alpha", "jerk"), Reflection(True))}
_RELATIVE = dict.fromkeys(("angle", "omega", "alpha", "jerk"), Reflection(True))
_TRAVELS = dict.fromkeys(("s", "v", "a", "j"), Reflection())
_LENGTHS = dict.fromkeys(("length", "v"), Reflection())
_RATES = {
    **dict.fromkeys(("vx", "ax", "jx"), Reflection(True)),
    **dict.fromkeys(("vy", "ay", "jy"), Reflection()),
}


def mirror_of(m: Mechanism, names: Mapping[str, str], shared: Iterable[str], at: Position | None) -> Mirror:
    """The mirror of a copy of a sub-assembly that is displaced by ``at``: ``names`` are the new names by those in it,
    ``shared`` its links that others have."""
    whole, shared = with_cylinders(m), frozenset(shared)
    own = {link for link in whole.links if link not in shared}
    renamed = {names.get(link, link) for link in own}
    slides = [joint.links for _, joint in whole.prismatic_joints()]
    sliding = frozenset(frozenset(names.get(link, link) for link in both) for both in slides)
    found: dict[str, Reflection] = {}
    for name, attributes in _elements(whole, own, at or Position([0, 0])):
        if name in shared:
            continue
        new = names.get(name, name)
        found |= {f"{new}.{attribute}": seen for attribute, seen in attributes.items()}
    return Mirror(frozenset(renamed), FrozenDict(found), sliding)


def _elements(m: Mechanism, own: set[str], at: Position) -> Iterator[tuple[str, Mapping[str, Reflection]]]:
    """The elements with their signals in the mirror."""
    x, y = ("" if shift.bare_number() == 0 else shift.text for shift in (at.first, at.second))
    places = {"x": Reflection(True, x), "y": Reflection(False, y)}
    for link in own:
        yield link, _ANGLES
    for link in (*own, FRAME):
        for point in m.links[link].points if link in m.links else ():
            yield point, {**places, **_RATES}
    for name, _ in m.prismatic_joints():
        yield name, _TRAVELS
    for name, drive in m.drives.items():
        if drive.turns is None:
            yield name, _TRAVELS
        elif {drive.turns, drive.on} <= {*own, FRAME}:
            yield name, _ANGLES if drive.on == FRAME else _RELATIVE
    for name, spring in m.springs.items():
        if not getattr(spring, "torsional", True):
            yield name, _LENGTHS


def mirrored_window(window: Any, name: str, mirror: Mirror) -> Any:
    """A window seen in a mirror: of a signal of what is mirrored the range turns with it."""
    if not isinstance(window, Mapping):
        return window
    ((signal, ends),) = window.items()
    seen = mirror.signals.get(signal, Reflection())
    images = tuple(seen.image(end) for end in ends)
    return FrozenDict({signal: images[::-1] if seen.opposite else images})
