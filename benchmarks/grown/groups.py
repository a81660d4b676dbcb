"""Growers of drives and of groups: cranks, sliders, dyads, larger groups, pins in slots, cylinders, welds, drives that
move points or angles, outputs, paths, redundant bars and rollers."""

from __future__ import annotations

import math

from grown.laws import Value, law
from grown.plane import CALM, FRAME, SMALL, XY, Data, Growing, away, grows, heading, left_of, rounded

GROUPS: dict[str, tuple[tuple[str, str], ...]] = {
    # Joints between the new links a, b, c ... and known ones (1, 2 ...).
    "triad": (("1", "a"), ("a", "m"), ("2", "b"), ("b", "m"), ("3", "c"), ("c", "m")),
    "double triad": (
        ("1", "a"), ("a", "m"), ("2", "b"), ("b", "m"), ("m", "n"), ("3", "c"), ("c", "n"), ("4", "d"), ("d", "n"),
    ),
    "class IV": (("1", "m"), ("m", "a"), ("a", "n"), ("m", "b"), ("b", "n"), ("n", "2")),
}  # fmt: skip
"""Assur groups of class II, III and IV by their joints."""


def drive(g: Growing, verb: str, link: str, on: str, size: float, full: bool = False) -> str:
    """A drive between two links at their joint, with a law of its own."""
    name = g.name("motor")
    unit = "deg" if verb == "turns" else "mm"
    value = _turned(g, link, on) if verb == "turns" else _travel(g, link, on)
    g.section("drives")[name] = {verb: link, "on": on, **law(g, value, size, unit, full)}
    return name


def _turned(g: Growing, link: str, on: str) -> Value:
    return lambda: g.angle(link, on)


def _travel(g: Growing, link: str, on: str) -> Value:
    """The way from the point of ``on`` to that of ``link`` along the line of their slide."""
    entry = next(e for e in g.section("joints").values() if {*e.get("prismatic", ())} == {link, on})
    return lambda: _along(g, entry, link, on)


def _along(g: Growing, entry: Data, link: str, on: str) -> float:
    texts = dict(zip(entry["prismatic"], (line() for line in entry["line"]), strict=True))
    (start, turned), (end, _) = (texts[name].removesuffix(" deg").split(" at ") for name in (on, link))
    (x, y), (u, v) = g.places[on][start], g.places[link][end]
    direction = math.radians(float(turned) + g.axes[on][2])
    return (u - x) * math.cos(direction) + (v - y) * math.sin(direction)


def swing(g: Growing) -> float:
    """How far a drive goes (deg or mm)."""
    return rounded(g.random.choice((1, -1)) * g.random.uniform(3, 18))


# Links that a drive moves at their joint.


@grows("drives", "revolute", "drive.turns", "links", "joints", "drives", "assembly", "laws", "tables", weight=5)
def crank(g: Growing) -> None:
    """A link that a drive turns on a known one."""
    base = g.base()
    at = g.spot(base)
    full = base == FRAME and g.random.random() < 0.4
    link = g.link(at, SMALL if full else CALM)
    pin = g.pin(at, base, link)
    if full:
        g.turning.add(link)
    drive(g, "turns", link, base, swing(g), full)
    g.shafts.append((pin, base, link))
    g.settle(link)


@grows("drives", "prismatic", "drive.slides", weight=2)
def slider(g: Growing) -> None:
    """A link that a drive slides on a known one."""
    base = g.base()
    at = g.spot(base)
    link = g.link(at)
    slide = g.slide(base, link, at, g.random.uniform(0, 360))
    if g.random.random() < 0.3:
        g.section("joints")[slide]["travel"] = [-400, 400]
    name = drive(g, "slides", link, base, swing(g))
    if g.random.random() < 0.3:
        entry = g.section("drives")[name]
        del entry["slides"], entry["on"]
        entry["extends"] = slide
    g.settle(link)


@grows("drives", "cylinders", "drive.extends", weight=2)
def lifted(g: Growing) -> None:
    """A link on a known one that a cylinder turns."""
    base = g.base()
    at = g.spot(base)
    link = g.link(at)
    pin = g.pin(at, base, link)
    foot = away(at, g.random.uniform(90, 160), g.random.uniform(0, 360))
    eye = away(at, g.random.uniform(50, 90), heading(at, foot) + g.random.choice((1, -1)) * g.random.uniform(45, 130))
    ends = g.put(foot, base), g.put(eye, link)
    name, motor = g.name("cyl"), g.name("motor")
    length = math.dist(foot, eye)
    g.section("cylinders")[name] = {
        "from": ends[0],
        "to": ends[1],
        "length": [rounded(length - 30), rounded(length + 30)],
    }
    _parts(g, name)
    g.section("drives")[motor] = {"extends": name, **law(g, lambda: length, rounded(swing(g) / 2), "mm")}
    g.tell(ends[1], eye)
    g.shafts.append((pin, base, link))
    g.settle(link)


