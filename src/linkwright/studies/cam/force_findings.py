"""The forces' part of the cam study: figures and what isn't kept, with what mends it."""

from __future__ import annotations

from typing import TYPE_CHECKING

from linkwright.cam.checks import CamCheck
from linkwright.cam.contact import NoContact
from linkwright.expressions import units as u
from linkwright.findings import Finding, Term
from linkwright.studies.cam.figures import of_forces
from linkwright.studies.cam.force_numbers import AT
from linkwright.studies.cam.forces import pressed

if TYPE_CHECKING:
    from linkwright.studies.cam.outcome import CamOutcome

UP = 1 + 1e-5
"""What is to suffice is told so much larger, in six digits."""
MEASURES = {"hertz_pressure": u.PRESSURE, "shaft_torque": u.TORQUE}
"""What the checks of forces are."""


def press(outcome: CamOutcome) -> None:
    """Put the follower under load; a law or a follower for which there are no forces is a failure."""
    asked = outcome.stated.forces
    if asked is None:
        return
    try:
        done = pressed(outcome.disc, asked)
        outcome.add(done.figures(), of_forces(outcome.disc.follower.turns))
    except NoContact as error:
        if error.key == "cam.undercut":
            return  # of a groove's outer flank, which its check tells
        theta = error.data.get("theta")
        data = {} if theta is None else {"theta": _value_text(outcome, theta, u.ANGLE)}
        outcome.failures.append(Finding(error.key, ("cams", outcome.name), data))
        return
    outcome.pressed, outcome.force_checks = done, list(done.checks())
    if done.short:
        outcome.failures.append(_lifts(outcome))
    outcome.failures += [_over(outcome, check) for check in outcome.force_checks if not check.passed]


def _lifts(outcome: CamOutcome) -> Finding:
    done = outcome.pressed
    assert done is not None
    assert done.preload is not None
    figures, least, need = of_forces(outcome.disc.follower.turns), done.least, done.preload
    rate = Term("no-rate")
    if done.rate is not None:
        rate = Term("or-rate", rate=_value_text(outcome, UP * done.rate.value, figures["spring_rate_min"]))
    data = {
        "force": _value_text(outcome, least.value, u.FORCE),
        "theta": _value_text(outcome, least.theta, u.ANGLE),
        "speed": _value_text(outcome, need.omega, u.OMEGA),
        "least": _value_text(outcome, done.asked.contact, u.FORCE),
        "preload": _value_text(outcome, UP * need.value, figures["spring_preload_min"]),
        "rate": rate,
    }
    return Finding("cam.spring", AT, data)


def _over(outcome: CamOutcome, check: CamCheck) -> Finding:
    """A limit that isn't kept."""
    assert check.limit is not None
    dimension = MEASURES[check.name]
    value, limit = (_value_text(outcome, one, dimension) for one in (check.value, check.limit))
    theta = _value_text(outcome, check.theta, u.ANGLE)
    asked = outcome.stated.forces
    if check.name == "hertz_pressure" and asked is not None and asked.width is not None:
        width = _value_text(outcome, UP * asked.width * (check.value / check.limit) ** 2, u.LENGTH)
        data = {"value": value, "limit": limit, "theta": theta, "width": width}
        return Finding("cam.hertz", (*AT, "limits", "hertz"), data)
    return Finding("cam.torque", (*AT, "limits", "torque"), {"value": value, "limit": limit, "theta": theta})


def _value_text(outcome: CamOutcome, value: float, dimension: u.Dimension) -> str:
    unit, size = outcome.compiled.quantities.unit_of(dimension)
    return f"{value / size:.6g} {unit}"
