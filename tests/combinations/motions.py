"""What every mechanism is combined with: a column of the matrix for each study, export and form of drive, and for the
page, copies and change points. A column makes the file, performs it and gives what is wrong with its figures.

Studies, exports and laws come from their registries: a registered one without a column fails by name.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import cache
from typing import Any

import numpy as np

from combinations.mechanisms import MECHANISMS, Mechanism
from combinations.performing import Data, run
from linkwright.results import Result

CLOSE = 1e-8
"""Of figures that two ways give, over the largest of their kind."""
SAMPLES = 12
Faults = Iterator[str]


@dataclass(frozen=True)
class Column:
    """A column: its name, its group (study, drive, export, other), what it makes of a mechanism."""

    name: str
    group: str
    perform: Callable[[Mechanism], Faults]


COLUMNS: dict[str, Column] = {}


def column(name: str, group: str) -> Callable[[Callable[[Mechanism], Faults]], Callable[[Mechanism], Faults]]:
    """Enter what a function makes of a mechanism as a column."""

    def entered(perform: Callable[[Mechanism], Faults]) -> Callable[[Mechanism], Faults]:
        assert name not in COLUMNS
        COLUMNS[name] = Column(name, group, perform)
        return perform

    return entered


# The motion that all drives prescribe.


def swing(mechanism: Mechanism) -> str:
    """The motor's angle over the time: it speeds up from the start, through 50 deg in a second."""
    return f"({mechanism.start} deg + 30 deg*t/(1 s) + 20 deg*(t/(1 s))^2)"


def turning(mechanism: Mechanism) -> Data:
    """The mechanism with a motor of constant speed, for a revolution, with measures."""
    data = mechanism.data
    motor = {"turns": "crank", "on": "frame", "speed": "60 rpm", "start": f"{mechanism.start} deg"}
    data["drives"] = {"motor": motor, **data.get("drives", {})}
    data["measures"] = {
        "travel": {"span": mechanism.signal},
        "torque": {"extremes": "motor.torque"},
        "effort": {"rms": "motor.torque"},
    }
    data["studies"] = {"cycle": {"turns": "1 motor", "samples": 2 * SAMPLES}}
    return data


def swinging(mechanism: Mechanism, **motor: Any) -> Data:
    """The mechanism with a motor that swings through a part of a revolution, given in any way."""
    data = mechanism.data
    stated = motor or {"turns": "crank", "on": "frame", "position": swing(mechanism)}
    data["drives"] = {"motor": stated, **data.get("drives", {})}
    data["studies"] = {"cycle": {"duration": "1 s", "samples": SAMPLES}}
    return data


@cache
def reference(name: str, full: bool = False) -> Result:
    """The motion with the motor on the crank: through a part of a revolution, or a ``full`` one."""
    mechanism = MECHANISMS[name]
    result: Result = run((turning if full else swinging)(mechanism)).cycle.result
    return result


def named(mechanism: Mechanism) -> str:
    """The name of a mechanism."""
    return next(name for name, one in MECHANISMS.items() if one is mechanism)


def start_of(mechanism: Mechanism) -> list[str]:
    """Where the pin B of the crank is at the start, as a file has it."""
    return [f"r*cos({mechanism.start} deg)", f"r*sin({mechanism.start} deg)"]


POSITIONS = ("x", "y", "angle", "s")
RATES = ("vx", "vy", "ax", "ay", "omega", "alpha", "v", "a")


def moving_signals(result: Result) -> list[str]:
    """The places of all points, links and slides of a motion with their rates."""
    signals = result.run.compiled.quantities.signals.by_text
    kinds = {text: signal.kind for text, signal in signals.items()}
    return [text for text in kinds if text.rpartition(".")[2] in POSITIONS + RATES and "(" not in text]


def differences(true: Result, found: Result, names: list[str] | None = None) -> Faults:
    """Where two motions at the same times differ in the signals that both have; angles by whole turns don't."""
    drives = {f"{drive}." for drive in true.run.compiled.graph.drives}
    both = [n for n in moving_signals(true) if n in found.names and not n.startswith(tuple(drives))]
    for name in names or both:
        a, b = true[name], found[name]
        off = np.abs(np.exp(1j * a) - np.exp(1j * b)) if name.endswith(".angle") else np.abs(a - b)
        size = max(float(np.abs(a).max()), usual_size(true, name))
        if not off.max() <= CLOSE * size:
            yield f"{name} differs by {off.max() / size:.1e}"


def usual_size(result: Result, name: str) -> float:
    """The largest value of a signal of the same name of any element."""
    ending = name.rpartition(".")[2]
    alike = [one for one in moving_signals(result) if one.endswith(f".{ending}")]
    return max((float(np.abs(result[one]).max()) for one in alike), default=0.0)


def same_power(true: Result, found: Result) -> Faults:
    """Where the drives together don't supply the same power."""
    yield from differences(true, found, ["energy.supplied"])