def _parts(g: Growing, cylinder: str) -> None:
    for part in ("barrel", "rod"):
        if g.random.random() < 0.4:
            g.section("cylinders")[cylinder][part] = {"mass": rounded(g.random.uniform(0.1, 2)), "com": 30}


@grows("drives", "prescribed_place", "drive.moves", weight=1.5)
def guided_point(g: Growing) -> None:
    """Two links, the second of which a drive moves by a point along a line of a known one."""
    links, ends = _chain(g, 2)
    on = g.base()
    at = away(g.home[links[1]], g.random.uniform(10, 60), g.random.uniform(0, 360))
    point = g.put(at, links[-1])
    direction, foot = g.random.uniform(0, 360), away(at, g.random.uniform(20, 100), g.random.uniform(0, 360))
    base, name = g.put(foot, on), g.name("motor")
    along = (at[0] - foot[0]) * math.cos(math.radians(direction)) + (at[1] - foot[1]) * math.sin(
        math.radians(direction)
    )
    entry: Data = {"moves": links[-1], "at": point, "on": on, "along": g.line_of(on, base, direction)}
    g.section("drives")[name] = entry | law(g, lambda: along, rounded(swing(g) / 2), "mm")
    _closed(g, links, ends)


@grows("drives", "prescribed_angle", weight=1.5)
def guided_angle(g: Growing) -> None:
    """Two links more than a four-bar has, whose middle one a drive turns against a link that it shares no pin with."""
    links, ends = _chain(g, 3)
    name = g.name("motor")
    turned = _turned(g, links[1], FRAME)
    g.section("drives")[name] = {"turns": links[1], "on": FRAME, **law(g, turned, swing(g), "deg")}
    g.pin(ends[-1], links[-1], FRAME)
    for link in links:
        g.hint(link)
    g.settle(*links)


def _chain(g: Growing, count: int) -> tuple[list[str], list[XY]]:
    """New links in a row, the first pinned on a known moving one or the frame."""
    at = g.spot(base := g.base())
    places, links, turned = [at], [], g.random.uniform(0, 360)
    for _ in range(count):
        turned += g.random.choice((1, -1)) * g.random.uniform(35, 80)
        end = away(places[-1], g.random.uniform(70, 140), turned)
        links.append(g.link(away(places[-1], math.dist(places[-1], end) / 2, heading(places[-1], end)), 60))
        places.append(end)
    for place, a, b in zip(places, [base, *links], links, strict=False):
        g.pin(place, a, b)
    return links, places


def _closed(g: Growing, links: list[str], ends: list[XY]) -> None:
    """A chain whose end hangs in a slot of the frame, so that one freedom is left for a drive."""
    direction = heading(ends[-2], ends[-1]) + g.random.choice((1, -1)) * g.random.uniform(0, 50)
    slot(g, links[-1], FRAME, ends[-1], direction, "straight")
    for link in links:
        g.hint(link)
    g.settle(*links)


@grows("drives", "drive.output", weight=1.5)
def output(g: Growing) -> None:
    """A four-bar whose rocker follows the law, and whose crank has the drive; or a slider-crank."""
    at, name = g.spot(FRAME), g.name("motor")
    tip = away(at, g.random.uniform(50, 90), turned := g.random.uniform(0, 360))
    end = away(tip, g.random.uniform(100, 160), turned + g.random.choice((1, -1)) * g.random.uniform(40, 110))
    crank_, rod = g.link(at, SMALL), g.link(tip, 60)
    g.pin(at, FRAME, crank_)
    pin = g.pin(tip, crank_, rod)
    last = g.link(end, 60)
    joint = g.pin(end, rod, last)
    entry: Data = {"turns": crank_, "on": FRAME}
    if g.random.random() < 0.5:
        away_ = heading(tip, end) + g.random.choice((1, -1)) * g.random.uniform(50, 120)
        g.pin(away(end, g.random.uniform(70, 120), away_), FRAME, last)
        entry |= {"output": last, **law(g, _turned(g, last, FRAME), rounded(swing(g) / 2), "deg")}
    else:
        slide = g.slide(FRAME, last, end, heading(tip, end) + g.random.uniform(-35, 35))
        entry |= {"output": slide, **law(g, _travel(g, last, FRAME), rounded(swing(g) / 2), "mm")}
    g.section("drives")[name] = entry
    for point, place in ((pin, tip), (joint, end)):
        g.tell(point, place)
    g.hint(last)
    g.settle(crank_, rod, last)


