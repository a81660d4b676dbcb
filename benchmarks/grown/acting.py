"""Growers of what acts on a mechanism: masses, loads, springs, counterweights, friction, windows, parameters."""

from __future__ import annotations

import math
from typing import Any

from grown.laws import periodic
from grown.plane import Data, Growing, grows, rounded

HEAVY = 0.7
"""The share of moving links with a mass."""


def signals(g: Growing) -> list[tuple[str, str]]:
    """Signals of the motion with their units: of points, links, slides, drives."""
    found = [(f"{point}.{axis}", "mm") for _, point in g.points() for axis in "xy"]
    found += [(f"{point}.v{axis}", "mm/s") for _, point in g.points() for axis in "xy"]
    found += [(f"{link}.angle", "deg") for link in g.moving()] + [(f"{link}.omega", "deg/s") for link in g.moving()]
    found += [(f"{name}.s", "mm") for name, entry in g.section("joints").items() if _travels(entry)]
    return found


def _travels(entry: Data) -> bool:
    return "prismatic" in entry or "pin_in_slot" in entry


def any_point(g: Growing) -> tuple[str, str]:
    """A point of any link with the link."""
    link = g.random.choice([link for link in g.places if g.places[link]])
    return link, g.random.choice([*g.places[link]])


@grows("acting", "gravity", weight=3)
def masses(g: Growing) -> None:
    """Masses of some links, in every form."""
    for link in g.moving():
        points = [*g.places[link]]
        if g.random.random() > HEAVY or "mass" in g.section("bodies").get(link, {}):
            continue
        body: Data = {"mass": rounded(g.random.uniform(0.05, 3))}
        form = g.random.randrange(4)
        if form == 0 and len(points) > 1 and math.dist(*(g.places[link][p] for p in points[:2])) > 5:
            body["shape"] = f"rod {points[0]}-{points[1]}"
        elif form == 1 and points:
            body["shape"] = f"disc 30 mm at {points[0]}"
        elif form == 2 and points:
            body["shape"] = f"point {points[0]}"
        else:
            body |= {
                "com": [rounded(g.random.uniform(-40, 40)) for _ in "xy"],
                "inertia": rounded(g.random.uniform(50, 2000)),
            }
        g.section("bodies")[link] = body
    g.data["gravity"] = g.random.choice(("earth", "earth", [0, 0], "earth along [3, -4]", [0, "-1.62 m/s^2"]))  # type: ignore[assignment]


def amount(g: Growing, size: float, unit: str) -> Any:
    """A force or torque: a number, or an expression of the time, a table, the motion."""
    form, value = g.random.randrange(6), rounded(g.random.uniform(-1, 1) * size)
    if form < 2:
        return f"{value} {unit}"
    if form == 2:
        return f"{value} {unit}*sin(360 deg*t/(1 s))"
    if form == 3:
        return f"{value} {unit}*step5(t, 0.2 s, 0, 0.6 s, 1)"
    if form == 4:
        return f"{value} {unit}*{scaled(g)}"
    return f"{periodic(g, size, unit)}(t)"


def scaled(g: Growing) -> str:
    """A signal of the motion as a pure number about 1."""
    name, unit = g.random.choice(signals(g))
    per = {"mm": "100 mm", "mm/s": "500 mm/s", "deg": "90 deg", "deg/s": "300 deg/s"}[unit]
    return g.random.choice((f"{name}/({per})", f"abs({name})/({per})", f"sin({name}/({per})*60 deg)"))


@grows("acting", "load", "loads", "windows", weight=4)
def load(g: Growing) -> None:
    """A force or a torque, in every form."""
    link, point = any_point(g)
    at = point if g.random.random() < 0.6 else [rounded(g.random.uniform(-50, 50)) for _ in "xy"]
    slides = [(name, e["prismatic"]) for name, e in g.section("joints").items() if "prismatic" in e]
    form = g.random.randrange(5)
    entry: Data = {"on": link}
    if form == 0:
        entry["torque"] = amount(g, 5, "N*m")
    elif form == 1 and slides:
        name, (base, slider_) = g.random.choice(slides)
        entry = {"on": slider_, "at": next(iter(g.places[slider_])), "along": name, "force": amount(g, 100, "N")}
        link = slider_
        if g.random.random() < 0.4:
            entry["against"] = base
    else:
        entry |= {"at": at, "force": [amount(g, 60, "N"), amount(g, 60, "N")]}
        if form == 2:
            entry["in"] = link
    if "against" not in entry and g.random.random() < 0.2:
        entry["against"] = g.random.choice([other for other in g.places if other != link])
    if g.random.random() < 0.2:
        entry["window"] = window(g)
    g.section("loads")[g.name("load")] = entry


def window(g: Growing) -> str:
    """A window in time or in a drive's value."""
    name = g.name("win")
    turning = [drive for drive, entry in g.section("drives").items() if "turns" in entry]
    if turning and g.random.random() < 0.3:
        g.section("windows")[name] = {f"{g.random.choice(turning)}.angle": ["-170 deg", "170 deg"]}
    else:
        g.section("windows")[name] = [f"{g.random.choice((0, 0.1, 0.25))} s", f"{g.random.choice((0.5, 0.75, 1))} s"]
    return name


