"""Motion laws as a model file states them: segments in sequence over an angle or a time."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from typing import Annotated, Any, Literal

from pydantic import BeforeValidator, Field

from linkwright.expressions.fields import Expression, Frozen, FrozenDict, pair
from linkwright.expressions.typed_fields import Quantity, Scope
from linkwright.expressions.units import ANGLE, LENGTH, PURE, TIME, Dimension
from linkwright.expressions.unknown import near
from linkwright.expressions.written import Fault, fault, short_text, unexpected
from linkwright.findings import Joined
from linkwright.laws import LAWS
from linkwright.model.actions import Row

MAX_SEGMENTS, MAX_NUMBERS = 200, 200
MATCHED = {"velocity": 1, "acceleration": 2, "jerk": 3}
"""How many derivatives a segment takes from its neighbours."""
DEGREES = {"cubic": 3, "quintic": 5}
AXES: dict[str, Dimension] = {"angle": ANGLE, "time": TIME}
VALUES: dict[str, Dimension] = {"angle": ANGLE, "length": LENGTH}
ARGUMENT = "u"
"""The name of the argument of a normalised formula."""


def _non_empty_list(refusal: Callable[[Any], Exception], most: int) -> BeforeValidator:
    """A list that isn't empty; ``refusal`` is raised on anything else."""

    def check(raw: Any) -> Any:
        if not isinstance(raw, list | tuple) or not raw:
            raise refusal(raw)
        if len(raw) > most:
            raise fault("file.too-many", count=len(raw), limit=most)
        return tuple(raw)

    return BeforeValidator(check)


def _known_law_name(raw: Any) -> str:
    name = short_text(raw)
    if name not in LAWS:
        raise fault("law.unknown", name=name[:60], near=near(name, [*LAWS]))
    return name


Numbers = Annotated[tuple[Expression, ...], _non_empty_list(lambda raw: unexpected("numbers", raw), MAX_NUMBERS)]
Powers = Annotated[
    tuple[Annotated[int, Field(ge=1, le=20)], ...], _non_empty_list(lambda raw: unexpected("numbers", raw), 20)
]
LawName = Annotated[str, BeforeValidator(_known_law_name), Field(json_schema_extra={"enum": [*LAWS]})]
SOME_ROWS = _non_empty_list(lambda raw: unexpected("table-rows", raw), MAX_NUMBERS)
Rows = Annotated[tuple[Row, ...], SOME_ROWS]

_NORMALISED = ("law", "fractions", "powers", "formula")
_BETWEEN = ("match", "from", "to", "via", "spline")
_HEADS: dict[str, tuple[str, ...]] = {
    "dwell": (),
    "rise": ("over", *_NORMALISED, "skew", *_BETWEEN),
    "fall": ("over", *_NORMALISED, "skew"),
    "control": ("over", "degree"),
    "harmonics": ("over",),
}
"""What says which kind of segment it is, and the keys that go with it."""


def _of_law(dimension: Callable[[Any], Dimension]) -> Quantity:
    """A quantity of a segment, whose dimension its law tells."""
    return Quantity(lambda c: dimension(c.entries[-2]))


_AXIS, _VALUE = _of_law(lambda law: law.axis), _of_law(lambda law: law.value)
_RATES = Quantity(lambda c: c.entries[-2].rate(int(c.path[-1]) + 1))
_FORMULA = Quantity(PURE, scope=Scope.FORMULA, names=FrozenDict({ARGUMENT: PURE}))
_Via = Annotated[tuple[Annotated[Expression, _AXIS], Annotated[Expression, _VALUE]], BeforeValidator(pair("table-row"))]


class SegmentEntry(Frozen):
    """One stretch of a motion: a dwell, a rise or fall, control values of a B-spline, a harmonic series."""

    dwell: Annotated[Expression | None, _AXIS] = None
    rise: Annotated[Expression | None, _VALUE] = None
    fall: Annotated[Expression | None, _VALUE] = None
    over: Annotated[Expression | None, _AXIS] = None
    law: LawName | None = None
    skew: Annotated[Expression | None, Quantity(PURE)] = None
    fractions: Annotated[Numbers | None, Quantity(PURE)] = None
    powers: Powers | None = None
    formula: Annotated[Expression | None, _FORMULA] = None
    match: Literal["velocity", "acceleration", "jerk"] | None = None
    from_: Annotated[Numbers | None, _RATES] = Field(None, alias="from")
    to: Annotated[Numbers | None, _RATES] = None
    via: Annotated[tuple[_Via, ...], SOME_ROWS] | None = None
    spline: Literal["cubic", "quintic"] | None = None
    control: Annotated[Numbers | None, _VALUE] = None
    degree: Annotated[int, Field(ge=2, le=9)] | None = None
    harmonics: Annotated[Rows | None, _VALUE] = None

    @classmethod
    def faults(cls, given: Mapping[str, Any]) -> Iterator[Fault]:
        heads = [key for key in _HEADS if key in given]
        if len(heads) != 1:
            yield "law.segment", {"given": Joined(heads) or "-", "known": Joined(_HEADS)}
            return
        head, fitting = heads[0], _HEADS[heads[0]]
        odd = [key for key in cls.names() if key in given and key not in (head, *fitting)]
        ways = [key for key in _NORMALISED if key in given and key in fitting]
        between = [key for key in _BETWEEN if key in given and key in fitting]
        if "skew" in given and not {"law", "fractions"} & {*ways}:
            odd.append("skew")
        if odd:
            yield "law.keys", {"head": head, "given": Joined(dict.fromkeys(odd))}
        if "over" in fitting and "over" not in given:
            yield "law.no-over", {"head": head}
        if "law" in fitting and len(ways) + bool(between) != 1:
            known = [key for key in (*_NORMALISED, *_BETWEEN) if key in fitting]
            yield "law.way", {"given": Joined([*ways, *between]) or "-", "known": Joined(known)}

    @classmethod
    def names(cls) -> list[str]:
        """The keys as files have them."""
        return [field.alias or name for name, field in cls.model_fields.items()]

    @property
    def width(self) -> Expression:
        """The way that it takes along the axis."""
        width = self.dwell if self.dwell is not None else self.over
        assert width is not None
        return width


class MotionLaw(Frozen):
    """A function of an angle or a time, by segments; drives call it by its name."""

    over: Literal["angle", "time"]
    of: Literal["angle", "length"]
    start: Annotated[Expression, Quantity(lambda c: c.entry.value)] = Expression(0)
    period: Annotated[Expression | None, Quantity(lambda c: c.entry.axis)] = None
    beyond: Literal["repeat", "advance", "hold"] = "repeat"
    segments: Annotated[
        tuple[SegmentEntry, ...], _non_empty_list(lambda raw: unexpected("segments", raw), MAX_SEGMENTS)
    ]

    @property
    def axis(self) -> Dimension:
        """The dimension of its argument."""
        return AXES[self.over]

    @property
    def value(self) -> Dimension:
        """The dimension of what it gives."""
        return VALUES[self.of]

    def rate(self, order: int) -> Dimension:
        """The dimension of a derivative by the axis."""
        return self.value.times(self.axis, -order)