@grows("drives", "paths", weight=1.2)
def path(g: Growing) -> None:
    """Two cranks and two rods whose common pin follows a path."""
    left, top = g.spot(FRAME), g.random.uniform(60, 100)
    right = away(left, g.random.uniform(60, 140), tilt := g.random.uniform(0, 360))
    tips = away(left, g.random.uniform(70, 100), tilt + 115), away(right, g.random.uniform(70, 100), tilt + 65)
    middle = away(tips[0], math.dist(*tips) / 2, heading(*tips))
    end = away(middle, top, tilt + 90)
    links = [g.link(at, 40) for at in (left, right, tips[0], tips[1])]
    for at, a, b in ((left, FRAME, 0), (right, FRAME, 1), (tips[0], links[0], 2), (tips[1], links[1], 3)):
        g.pin(at, a, links[b])
    point, name = g.put(end, links[2], links[3]), g.name("path")
    for link in links:
        g.hint(link)
    entry: Data = {"moves": g.random.choice(links[2:]), "at": point}
    way, size = g.random.choice(("line", "arc", "xy")), rounded(abs(swing(g)))
    if way == "line":
        to = away(end, 50, g.random.uniform(0, 360))
        entry |= {"line": [[rounded(value) for value in at] for at in (end, to)], **law(g, lambda: 0.0, size, "mm")}
    elif way == "arc":
        turned, radius = g.random.uniform(0, 360), g.random.uniform(15, 60)
        centre = [rounded(value) for value in away(end, -radius, turned)]
        entry |= {"arc": {"centre": centre, "radius": radius, "from": turned}, **law(g, lambda: 0.0, size, "mm")}
    else:
        for key, value in zip("xy", end, strict=True):
            entry[key] = f"{rounded(value)} + {rounded(swing(g) / 2)}*sin({g.random.choice((1, 2))}*360 deg*t/(1 s))"
    g.section("paths")[name] = entry
    for link in links[:2]:
        g.section("drives")[g.name("motor")] = {"turns": link, "on": FRAME, "output": name}
    g.settle(*links)


# Groups without a drive.


def slot(g: Growing, link: str, on: str, at: XY, direction: float, shape: str | None = None) -> str:
    """A point of a link at a place, in a slot of another along a direction there."""
    name, pin = g.name("slot"), g.put(at, link)
    shape = shape or g.random.choice(("straight", "arc", "curve"))
    entry: Data = {"pin_in_slot": [link, on], "pin": pin}
    if shape == "straight":
        entry["straight"] = g.line(on, away(at, g.random.uniform(-60, 60), direction), direction)
    elif shape == "arc":
        radius = g.random.uniform(60, 200)
        centre = g.put(away(at, radius, direction + g.random.choice((90, -90))), on)
        entry["arc"] = {"centre": centre, "radius": radius}
    else:
        bend = [g.random.uniform(-8, 8) for _ in range(4)]
        through = [[-120, bend[0]], [-50, bend[1]], [0, 0], [60, bend[2]], [120, bend[3]]]
        entry["curve"] = {"along": g.line(on, at, direction), "through": through}
    if g.random.random() < 0.1:
        entry["flank"] = g.random.choice(("left", "right", "both"))
    g.section("joints")[name] = entry
    return name


def two_bases(g: Growing) -> tuple[str, str, XY, XY]:
    """Two known links and a place on each, well away from each other."""
    a = g.base()
    b = g.base(a) if len(g.known) > 1 else FRAME
    at = g.spot(a)
    for _ in range(20):
        other = g.spot(b, at)
        if 40 < math.dist(at, other) < 400:
            break
    return a, b, at, other


def apex(g: Growing, at: XY, other: XY) -> XY:
    """A place with which two others make a triangle that isn't flat."""
    middle = away(at, math.dist(at, other) * g.random.uniform(0.35, 0.65), heading(at, other))
    side = g.random.choice((90, -90)) + g.random.uniform(-20, 20)
    return away(middle, max(60.0, math.dist(at, other) * g.random.uniform(0.5, 0.9)), heading(at, other) + side)


@grows("groups", "dyad.RRR", "revolute", weight=4)
def rrr(g: Growing) -> None:
    """Two links with three pins."""
    a, b, at, other = two_bases(g)
    top = apex(g, at, other)
    first, second = g.link(top), g.link(top)
    p, q, c = g.pin(at, a, first), g.pin(other, b, second), g.pin(top, first, second)
    side = "left" if left_of(at, other, top) else "right"
    if g.random.random() < 0.1:
        g.section("assembly")[c] = f"{side} of {p}-{q}"
    else:
        g.tell(c, top)
    g.settle(first, second)
    g.shafts += [(p, a, first), (q, b, second), (c, first, second)]


