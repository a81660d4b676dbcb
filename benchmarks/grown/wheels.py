"""Growers of wheels and cams: what turns or pushes something on."""

from __future__ import annotations

import math

from grown.groups import drive, swing, two_bases
from grown.laws import motion_law
from grown.plane import CALM, FRAME, SMALL, XY, Data, Growing, away, grows, heading, rounded


def shaft(g: Growing) -> tuple[str, str, str] | None:
    """A pin about which a known link turns on another."""
    there = [one for one in g.shafts if one[1] in g.known and one[2] in g.known and one[0] in g.places[one[1]]]
    if not there:
        return None
    pin, a, b = g.random.choice(there)
    return (
        (pin, a, b) if b != FRAME and (a == FRAME or g.random.random() < 0.7) else (pin, b, a) if a != FRAME else None
    )


def on_shaft(g: Growing, carrier: str, at: XY, reach: float) -> tuple[str, str]:
    """A new link on a pin of a known one: the pin, the link."""
    link = g.link(at, reach)
    pin = g.put(at, carrier, link)
    if g.random.random() < 0.6:
        g.hint(link)
    else:
        x, y, _ = g.axes[link]
        g.axes[link] = (x, y, 0.0)
    return pin, link


def _carried(entry: Data, carrier: str) -> Data:
    return entry if carrier == FRAME else entry | {"carrier": carrier}


@grows("groups", "gears", weight=2.5)
def gears(g: Growing) -> None:
    """A gear in mesh with a known one on its carrier, also in a ring or as one."""
    if (found := shaft(g)) is None:
        return
    pin, carrier, wheel = found
    centre = g.places[carrier][pin]
    distance = g.random.uniform(40, 120)
    other, link = on_shaft(g, carrier, away(centre, distance, g.random.uniform(0, 360)), g.reach[wheel])
    teeth = [g.random.randrange(15, 60), g.random.randrange(15, 60)]
    entry: Data = {"gears": [wheel, link], "centres": [pin, other]}
    if g.random.random() < 0.3:
        big, small = sorted((rounded(distance * 1.5), rounded(distance / 2)), reverse=True)
        ring = g.random.random() < 0.5
        entry |= {"radii": [big, small] if ring else [small, big], "internal": wheel if ring else link}
    elif g.random.random() < 0.4:
        entry |= {"teeth": teeth, "module": rounded(2 * distance / sum(teeth))}
    elif g.random.random() < 0.5:
        entry |= {"radii": [first := rounded(distance * g.random.uniform(0.3, 0.7)), rounded(distance - first)]}
    else:
        entry |= {"teeth": teeth}
    if g.random.random() < 0.3:
        entry["pressure_angle"] = g.random.choice((14.5, 25) if "module" in entry else (0, 14.5, 25))
    g.section("joints")[g.name("mesh")] = _carried(entry, carrier)
    _turns(g, wheel, link)
    g.shafts.append((other, carrier, link))


def _turns(g: Growing, wheel: str, link: str) -> None:
    if wheel in g.turning:
        g.turning.add(link)
        g.reach[link] = SMALL
    g.settle(link)


@grows("groups", "belt", weight=1.5)
def belt(g: Growing) -> None:
    """A belt or chain to a new wheel on the carrier of a known one."""
    if (found := shaft(g)) is None:
        return
    pin, carrier, wheel = found
    distance = g.random.uniform(90, 160)
    at = away(g.places[carrier][pin], distance, g.random.uniform(0, 360))
    other, link = on_shaft(g, carrier, at, g.reach[wheel])
    entry: Data = {"belt": [wheel, link], "centres": [pin, other]}
    if g.random.random() < 0.5:
        entry |= {"radii": [rounded(g.random.uniform(12, 40)), rounded(g.random.uniform(12, 40))]}
    else:
        entry |= {"teeth": [g.random.randrange(15, 40), g.random.randrange(15, 40)], "pitch": 5}
    if g.random.random() < 0.4:
        entry["crossed"] = True
    if g.random.random() < 0.5:
        entry["pretension"] = rounded(g.random.uniform(10, 400))
        if g.random.random() < 0.5:
            entry["friction"] = 0.4
    g.section("joints")[g.name("belt")] = _carried(entry, carrier)
    _turns(g, wheel, link)
    g.shafts.append((other, carrier, link))


