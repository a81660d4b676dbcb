"""Growers of what is asked of a mechanism: measures, requirements, studies, exports."""

from __future__ import annotations

from grown.acting import signals, window
from grown.plane import Data, Growing, grows

REDUCED = ("span", "max", "min", "extremes", "mean", "rms")


def outputs(g: Growing) -> list[str]:
    """Signals of motion and forces, and expressions of them."""
    found = [name for name, _ in signals(g)]
    for name, entry in g.section("drives").items():
        turns = "turns" in entry
        found += [f"{name}.{'torque' if turns else 'force'}", f"{name}.power"]
    found += ["shaking.x", "shaking.moment", "energy.kinetic", "energy.stored"]
    pins = [(a, b) for _, a, b in g.shafts]
    found += [f"force({a}, {b}).x" for a, b in pins] + [f"hypot(force({a}, {b}).x, force({a}, {b}).y)" for a, b in pins]
    found += [f"pole({g.random.choice(g.moving())}, frame).x"]
    for name, entry in g.section("joints").items():
        kind = next(iter(entry))
        own = {
            "gears": ("force", "speed"),
            "belt": ("left", "tangential"),
            "rack": ("tangential",),
            "rolling": ("normal",),
        }
        own |= {
            "pin_in_slot": ("force", "s"),
            "weld": ("torque",),
            "differential": ("torque",),
            "geneva": ("force", "engaged"),
        }
        found += [f"{name}.{signal}" for signal in own.get(kind, ())]
    found += [f"{name}.{signal}" for name in g.section("cams") for signal in ("force", "pressure")]
    found += [f"{name}.power" for section in ("springs", "friction") for name in g.section(section)]
    return found


@grows("measures", "measures", *REDUCED, weight=4)
def reduced(g: Growing) -> None:
    """An extreme or a mean of a signal or an expression."""
    signal = g.random.choice(outputs(g))
    if g.random.random() < 0.2:
        signal = g.random.choice((f"abs({signal})", f"-2*({signal})", f"{signal} + 0*t/(1 s)*{signal}"))
    kind = g.random.choice(REDUCED)
    entry: Data = {kind: signal}
    if g.random.random() < 0.25:
        entry["window"] = window(g)
    g.section("measures")[g.name("m")] = entry


@grows("measures", "value")
def value(g: Growing) -> None:
    """A value at an instant."""
    name, unit = g.random.choice(signals(g))
    where = g.random.choice(("start", "end", f"max {g.random.choice(signals(g))[0]}", f"min {name}"))
    entry: Data = {"value": name, "where": where}
    if unit == "deg" and g.random.random() < 0.5:
        entry["wrap"] = [0, 360]
    g.section("measures")[g.name("m")] = entry


@grows("measures", "path", "straightness")
def of_path(g: Growing) -> None:
    """The length of a path, or how straight it is."""
    kind = g.random.choice(("path", "straightness"))
    g.section("measures")[g.name("m")] = {kind: g.random.choice(g.points())[1]}


@grows("measures", "dwell")
def dwell(g: Growing) -> None:
    """A dwell."""
    name, unit = g.random.choice(signals(g))
    g.section("measures")[g.name("m")] = {"dwell": name, "within": f"{g.random.choice((0.5, 2, 20))} {unit}"}


@grows("measures", "efficiency", "share")
def efficiency(g: Growing) -> None:
    """What part of the energy a load takes."""
    loads, others = [*g.section("loads")], [*g.section("springs"), *g.section("friction")]
    if not loads:
        return
    useful = [g.random.choice(loads)]
    entry: Data = {"efficiency": useful}
    if others and g.random.random() < 0.5:
        entry = {"share": [g.random.choice(others)], "useful": useful}
    g.section("measures")[g.name("m")] = entry