@grows("groups", "dyad.RRP", "prismatic", weight=3)
def rrp(g: Growing) -> None:
    """A rod and a slider."""
    a, b, at, other = two_bases(g)
    rod, block = g.link(other), g.link(other)
    p, c = g.pin(at, a, rod), g.pin(other, rod, block)
    turned = heading(at, other) + g.random.uniform(-45, 45)
    slide = g.slide(b, block, other, turned)
    if g.random.random() < 0.1:
        g.section("assembly")[c] = f"ahead of {p} along {slide}"
    else:
        g.tell(c, other)
    g.settle(rod, block)
    g.shafts += [(p, a, rod), (c, rod, block)]


@grows("groups", "dyad.RPR", "cylinders", weight=2)
def rpr(g: Growing) -> None:
    """Two links that slide along each other, pinned at both ends; or a cylinder without a drive."""
    a, b, at, other = two_bases(g)
    if g.random.random() < 0.4:
        name = g.name("cyl")
        ends = g.put(at, a), g.put(other, b)
        length = math.dist(at, other)
        g.section("cylinders")[name] = {
            "from": ends[0],
            "to": ends[1],
            "length": [rounded(length / 3), rounded(3 * length)],
        }
        _parts(g, name)
        return
    first, second = g.link(at), g.link(other)
    g.pin(at, a, first)
    g.pin(other, b, second)
    middle = away(at, math.dist(at, other) / 2, heading(at, other))
    g.slide(first, second, middle, heading(at, other) + g.random.uniform(-25, 25))
    g.hint(first)
    g.settle(first, second)


@grows("groups", "dyad.PRP", weight=1.5)
def prp(g: Growing) -> None:
    """Two sliders with a pin."""
    a, b, at, _ = two_bases(g)
    first, second = g.link(at), g.link(at)
    turned = g.random.uniform(0, 360)
    g.slide(a, first, at, turned)
    g.slide(b, second, at, turned + g.random.uniform(40, 140))
    g.shafts.append((g.pin(at, first, second), first, second))
    g.settle(first, second)


@grows("groups", "dyad.RPP", weight=1.5)
def rpp(g: Growing) -> None:
    """A pinned link that slides on a slider."""
    a, b, at, other = two_bases(g)
    first, second = g.link(at), g.link(other)
    turned = g.random.uniform(0, 360)
    g.pin(at, a, first)
    g.slide(first, second, at, turned)
    g.slide(b, second, other, turned + g.random.uniform(40, 140))
    g.settle(first, second)


@grows("groups", "prismatic", "revolute", weight=2.5)
def large_group(g: Growing) -> None:
    """A triad, a double triad or a group of class IV, with pins and some slides."""
    joints = GROUPS[g.random.choice([*GROUPS])]
    ends = list(dict.fromkeys(end for joint in joints for end in joint))
    centre = g.spot(g.base())
    new = {
        end: g.link(away(centre, g.random.uniform(20, 160), 360 * i / 5), 70)
        for i, end in enumerate(ends)
        if end.isalpha()
    }
    names = {end: g.base() for end in ends if end.isdigit()} | new
    if names.get("1") == names.get("2"):
        names["2"] = g.base(names["1"]) if len(g.known) > 1 else FRAME
    for a, b in joints:
        at = away(centre, g.random.uniform(30, 180), g.random.uniform(0, 360))
        if a.isdigit() and names[a] != FRAME:
            at = g.spot(names[a])
        if g.random.random() < 0.12:
            g.slide(names[a], names[b], at, g.random.uniform(0, 360))
        else:
            g.pin(at, names[a], names[b])
    for link in new.values():
        g.hint(link)
    g.settle(*new.values())


@grows("groups", "pin_in_slot", weight=3)
def in_slot(g: Growing) -> None:
    """A link pinned on a known one, with a pin in a slot of another, or a slot for a pin of the other."""
    a, b, at, other = two_bases(g)
    link = g.link(other)
    g.pin(at, a, link)
    turned = heading(at, other) + g.random.uniform(-50, 50)
    if g.random.random() < 0.5:
        slot(g, link, b, other, turned)
    else:
        slot(g, b, link, other, turned)
    g.hint(link)
    g.settle(link)