@grows("acting", "spring", "springs", weight=3)
def spring(g: Growing) -> None:
    """A spring, gas spring or damper between two points, or two links."""
    name, links = g.name("spring"), g.moving()
    if g.random.random() < 0.3:
        link = g.random.choice(links)
        on = g.random.choice([other for other in g.places if other != link])
        entry: Data = {"turns": link, "on": on}
        per, force, size = "N*m/rad", "N*m", "deg"
        length, damping = 30.0, "0.02 N*m*s/rad"
    else:
        a, b = (any_point(g) for _ in "ab")
        length = math.dist(g.places[a[0]][a[1]], g.places[b[0]][b[1]])
        if a[0] == b[0] or length < 20:
            return
        entry = {"from": a[1], "to": b[1], "in": [a[0], b[0]]}
        per, force, size, damping = "N/mm", "N", "mm", "0.05 N*s/mm"
    form = g.random.randrange(5)
    if form == 0 and "from" in entry:
        entry |= {"gas": "200 N", "progression": 1.3, "length": [rounded(length / 2), rounded(1.7 * length)]}
        if g.random.random() < 0.4:
            entry["exponent"] = 1.2
    elif form == 1:
        table = g.name("curve")
        reach = 720.0 if size == "deg" else 4 * length
        low = -reach if size == "deg" else 0.0
        points = [[low, -20], [low + (length - low) / 2, -4], [length, 5], [reach, 40]]
        points = [[f"{x} {size}", f"{y} {force}"] for x, y in points]
        g.section("tables")[table] = {"points": points, "between": g.random.choice(("linear", "cubic"))}
        entry["force" if "from" in entry else "torque"] = table
    elif form == 2:
        entry["damping"] = damping
    else:
        entry |= {"stiffness": f"{rounded(g.random.uniform(0, 3))} {per}", "free": f"{rounded(length * 0.8)} {size}"}
        if g.random.random() < 0.3:
            entry["preload"] = f"5 {force}"
    if g.random.random() < 0.3:
        entry["damping"] = damping
    g.section("springs")[name] = entry


@grows("acting", "counterweight", "counterweights", weight=1.5)
def counterweight(g: Growing) -> None:
    """A mass added to a link."""
    at = g.random.choice(("30 at 180 deg", [10, -25], "25 at 70 deg"))
    entry = {"on": g.random.choice(g.moving()), "mass": rounded(g.random.uniform(0.1, 2)), "at": at}
    if g.random.random() < 0.4:
        entry["inertia"] = 200
    g.section("counterweights")[g.name("cw")] = entry


@grows("acting", "friction", weight=2.5)
def friction(g: Growing) -> None:
    """Friction in a pin, a slide or a contact."""
    joints, name = g.section("joints"), g.name("rub")
    pins = [(pin, a, b) for pin, a, b in g.shafts if sum(pin in points for points in g.places.values()) > 1]
    taken = {(e.get("pin") or e.get("slide") or e.get("contact")) for e in g.section("friction").values()}
    slides = [n for n, e in joints.items() if "prismatic" in e]
    contacts = [n for n, e in joints.items() if "pin_in_slot" in e]
    contacts += [n for n, e in g.section("cams").items() if e.get("closed", "force") == "force"]
    pin, a, b = g.random.choice(pins) if pins else ("", "", "")
    choices: list[Data] = [{"pin": pin, "radius": 5, "in": [b, a]}] if pins else []
    choices += [{"slide": g.random.choice(slides), "length": 60}] if slides else []
    if contacts:
        contact = g.random.choice(contacts)
        rolls = "roller" in g.section("cams").get(contact, {}) or g.random.random() < 0.3
        choices.append({"contact": contact, **({"radius": 3} if contact in g.section("cams") and rolls else {})})
    if not choices:
        return
    entry = g.random.choice(choices)
    if (entry.get("pin") or entry.get("slide") or entry.get("contact")) in taken:
        return
    form = g.random.randrange(4)
    if form == 0:
        entry["viscous"] = {"pin": "0.01 N*m*s/rad", "slide": "0.02 N*s/mm"}.get(next(iter(entry)), "0.02 N*s/mm")
    else:
        entry["coefficient"] = g.random.choice((0.05, 0.1, 0.2, 0.3))
    if form == 1:
        entry["static"] = 0.4
    if form == 2:
        entry["coefficient"] = "0.1 + 0.05*sin(360 deg*t/(1 s))"
    g.section("friction")[name] = entry


@grows("acting", "parameters", weight=2)
def parameters(g: Growing) -> None:
    """Numbers of springs, loads and wheels as parameters with tolerances; lengths get theirs when links are written."""
    name = g.name("par")
    tolerance = g.random.choice((0.05, [-0.02, 0.03], "ISO 2768-m", "h7", {"limits": "js9", "distribution": "normal"}))
    g.section("parameters")[name] = {"value": f"{rounded(g.random.uniform(20, 90))} mm", "tolerance": tolerance}
    link = g.random.choice(g.moving())
    g.section("bodies").setdefault(link, {}).setdefault("more", {})[g.name("Q")] = [
        name,
        rounded(g.random.uniform(-20, 20)),
    ]