@grows("measures", "require", weight=0.7)
def require(g: Growing) -> None:
    """A limit of a measure."""
    there = [name for name, entry in g.section("measures").items() if next(iter(entry)) in (*REDUCED, "path")]
    if there:
        g.section("require")[g.random.choice(there)] = g.random.choice((">= -1e9", "<= 1e9", "-1e9 .. 1e9", "<= 1"))


@grows("studies", "cycle", weight=0)
def cycle(g: Growing) -> None:
    """The motion."""
    entry: Data = {"samples": g.random.choice((4, 6, 8, 12))}
    constant = [n for n, e in g.section("drives").items() if e.get("turns") and e.get("speed") in (360.0, -360.0)]
    if constant and g.random.random() < 0.5:
        entry["turns"] = f"{g.random.choice((1, 1, 0.5))} {g.random.choice(constant)}"
    else:
        entry[g.random.choice(("duration", "duration", "period"))] = g.random.choice(("1 s", "1 s", "0.5 s", "1.2 s"))
    if g.carried or g.random.random() < 0.05:
        entry["through"] = "keep"
    g.section("studies")["cycle"] = entry


@grows("studies", "limits")
def limits(g: Growing) -> None:
    """Ranges of drives."""
    g.section("studies")["limits"] = {"samples": 60}


@grows("studies", "modes")
def modes(g: Growing) -> None:
    """All assembly modes."""
    drives = [*g.section("drives")]
    g.section("studies")["modes"] = {"drive": g.random.choice(drives)} if len(drives) > 1 else {}


def lengths(g: Growing) -> list[str]:
    """Parameters with a value of their own, when links are written."""
    return [name for name, entry in g.section("parameters").items() if isinstance(entry, dict)]


@grows("studies", "sweep", weight=1.5)
def sweep(g: Growing) -> None:
    """A few samples of some parameters."""
    if not (there := lengths(g)):
        return
    names = g.random.sample(there, min(len(there), 2))
    vary: Data = {}
    for name in names:
        middle = float(str(g.section("parameters")[name]["value"]).split()[0])
        low, high = middle - abs(middle) / 500, middle + abs(middle) / 500
        vary[name] = g.random.choice(([low, high], {"uniform": [low, high]}, {"normal": middle, "sigma": 0.02}))
    entry: Data = {"vary": vary, "kernel": "numpy", "poses": 4}
    if any(isinstance(values, dict) for values in vary.values()):
        entry |= {"samples": 6, "plan": g.random.choice(("latin", "random", "sobol"))}
    if g.random.random() < 0.6 or not g.section("measures"):
        entry["outputs"] = g.random.sample(every := outputs(g), min(3, len(every)))
    g.section("studies")["sweep"] = entry


@grows("studies", "accuracy", weight=1.5)
def accuracy(g: Growing) -> None:
    """Effects of tolerances and clearances."""
    if not lengths(g):
        return
    entry: Data = {"samples": g.random.choice((0, 8)), "kernel": "numpy", "poses": 3}
    entry["outputs"] = g.random.sample(found := outputs(g), min(2, len(found)))
    if g.random.random() < 0.3:
        pins = [pin for pin, a, b in g.shafts if sum(pin in points for points in g.places.values()) == 2]
        if pins:
            entry["clearances"] = {g.random.choice(pins): 0.02}
    if g.random.random() < 0.2:
        entry["thermal"] = {"warm": {"change": [0, 40], "material": "steel"}}
    g.section("studies")["accuracy"] = entry


@grows("studies", "cam", weight=0.5)
def cam_study(g: Growing) -> None:
    """The plate of a cam, coarse."""
    if g.section("cams"):
        entry = {"cam": g.random.choice([*g.section("cams")]), "steps": 60, "tolerance": "0.05 mm"}
        g.section("studies")["cam"] = entry


@grows("studies", "workspace", weight=0.15)
def workspace(g: Growing) -> None:
    """The curve or region of a point, coarse."""
    if len(g.known) < 6:
        g.section("studies")["workspace"] = {"point": g.random.choice(g.points())[1], "chord": 0.01, "modes": "own"}