@grows("groups", "floating_angle", "floating_x", "floating_y", weight=1)
def floating(g: Growing) -> None:
    """A link on three pins in slots, of known links."""
    a, b, at, other = two_bases(g)
    link, turned = g.link(at), g.random.uniform(0, 360)
    third = apex(g, at, other)
    for base, place, tilt in ((a, at, 0), (b, other, 70), (g.base(), third, 120)):
        slot(g, link, base, place, turned + tilt + g.random.uniform(-20, 20))
    g.hint(link)
    g.hint(link)
    g.settle(link)


@grows("groups", "weld", weight=1)
def weld(g: Growing) -> None:
    """A link welded on a known moving one."""
    base = g.base(FRAME) if len(g.known) > 1 else FRAME
    if base == FRAME:
        return
    at = g.spot(base)
    link = g.link(at, g.reach[base])
    g.put(at, base, link)
    g.section("joints")[g.name("weld")] = {"weld": [link, base], "angle": lambda: g.angle(link, base)}
    g.settle(link)


@grows("groups", "stiffness", weight=0.8)
def third_bar(g: Growing) -> None:
    """A parallelogram on the frame and a known link that turns on it, with a third bar: it moves, though redundant."""
    cranks = [(pin, link) for pin, base, link in g.shafts if base == FRAME and pin in g.places[FRAME]]
    if not cranks:
        return
    pin, crank_ = g.random.choice(cranks)
    foot = g.places[FRAME][pin]
    arm = g.random.uniform(0.5, 1) * min(g.reach[crank_], 60), g.random.uniform(0, 360)
    tip = away(foot, *arm)
    bar = g.link(tip)
    g.pin(tip, crank_, bar)
    steps = [(g.random.uniform(60, 120), turned := g.random.uniform(0, 360))]
    if g.random.random() < 0.6:
        steps.append((g.random.uniform(60, 160), turned + g.random.choice((0, 60, -60))))
        g.data["stiffness"] = g.random.choice(({"joints": "equal"}, {"joints": "20 kN/mm"}, {}))
    for step in steps:
        rocker = g.link(away(foot, *step))
        g.pin(away(foot, *step), FRAME, rocker)
        point = g.pin(away(tip, *step), bar, rocker)
        g.tell(point, away(tip, *step))
        g.settle(rocker)
    g.settle(bar)
    if crank_ in g.turning:
        g.carried = True


@grows("groups", "stiffness", weight=0.5)
def second_roller(g: Growing) -> None:
    """A roller in a straight slot along a slide: it says again what the slide says."""
    slides = [entry for entry in g.section("joints").values() if "prismatic" in entry]
    if not slides:
        return
    entry = g.random.choice(slides)
    a, b = entry["prismatic"]
    text = entry["line"][0]()
    turned = float(text.removesuffix(" deg").split(" at ")[1]) + g.axes[a][2]
    at = away(g.home[b], g.random.uniform(20, 60), g.random.uniform(0, 360))
    slot(g, b, a, at, turned, "straight")
    g.data["stiffness"] = g.random.choice(({"joints": "equal"}, {}))


@grows("groups", "subassemblies", "copies", weight=1.2)
def copies(g: Growing) -> None:
    """A sub-assembly of two links on a port, placed once to three times, also mirrored."""
    name, reach = g.name("leg"), g.random.uniform(80, 130)
    foot, top = (0.0, -reach), (g.random.uniform(50, 90), g.random.uniform(-reach, 0))
    rod = rounded(math.hypot(*top))
    lower = rounded(math.dist(foot, top))
    g.section("subassemblies")[name] = {
        "ports": ["A"],
        "parameters": {"upper": f"{rod} mm", "lower": {"value": f"{lower} mm", "tolerance": 0.05}},
        "links": {
            FRAME: {"points": {"B": [rounded(value) for value in foot]}},
            "rod": {"points": {"A": [0, 0], "C": ["upper", 0]}, "mass": 0.2, "shape": "rod A-C"},
            "rocker": {"points": {"B": [0, 0], "C": ["lower", 0], "foot": ["lower", -40]}},
        },
        "assembly": {"C": f"{'left' if left_of((0.0, 0.0), foot, top) else 'right'} of A-B"},
        "measures": {"stride": {"span": "foot.x"}},
    }
    for _ in range(g.random.choice((1, 1, 2, 3))):
        base = g.base()
        at = g.spot(base)
        copy: Data = {"of": name, "join": {"A": g.put(at, base)}, "at": [rounded(value) for value in at]}
        if g.random.random() < 0.3:
            copy["mirrored"] = True
        if g.random.random() < 0.2:
            copy["parameters"] = {"lower": f"{rounded(lower * 1.01)} mm"}
        g.section("copies")[g.name("copy")] = copy