@grows("groups", "rack", weight=1.5)
def rack(g: Growing) -> None:
    """A rack on the carrier of a known wheel, or a pinion on that of a known slide."""
    slides = [e["prismatic"] for e in g.section("joints").values() if {*e.get("prismatic", "?")} <= {*g.known}]
    radius = rounded(g.random.uniform(15, 40))
    if slides and g.random.random() < 0.4:
        carrier, slider = g.random.choice(slides)
        slide = next(e for e in g.section("joints").values() if e.get("prismatic") == [carrier, slider])
        turned = float(slide["line"][0]().removesuffix(" deg").split(" at ")[1]) + g.axes[carrier][2]
        foot = away(g.home[slider], g.random.uniform(20, 80), g.random.uniform(0, 360))
        pin, link = on_shaft(g, carrier, away(foot, radius, turned + g.random.choice((90, -90))), CALM)
        entry: Data = {"rack": [link, slider], "centre": pin, "pitch_line": g.line(slider, foot, turned)}
    elif (found := shaft(g)) is not None and found[2] not in g.turning:
        pin, carrier, pinion = found
        turned = g.random.uniform(0, 360)
        foot = away(g.places[carrier][pin], radius, turned + g.random.choice((90, -90)))
        link = g.link(foot)
        g.slide(carrier, link, away(foot, 30, g.random.uniform(0, 360)), turned)
        entry = {"rack": [pinion, link], "centre": pin, "pitch_line": g.line(link, foot, turned)}
        if g.random.random() < 0.5:
            g.hint(link)
    else:
        return
    if g.random.random() < 0.5:
        entry["radius"] = radius
    else:
        entry |= {"teeth": 20, "module": rounded(radius / 10)}
    g.section("joints")[g.name("rack")] = _carried(entry, carrier)
    g.settle(link)


@grows("groups", "rolling", weight=2)
def rolling(g: Growing) -> None:
    """A disc on a rod, that rolls along a line, on a circle or in a ring of a known link."""
    a, b, at, centre = two_bases(g)
    rod, disc = g.link(centre, 60), g.link(centre, 40)
    g.pin(at, a, rod)
    pin = g.pin(centre, rod, disc)
    radius, turned = rounded(g.random.uniform(10, 45)), heading(at, centre) + g.random.uniform(-40, 40)
    touch = away(centre, radius, turned + g.random.choice((90, -90)))
    entry: Data = {
        "rolling": [disc, b],
        "centre": pin if pin in g.places[disc] else g.put(centre, disc),
        "radius": radius,
    }
    if g.random.random() < 0.5:
        entry["on_line"] = g.line(b, touch, turned)
    else:
        inside, large = g.random.random() < 0.4, rounded(g.random.uniform(80, 200))
        outward = heading(touch, centre)
        middle = away(touch, large, outward + (0 if inside else 180))
        entry["on_circle"] = {"centre": g.put(middle, b), "radius": large, **({"inside": True} if inside else {})}
    g.section("joints")[g.name("roll")] = entry
    g.hint(rod)
    g.hint(disc)
    g.settle(rod, disc)


@grows("groups", "differential", weight=1.2)
def differential(g: Growing) -> None:
    """A third shaft on the frame or a known link whose angle follows from two known links."""
    if len(g.known) < 3:
        return
    on = g.base()
    others = [link for link in g.known if link not in (FRAME, on)]
    if len(others) < 2:
        return
    first, second = g.random.sample(others[-5:], 2)
    _, link = on_shaft(g, on, g.spot(on), SMALL if {first, second} & g.turning else CALM)
    weights = g.random.choice(([1, 1, -2], [2, -1, -1], [24, 72, -96], [1, -1, 3]))
    entry: Data = {"differential": g.random.sample([link, first, second], 3), "weights": weights}
    g.section("joints")[g.name("diff")] = entry if on == FRAME else entry | {"on": on}
    if {first, second} & g.turning:
        g.turning.add(link)
    g.settle(link)


@grows("groups", "coupling", weight=1.2)
def coupling(g: Growing) -> None:
    """A link that follows a drive: pinned or sliding on a known one."""
    drives = {name: entry for name, entry in g.section("drives").items() if "turns" in entry and "output" not in entry}
    if not drives:
        return
    motor, base = g.random.choice([*drives]), g.base()
    at = g.spot(base)
    follows = g.random.choice(("0.5*{m}.angle + {c} deg", "{c} deg + 8 deg*sin({m}.angle)", "{c} deg - {m}.angle/3"))
    if g.random.random() < 0.7:
        pin, link = on_shaft(g, base, at, SMALL)
        g.section("assembly").pop(next(reversed(g.places[link])), None)
        g.shafts.append((pin, base, link))
    else:
        link = g.link(at)
        g.slide(base, link, at, g.random.uniform(0, 360))
        follows = "{c} mm + 10 mm*cos({m}.angle)"
    text = follows.format(m=motor, c=rounded(g.random.uniform(-30, 30)))
    g.section("joints")[g.name("follow")] = {"coupling": [link, base], "follows": text}
    g.turning.add(link)
    g.reach[link] = SMALL
    g.settle(link)


