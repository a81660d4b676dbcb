"""Forces on a cam as entries of the summary, sentences and charts over the cam angle."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

from numpy import float64
from numpy.typing import NDArray

from linkwright.expressions import units as u
from linkwright.findings import Joined, Said, Text
from linkwright.presentation.blocks import Chart
from linkwright.presentation.cells import NumberCell
from linkwright.studies.cam.charts import over
from linkwright.studies.cam.figures import along_lift
from linkwright.studies.cam.outcome import CamOutcome

Array = NDArray[float64]


def force_entry(outcome: CamOutcome) -> dict[str, Any]:
    """Entries of the summary, none without forces."""
    done, quantities = outcome.pressed, outcome.compiled.quantities
    if done is None:
        return {}
    _, rate, load = along_lift(outcome.disc.follower.turns)
    angle, deg = quantities.unit_of(u.ANGLE)
    told: dict[str, Any] = {"closed": outcome.compiled.mechanism.cams[outcome.name].closed}
    stated = {
        "speed": (done.asked.omega, u.OMEGA),
        "rate": (done.loads.rate, rate),
        "preload": (done.loads.preload, load),
        "torque_rms": (done.forces.torque_rms, u.TORQUE),
    }
    for name, (value, dimension) in stated.items():
        unit, size = quantities.unit_of(dimension)
        told[name] = {"value": value / size, "unit": unit}
    if done.asked.second is not None:
        told["reversals"] = {"at": [place / deg for place in done.forces.reversals], "angle_unit": angle}
    return {"forces": told}


def force_sentences(outcome: CamOutcome) -> Iterator[Text]:
    """What was found, in words."""
    done = outcome.pressed
    if done is None:
        return
    _, rate, load = along_lift(outcome.disc.follower.turns)

    def value_text(value: float, dimension: u.Dimension) -> str:
        unit, size = outcome.compiled.quantities.unit_of(dimension)
        return str(NumberCell(value / size, 6, unit))

    figures = dict(done.figures())
    low, high = (value_text(figures[f"contact_force_{end}"].value, u.FORCE) for end in ("min", "max"))
    least, most = (value_text(one.value, u.TORQUE) for one in done.forces.torque_range)
    data = {"speed": value_text(done.asked.omega, u.OMEGA), "low": low, "high": high, "least": least, "most": most}
    yield Said("cam.sentence.forces", **data)
    if done.loads.rate or done.loads.preload:
        key = "sized" if None in (done.asked.rate, done.asked.preload) else "spring"
        yield Said(
            f"cam.sentence.{key}", rate=value_text(done.loads.rate, rate), preload=value_text(done.loads.preload, load)
        )
    if done.asked.second is not None:
        places = Joined(value_text(place, u.ANGLE) for place in done.forces.reversals)
        if done.has_second_contact:
            force = figures["second_contact_force_max"].value
            alone = "apart-other" if force > 0 else "apart-one"
            yield Said(f"cam.sentence.{'apart' if places else alone}", places=places, most=value_text(force, u.FORCE))
        else:
            yield Said("cam.sentence.groove", places=places) if places else Said("cam.sentence.one-flank")


def force_charts(outcome: CamOutcome) -> Iterator[Chart]:
    """Contact force and torque, and with a width the pressure; a second side's is the second line."""
    done = outcome.pressed
    if done is None:
        return
    forces, asked = done.forces, done.asked

    def chart(name: str, dimension: u.Dimension, lines: Sequence[Array], limits: Sequence[float]) -> Chart:
        unit, size = outcome.compiled.quantities.unit_of(dimension)
        rows, across = [line / size for line in lines], [limit / size for limit in limits]
        return over(outcome, Said(f"cam.chart.{name}"), unit, rows, across, forces.theta)

    first = forces.values(forces.figure()) if asked.second is None else forces.contact
    second = [] if asked.second is None else [forces.contact_second]
    yield chart("contact", u.FORCE, [first, *second], [asked.contact] if asked.contact else [])
    yield chart("torque", u.TORQUE, [forces.torque], [] if asked.torque is None else [-asked.torque, asked.torque])
    if done.pressures:
        limits = [] if asked.hertz is None else [asked.hertz]
        yield chart("hertz", u.PRESSURE, [one.peak for one in done.pressures], limits)
