"""How long a cycle lasts, and on how many steps."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from typing import Annotated, Any, Literal

import numpy as np
from pydantic import BeforeValidator, Field, ValidationError, ValidationInfo, model_validator

from linkwright.expressions import units as u
from linkwright.expressions.fields import Expression, Frozen, fault
from linkwright.expressions.typed_fields import Quantity, Sign
from linkwright.expressions.unknown import unknown
from linkwright.expressions.written import unexpected
from linkwright.findings import Finding, ModelError, Term
from linkwright.kernels import Compiled
from linkwright.model.conditions import Condition, Values
from linkwright.studies.numbers import constant

LONGEST = 1e12
"""No run is longer (s)."""
LARGEST_ANGLE = 1e-5 / np.finfo(float).eps
"""Up to here (rad) an angle is known to 1e-5 rad; beyond it poses are round-off."""
LOOKS = 33
"""At so many times of the run angles are looked at."""


TURNS = re.compile(r"\s*((?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)\s+(\w+)\s*")


def _counted(raw: Any) -> Any:
    if raw is not None and not isinstance(raw, str):
        raise unexpected("turns", raw)
    return raw


class CycleOptions(Frozen):
    """How long, and on how many steps. One of period, duration and turns says how long."""

    period: Annotated[Expression | None, Quantity(u.TIME)] = None
    duration: Annotated[Expression | None, Quantity(u.TIME)] = None
    turns: Annotated[str | None, BeforeValidator(_counted)] = None
    samples: int = Field(200, ge=2, le=100_000)
    through: Literal["keep", "stop"] = "stop"

    @model_validator(mode="after")
    def _one_length(self) -> CycleOptions:
        given = [name for name in ("period", "duration", "turns") if getattr(self, name) is not None]
        if len(given) != 1:
            key = given[0] if given else "period"
            raise fault("study.options", study="cycle", key=key, reason=Term("one-length"))
        return self


def beside(info: ValidationInfo) -> CycleOptions | None:
    """The options of the cycle in the same file, for those of another study; None where it has none, or wrong ones, of
    which the cycle itself tells."""
    given = (info.context or {}).get("cycle")
    try:
        return None if given is None else CycleOptions.model_validate(given)
    except ValidationError:
        return None


def span(compiled: Compiled, options: CycleOptions) -> tuple[float, list[Finding]]:
    """The length of the run (s), and what is wrong with it."""
    seconds, found = _stated_span(compiled, options)
    return seconds, found or [*_unresolved_angles(compiled, seconds)]


def _stated_span(compiled: Compiled, options: CycleOptions) -> tuple[float, list[Finding]]:
    if options.turns is not None:
        return _turns(compiled, options.turns)
    key, length = ("period", options.period) if options.period is not None else ("duration", options.duration)
    assert length is not None
    path = ("studies", "cycle", key)
    seconds, found = constant(compiled.quantities, length, u.TIME, path, math.inf)
    if seconds is None:
        return 0.0, found
    if seconds <= 0:
        return _option_fault(key, Term("length-positive"))
    return (seconds, []) if seconds < LONGEST else _option_fault(key, _too_long(seconds))


def length_condition(compiled: Compiled, options: CycleOptions, value: Values) -> tuple[Any, Condition]:
    """The length (s) of a run that :func:`span` accepts, by what gives the values of expressions, and the condition
    that it has one."""
    if options.turns is not None:
        match = TURNS.fullmatch(options.turns)
        assert match is not None
        speed = compiled.mechanism.drives[match[2]].speed
        assert speed is not None
        rate = value(speed, u.OMEGA)
        _, (finding,) = _option_fault("turns", Term("turns-none", drive=match[2]))
        return 2 * np.pi * float(match[1]) / abs(rate), Condition(abs(rate), Sign.POSITIVE, finding)
    key, length = ("period", options.period) if options.period is not None else ("duration", options.duration)
    assert length is not None
    seconds = value(length, u.TIME)
    _, (finding,) = _option_fault(key, Term("length-positive"))
    return seconds, Condition(seconds, Sign.POSITIVE, finding)


def _unresolved_angles(compiled: Compiled, seconds: float) -> Iterator[Finding]:
    """Drives and followers that turn so far that their angles are off by round-off."""
    for name, law in compiled.laws.items():
        if not compiled.mechanism.prescribed(name).turns:
            continue
        try:
            angle = np.abs(law(np.linspace(0.0, seconds, LOOKS)).d[0]).max()
        except ModelError:  # the study itself tells where a law has no value
            continue
        if angle > LARGEST_ANGLE:
            data = {"name": name, "turns": f"{angle / (2 * np.pi):.3g}", "limit": f"{LARGEST_ANGLE / (2 * np.pi):.2g}"}
            yield Finding("motion.angle-too-large", compiled.mechanism.path_of(name), data)


def _turns(compiled: Compiled, text: str) -> tuple[float, list[Finding]]:
    m, match = compiled.mechanism, TURNS.fullmatch(text)
    if match is None:
        return _option_fault("turns", Term("turns-form", text=text[:60], drive=compiled.graph.drives[0]))
    count, name = float(match[1]), match[2]
    if name not in m.movers:
        return 0.0, [unknown("drive", ("studies", "cycle", "turns"), name, m.movers)]
    drive = m.drives.get(name)
    if (
        drive is None
        or drive.speed is None
        or drive.output is not None
        or drive.acceleration is not None
        or not drive.turns
    ):
        return _option_fault("turns", Term("turns-constant", drive=name))
    speed = compiled.quantities.value(drive.speed, u.OMEGA)
    if speed == 0 or count == 0:
        return _option_fault("turns", Term("turns-none", drive=name))
    seconds = 2 * np.pi * count / abs(speed)
    return (seconds, []) if seconds < LONGEST else _option_fault("turns", _too_long(seconds))


def _option_fault(key: str, reason: Term) -> tuple[float, list[Finding]]:
    data = {"study": "cycle", "key": key, "reason": reason}
    return 0.0, [Finding("study.options", ("studies", "cycle", key), data)]


def _too_long(seconds: float) -> Term:
    return Term("length-limit", seconds=f"{seconds:.3g}", limit=f"{LONGEST:.3g}")