@grows("groups", "geneva", weight=0.8)
def geneva(g: Growing) -> None:
    """A driver that a drive turns, and a wheel that it turns on."""
    if len(g.section("drives")) > 3:
        return
    at, slots = g.spot(FRAME), g.random.choice((3, 4, 5, 6, 8))
    distance, turned = rounded(g.random.uniform(60, 120)), g.random.uniform(0, 360)
    driver, wheel = g.link(at, SMALL), g.link(away(at, distance, turned), SMALL)
    centres = g.put(at, FRAME, driver), g.put(away(at, distance, turned), FRAME, wheel)
    radius = distance * math.sin(math.pi / slots)
    pins = [g.put(away(at, radius, g.random.uniform(0, 360)), driver)]
    if slots > 3 and g.random.random() < 0.3:
        own = g.places[driver][pins[0]]
        pins.append(g.put((2 * at[0] - own[0], 2 * at[1] - own[1]), driver))
    arc = (0.5 * (1 - math.cos(math.pi / slots)) + 0.5 * math.sin(math.pi / slots)) * distance
    entry = {"geneva": [driver, wheel], "centres": [*centres], "pins": pins, "slots": slots, "arc": arc}
    g.section("joints")[g.name("index")] = entry
    drive(g, "turns", driver, FRAME, swing(g), full=True)
    g.turning |= {driver, wheel}
    g.settle(driver, wheel)
    g.shafts += [(centres[0], FRAME, driver), (centres[1], FRAME, wheel)]


CONTACTS = ("roller", "roller", "knife", "face")


@grows("groups", "cam", "cams", weight=1.5)
def cam(g: Growing) -> None:
    """A cam on a shaft of its own, with a follower that swings or slides; the law begins with a dwell."""
    if len(g.section("drives")) > 3:
        return
    at, base = g.spot(FRAME), rounded(g.random.uniform(30, 60))
    disc, motor = g.link(at, SMALL), g.name("motor")
    centre = g.put(at, FRAME, disc)
    start = g.random.uniform(-180, 180)
    speed = g.random.choice((360, -360, 180))
    g.section("drives")[motor] = {"turns": disc, "on": FRAME, "speed": speed, "start": rounded(start)}
    x, y, _ = g.axes[disc]
    g.axes[disc] = (x, y, start)
    entry: Data = {"cam": disc, "follower": "", "on": FRAME, "base": base}
    # The law begins in the middle of its dwell, whichever way the cam turns.
    entry["phase"] = rounded(30 - start * math.copysign(1, speed)) % 360
    (swinging if g.random.random() < 0.5 else sliding)(g, entry, at, centre, base)
    if g.random.random() < 0.2:
        entry["closed"] = g.random.choice(("groove", "conjugate", "yoke")) if "roller" in entry else "force"
    g.section("cams")[g.name("cam")] = entry
    g.turning.add(disc)
    g.settle(disc, entry["follower"])
    g.shafts.append((centre, FRAME, disc))


def _contact(g: Growing, entry: Data, link: str, at: XY) -> None:
    entry["knife" if "knife" in entry else "at"] = g.put(at, link)


def swinging(g: Growing, entry: Data, at: XY, centre: str, base: float) -> None:
    """A follower pinned on the frame."""
    roller = 0.0 if g.random.random() < 0.2 else rounded(g.random.uniform(6, 15))
    entry |= {"roller": roller} if roller else {"knife": ""}
    apart, turned = g.random.uniform(110, 150), g.random.uniform(0, 360)
    pivot = away(at, apart, turned)
    reach = base + roller
    arm = apart + reach * g.random.uniform(-0.5, 0.5)
    side = g.random.choice((1, -1))
    lean = math.degrees(math.acos((apart**2 + arm**2 - reach**2) / (2 * apart * arm)))
    # Seen from the shaft to the pivot, the contact is on the left where the arm leans clockwise from the line back.
    tip = away(pivot, arm, turned + 180 - side * lean)
    link = g.link(pivot)
    pin = g.put(pivot, FRAME, link)
    entry |= {"follower": link, "side": f"{'left' if side > 0 else 'right'} of {centre}-{pin}"}
    entry["law"] = motion_law(g, g.random.uniform(5, 14), "deg", "angle", rest=0.2)
    _contact(g, entry, link, tip)
    g.shafts.append((pin, FRAME, link))


def sliding(g: Growing, entry: Data, at: XY, centre: str, base: float) -> None:
    """A follower that slides on the frame, with a roller, an edge or a flat face."""
    turned, kind = g.random.uniform(0, 360), g.random.choice(CONTACTS)
    roller = rounded(g.random.uniform(6, 15)) if kind == "roller" else 0.0
    offset = 0.0 if g.random.random() < 0.6 else g.random.uniform(-10, 10)
    rise = math.sqrt((base + roller) ** 2 - offset**2) if kind != "face" else base
    tip = away(away(at, rise, turned), offset, turned + 90)
    link = g.link(tip)
    entry |= {"follower": link, "law": motion_law(g, g.random.uniform(5, 14), "mm", "angle", rest=0.2)}
    g.slide(FRAME, link, away(tip, 40, turned), turned)
    if kind == "face":
        entry["face"] = g.line(link, tip, turned + 90)
        return
    entry |= {"roller": roller} if roller else {"knife": ""}
    _contact(g, entry, link, tip)
