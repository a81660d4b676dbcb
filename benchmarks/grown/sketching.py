"""How a grown mechanism's links are written: in axes of their own, or as a sketch; some numbers as parameters."""

from __future__ import annotations

import math

from grown.plane import FRAME, Data, Growing, heading, rounded


def links(g: Growing) -> Data:
    """The section ``links``, and the sketch and parameters that it refers to."""
    drawn = sketched(g) if g.random.random() < 0.25 else []
    made: Data = {}
    for link, points in g.places.items():
        body = dict(g.section("bodies").get(link, {}))
        more = body.pop("more", {})
        if link in drawn:
            made[link] = {"points": [*points], **body}
        else:
            local: Data = {point: g.local(link, at) for point, at in points.items()}
            if link != FRAME and g.random.random() < 0.4:
                named(g, link, local)
            made[link] = {"points": local | more, **body}
    g.data.pop("bodies", None)
    return made


def sketched(g: Growing) -> list[str]:
    """Links that are drawn: their axes go from the first point to the second; the sketch has all of their points."""
    found = []
    for link, points in g.places.items():
        (first, *others) = [*points.values()] or [(0.0, 0.0)]
        if link != FRAME and (not others or math.dist(first, others[0]) < 5 or g.random.random() < 0.3):
            continue
        if link != FRAME:
            g.axes[link] = (*first, heading(first, others[0]))
        if "more" in g.section("bodies").get(link, {}) or not points:
            continue
        found.append(link)
        g.section("sketch").update({point: [rounded(value) for value in at] for point, at in points.items()})
    if g.section("sketch") and g.random.random() < 0.15:
        g.data["plane"] = "xz"  # type: ignore[assignment]
        places = g.section("sketch")
        for point, (x, y) in [*places.items()]:
            places[point] = [x, 0.0, y]
    return found


def named(g: Growing, link: str, points: Data) -> None:
    """Some coordinates as parameters, most of them with tolerances."""
    for point, at in points.items():
        if abs(at[0]) > 1 and g.random.random() < 0.3:
            name = f"{link}_{point}"
            tolerance = g.random.choice(
                ({"tolerance": 0.02}, {"tolerance": [-0.01, 0.05]}, {"tolerance": "ISO 2768-m"}, {})
            )
            g.section("parameters")[name] = {"value": f"{at[0]} mm", **tolerance}
            at[0] = name
