"""What a page puts into its programs, as programs themselves: parameters, drives' values and rates, ratios of
followers; and tables as their polynomials.

Laws are evaluated on symbols, so that what the page computes is what this package does. What isn't an expression of a
parameter (the motion laws of followers, the tables of loads, shapes of laws that are fitted) is left as it is at the
nominal parameters, which are locked then.
"""

from __future__ import annotations

from collections.abc import Callable, Container, Iterable, Iterator, Mapping, Sequence
from typing import Any

from linkwright.expressions.dimensions import DimensionError
from linkwright.expressions.fields import Expression
from linkwright.expressions.language import evaluate
from linkwright.expressions.parser import ExpressionError
from linkwright.expressions.typed_fields import Sign
from linkwright.expressions.units import Dimension
from linkwright.findings import Finding, ModelError
from linkwright.graph.geometry import Geometry
from linkwright.graph.program import Program
from linkwright.kernels.compiled import Compiled
from linkwright.kernels.drawn_constants import DrawnConstants
from linkwright.kernels.motion_faults import asking
from linkwright.kernels.motions import motion_conditions
from linkwright.kernels.parameter_batch import Varied
from linkwright.kernels.tables import StatedTable, closing_margin
from linkwright.laws import TableLaw
from linkwright.model.conditions import Condition, Values, varying_conditions
from linkwright.model.quantities import LARGEST, Quantities
from linkwright.model.sampled import dependent, names_in
from linkwright.model.walk import QuantityPlace
from linkwright.notation.jets import varies
from linkwright.symbols import ExpressionStage, Symbol, as_symbol, choice, derivatives_along, ordered

Length = Callable[[Values], tuple[Any, Condition]]
"""The length of a run (s) by what gives the values of expressions, and the condition that it has one."""


UNSTATED = 1e300
"""The value of an input that states a parameter, where it isn't stated: larger than any that a file may have."""


def derived_parameters(quantities: Quantities, tangents: bool = False, drawn: Sequence[str] = ()) -> Program:
    """The program of all parameters (SI): its inputs are those that depend on no other, then those that follow from
    the sketch (``drawn``) and may be stated instead: they follow while their input is :data:`UNSTATED`. With
    ``tangents`` that of their derivatives along a direction, whose entries are further inputs."""
    names, parts = tuple(quantities.parameters), quantities.mechanism.parameters
    free = tuple(name for name in names if not names_in(parts[name].value.node) & {*names} and name not in drawn)
    free = (*free, *drawn)
    x = Symbol.several("x", len(free))
    given = dict(zip(free, x, strict=True))
    known = {name: value for name, value in given.items() if name not in drawn}
    for name in quantities.order:
        if name not in known:
            node = quantities.bind(parts[name].value, quantities.dimensions.of(name))
            known[name] = as_symbol(evaluate(node, lambda other: known[other.text]))
            if name in drawn:
                known[name] = choice(abs(given[name]) < LARGEST, given[name], known[name])
    rows = [known[name] for name in names]
    if tangents:
        along = Symbol.several("direction", len(free))
        rows = derivatives_along(rows, dict(zip(x, along, strict=True)))
        x, free = [*x, *along], (*free, *(f"d({name})" for name in free))
    return Program((), ExpressionStage(x, [], rows), free, (), names)


def locked_parameters(compiled: Compiled, free: Iterable[str]) -> dict[str, Finding]:
    """Of some parameters those that can't be moved in a page, each with the reason."""
    found: dict[str, Finding] = {}
    followed = {follower.laws[key] for follower in compiled.mechanism.followers.values() for key in follower.laws}
    motions = compiled.motions.items()
    fixed = {("laws", name): motion.names if name in followed else motion.fixed for name, motion in motions}
    fixed |= {("tables", name): table.names for name, table in compiled.tables.items()}
    counted = [site for site in compiled.quantities.fields if isinstance(site, QuantityPlace)]
    whole = [(site.path, names_in(e.node)) for site in counted for e, of in site.parts if of.whole]
    for name in (asked := [*free]):
        try:
            Varied(compiled, [name])
        except ModelError as error:
            found[name] = error.findings[0]
            continue
        varying = dependent(compiled.quantities, frozenset([name]))
        for path, stated in whole:
            if varying & stated:
                why = Finding("varied.whole", path, {"name": name, "where": ".".join(map(str, path))}, severity="note")
                found.setdefault(name, why)
        for path, names in fixed.items():
            if varying & names:
                why = Finding("varied.locked", path, {"name": name, "where": path[1]}, severity="note")
                found.setdefault(name, why)
    asking = DrawnConstants(compiled).joints_that_ask(name for name in asked if name not in found)
    for name, joint in asking.items():
        data = {"name": name, "joint": joint}
        found[name] = Finding("varied.drawn", ("joints", joint), data, severity="note")
    return found


def fixed_parameters(quantities: Quantities, free: Iterable[str], locked: Iterable[str]) -> frozenset[str]:
    """The parameters that follow from ``locked`` ones alone, of those that are ``free`` otherwise."""
    locked = frozenset(locked)
    return dependent(quantities, locked) - dependent(quantities, frozenset(free) - locked)


def law_program(compiled: Compiled, fixed: Container[str]) -> Program:
    """The drives' values and rates (SI) at a time (s), drive by drive."""
    t: Any = Symbol.named("t")
    p, parameters = _parameters(compiled, fixed)
    rows = [part for drive in compiled.graph.drives for part in compiled.laws[drive].at(t, parameters).d]
    return _program(compiled, [t], p, rows, ("t",))


def law_slopes_program(compiled: Compiled, fixed: Container[str]) -> Program:
    """The derivatives of all that :func:`law_program` gives along a direction of the parameters, which are further
    parameters: a drive that starts as drawn turns with the sketch."""
    t: Any = Symbol.named("t")
    p, parameters = _parameters(compiled, fixed)
    along = Symbol.several("direction", len(p))
    rows = [as_symbol(part) for drive in compiled.graph.drives for part in compiled.laws[drive].at(t, parameters).d]
    slopes = derivatives_along(rows, dict(zip(p, along, strict=True)))
    names = (*compiled.graph.parameters, *(f"d({name})" for name in compiled.graph.parameters))
    stage = ExpressionStage([t], [*p, *along], slopes)
    return Program((), stage, ("t",), names, tuple(map(str, range(len(rows)))))


def ratio_program(compiled: Compiled, fixed: Container[str]) -> Program:
    """Of each follower the derivative of its value by its motor's, and the rate of that in time, from the motor's value
    (rad or m) and rate, follower by follower."""
    followers = compiled.supply.followers
    p, parameters = _parameters(compiled, fixed)
    x = Symbol.several("x", 2 * len(followers))
    rows = [part for i, law in enumerate(followers.values()) for part in law.ratio(x[2 * i], x[2 * i + 1], parameters)]
    return _program(compiled, x, p, rows, tuple(f"{name}:{k}" for name in followers for k in (0, 1)))


def constants_program(compiled: Compiled, length: Length | None = None) -> Program:
    """What is computed once for a set of parameters: the angle (rad) near which each counted one starts, 0 where it
    starts anywhere; then the margins of the conditions on numbers (see :func:`number_conditions`) and the figures of
    their sentences; last the ``length`` of a run (s), 0 where that stays."""
    p, parameters = _parameters(compiled, ())
    geometry, supply = Geometry(compiled.quantities, parameters), compiled.supply
    rows: list[Any] = []
    for name in compiled.graph.actions.turning:
        counted = compiled.graph.actions.counted_angles.get(name)
        rows.append(0.0 if counted is None else supply.start_angle(name, geometry.number))
    conditions = number_conditions(compiled, parameters, length)
    rows += [one.margin for one in conditions]
    rows += [figure.value for one in conditions for figure in one.figures]
    rows.append(0.0 if length is None else length(geometry.number)[0])
    return _program(compiled, [], p, rows, ())


def shape_program(compiled: Compiled) -> Program:
    """The shapes of links: the coordinates (m) of each link's points in its frame, link by link as the mechanism has
    them; then the angles (rad) of each prismatic joint's line on both its links."""
    p, parameters = _parameters(compiled, ())
    geometry, mechanism = Geometry(compiled.quantities, parameters), compiled.mechanism
    points = [geometry.point(link, name) for link, entry in mechanism.links.items() for name in entry.points]
    rows = [coordinate for point in points for coordinate in point]
    rows += [geometry.heading_angle(n, link) for n, joint in mechanism.prismatic_joints() for link in joint.links]
    return _program(compiled, [], p, rows, ())


def shaping(compiled: Compiled, derived: Program, shape: Program) -> dict[str, list[int]]:
    """Of each link, which free parameters (by their numbers) its points depend on."""
    x = Symbol.several("x", len(derived.inputs))
    rows = shape.block.symbols([], derived.block.symbols(x, []))
    place = {symbol: i for i, symbol in enumerate(x)}
    depends = [(row, place[part]) for row, made in enumerate(rows) for part in ordered([made]) if part in place]
    found, first = dict[str, list[int]](), 0
    for link, entry in compiled.mechanism.links.items():
        last = first + 2 * len(entry.points)
        found[link] = sorted({i for row, i in depends if first <= row < last})
        first = last
    return found


def number_conditions(
    compiled: Compiled, parameters: Mapping[str, Any] | None = None, length: Length | None = None
) -> list[Condition]:
    """The conditions on numbers that depend on parameters, as expressions of symbols for these; that a run has a
    ``length`` comes last."""
    given = _parameters(compiled, ())[1] if parameters is None else parameters
    geometry = Geometry(compiled.quantities, given)

    def value(expression: Expression, dimension: Dimension) -> Any:
        try:
            return geometry.number(expression, dimension)
        except (KeyError, ExpressionError):  # it varies with the motion, and is looked at there
            raise DimensionError("expression.not-constant", name="") from None

    found = varying_conditions(compiled.quantities, value, varies)
    lasting = [] if length is None else [length(geometry.number)[1]]
    return [*found, *_law_conditions(compiled, given), *lasting]


def _law_conditions(compiled: Compiled, parameters: Mapping[str, Any]) -> Iterator[Condition]:
    """That the motion laws of drives, and tables over whole periods, are valid."""
    quantities = compiled.quantities
    for name, askers in asking(compiled.mechanism).items():
        law = compiled.motions[name]
        if law.names - law.fixed and all(follower is None for _, follower in askers):
            for wrong in motion_conditions(quantities, name, law, parameters):
                finding = Finding("law.values", ("laws", name), {"law": name})
                yield Condition(choice(wrong, -1.0, 1.0), Sign.NOT_NEGATIVE, finding)
    for name, table in compiled.mechanism.tables.items():
        margin = closing_margin(quantities, table, parameters)
        if margin is not None and varies(margin):
            yield Condition(margin, Sign.NOT_NEGATIVE, Finding("table.not-closed", ("tables", name), {}))


def table_pieces(table: StatedTable) -> dict[str, Any]:
    """A table as its polynomials: where they begin and the last ends, and the coefficients of each, lowest power first,
    of what the argument is past its beginning."""
    assert isinstance(table, TableLaw)
    knots, powers = table.powers()
    ends = [float(table.x[0]), float(table.x[-1])]
    return {"knots": knots.tolist(), "powers": powers.tolist(), "ends": ends, "period": table.period}


def _parameters(compiled: Compiled, fixed: Container[str]) -> tuple[list[Symbol], Mapping[str, Any]]:
    """The parameters as a column of symbols, and by name: the fixed ones as numbers."""
    names, nominal = compiled.graph.parameters, compiled.quantities.parameters
    symbols = [Symbol.named(name) for name in names]
    given = {name: nominal[name] if name in fixed else symbol for name, symbol in zip(names, symbols, strict=True)}
    return symbols, given


def _program(compiled: Compiled, x: list[Symbol], p: list[Symbol], rows: list[Any], inputs: tuple[str, ...]) -> Program:
    stage = ExpressionStage(x, p, rows)
    return Program((), stage, inputs, compiled.graph.parameters, tuple(map(str, range(len(rows)))))
