"""Where acting elements aren't smooth in time: jumps at the ends of windows, kinks of linear tables and functions; and
where motion laws aren't."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from linkwright.expressions.language import Binary, Call, Name, Node, Number, nodes
from linkwright.graph.geometry import Geometry
from linkwright.graph.rows import Row, TableArgument, WindowRow
from linkwright.laws import Motion, TableLaw
from linkwright.results.stationary import crossings
from linkwright.results.windows import intervals

if TYPE_CHECKING:
    from linkwright.kernels import Compiled
    from linkwright.results.run import Run

Array = NDArray[np.float64]
Who = NDArray[np.intp]

ASIDE = (1e-11, 1e-10, 1e-9, 1e-8)
"""How far from a jump its two sides are looked at, over the run's length: the first at which they differ."""
ROUGH = 3
"""The continuity from which on a join of a motion law hinders nothing: the jerk runs on."""
MOST = 1 << 16
"""The most kinks of a table that are sought."""


def jumps(run: Run) -> Array:
    """The times right before and right after each jump of an acting element: (jumps, 2)."""
    actions, parts = run.compiled.graph.actions, list[tuple[Who, Array, Array]]()

    def look(what: Row | Node, times: Array) -> None:
        """Add the sides of a jump at times, as those of one sample."""

        def values(_: Who, t: Array) -> Array:
            return np.asarray(run.compiled.evaluate([what], t)[0] if isinstance(what, Row) else run.jets(what, t).d[0])

        if times.size:
            parts.extend(sides(values, np.zeros(times.size, dtype=np.intp), times, run.start, np.full(1, run.stop)))

    for name in actions.windows:
        edges = intervals(run, run.compiled.quantities.window(name))
        look(WindowRow(name), np.unique([*edges, (run.start, run.stop)]))
    for node in actions.jumps:
        look(node, zeros(run, node))
    found = [pair for _, before, after in parts for pair in zip(before.tolist(), after.tolist(), strict=True)]
    return np.array(sorted(found)).reshape(-1, 2)


def sides(
    values: Callable[[Who, Array], Array], who: Who, t: Array, start: float, stop: Array
) -> Iterator[tuple[Who, Array, Array]]:
    """Samples and the times (s) right before and right after those at which the sign of a row or an expression changes,
    of the times ``t`` (n,) of samples ``who`` (n,) that run from ``start`` to ``stop`` (samples,)."""
    for share in ASIDE:
        aside = share * (stop - start)[who]
        before, after = np.maximum(t - aside, start), np.minimum(t + aside, stop[who])
        left, right = (values(who, side) > 0 for side in (before, after))
        differ = left != right
        yield who[differ], before[differ], after[differ]
        who, t = who[~differ], t[~differ]
        if not who.size:
            return


def breaks(run: Run) -> Array:
    """All times at which a force may have a jump or a kink, ascending."""
    actions = run.compiled.graph.actions
    found = [run.jumps.mean(axis=1)]
    for i, lookup in enumerate(actions.lookups):
        table = run.compiled.tables[lookup.table]
        if table.degree == 1 and not lookup.integral:
            found.append(knots(argument_of(run, i), table, run.start, run.stop, run.grid))
    found += [zeros(run, node) for node in kinks(run.compiled)]
    return np.unique(np.concatenate(found))


def kinks(compiled: Compiled, varied: Iterable[str] = ()) -> list[Node]:
    """What changes its sign where the law of an acting element or a drive has a kink, or another contact of a follower
    bears; ``varied`` are the names of joins that vary, as ``Varied.joins`` has them."""
    m = compiled.mechanism
    laws = [*compiled.graph.actions.laws, *positions(compiled)]
    found = dict.fromkeys(switch for law in laws for node in nodes(law) for switch in switches(node))
    found |= dict.fromkeys(law_joins(compiled, varied))
    found |= dict.fromkeys(way.node for way in compiled.graph.actions.breaks if not way.jumps)
    paired = ((name, follower) for name, follower in m.followers.items() if follower.has_second_contact)
    found |= dict.fromkeys(Name(f"{name}.{follower.effort}") for name, follower in paired)  # the other contact bears
    joints = m.joints_but_pins()
    found |= dict.fromkeys(Name(f"{name}.{signal}") for name, joint in joints for signal in joint.kinks)
    functions = {*m.tables, *m.laws}
    asked = {node: {n.name for n in nodes(node) if isinstance(n, Call) and n.name in functions} for node in found}
    return [node for node in found if asked[node] <= {*compiled.tables}]  # not those of a drive's own table


def law_joins(compiled: Compiled, varied: Iterable[str] = (), rough: int = ROUGH) -> list[Node]:
    """What changes its sign where a drive or follower passes a join of its motion law whose continuity is below
    ``rough``, in every period, or one of its own, or a joint one of its curve; ``varied`` as those of :func:`kinks`."""
    geometry = Geometry(compiled.quantities, compiled.quantities.parameters)
    followers = [call for follower in compiled.mechanism.followers.values() for call in follower.calls(geometry)]
    calls = (node for law in (*positions(compiled), *followers) for node in nodes(law))
    found = [way for node in calls for way in joins(compiled.motions, node, varied, rough)]
    found += [way for follower in compiled.mechanism.followers.values() for way in follower.joins(geometry)]
    for name, joint in compiled.mechanism.joints_but_pins():
        for attribute, places in joint.joins.items():
            at = (geometry.bind(place, joint.signals[attribute]) for place in places)
            found += [Binary("-", Name(f"{name}.{attribute}"), place) for place in at]
    return found


def positions(compiled: Compiled) -> list[Node]:
    """The laws of the drives that are expressions."""
    m = compiled.mechanism
    stated = (name for name, drive in m.drives.items() if drive.position is not None or m.path_law(name) is not None)
    return [compiled.quantities.law(name) for name in stated]


def joins(motions: Mapping[str, Motion], node: Node, varied: Iterable[str] = (), rough: int = ROUGH) -> list[Node]:
    """What changes its sign at the joins of a motion law, in every period."""
    if not isinstance(node, Call) or node.attribute is not None or node.name not in motions:
        return []
    motion, argument = motions[node.name], node.args[0]
    places: list[Node] = [Number(join.at) for join in motion.joins if join.continuity < rough]
    period: Node = Number(motion.period)
    if own := [name for name in varied if name.startswith(f"{node.name}@")]:
        places, period = [Name(name) for name in own[:-1]], Name(own[-1])
    passing = [Binary("-", argument, place) for place in places]
    if motion.beyond == "hold":
        return [*passing]
    turn = Binary("/", Name("pi"), period)
    return [Call("sin", (Binary("*", way, turn),)) for way in passing]


def zeros(run: Run, node: Node) -> Array:
    """The times at which an expression changes its sign."""
    return crossings(lambda t: np.asarray(run.jets(node, t).d[0]), run.start, run.stop, run.grid)


def switches(node: Node) -> list[Node]:
    """What changes its sign where a function has a kink, or a step its ends."""
    if not isinstance(node, Call) or node.attribute is not None:
        return []
    if node.name in ("min", "max"):
        return [Binary("-", *node.args)]
    if node.name == "step5":
        return [Binary("-", node.args[0], end) for end in (node.args[1], node.args[3])]
    return [node.args[0]] if node.name == "abs" else []


def argument_of(run: Run, lookup: int) -> Callable[[Array], Array]:
    """What a table is asked for, at times."""

    def argument(t: Array) -> Array:
        return np.asarray(run.compiled.evaluate([TableArgument(lookup)], t.ravel())[0].reshape(t.shape))

    return argument


def knots(argument: Callable[[Array], Array], table: TableLaw, start: float, stop: float, grid: int) -> Array:
    """Where between ``start`` and ``stop`` the argument of a linear table passes one of its points."""
    x = table.x
    if table.period is not None and not np.isclose(x[-1] - x[0], table.period, rtol=1e-12):
        x = np.append(x, x[0] + table.period)
    period, count = table.period or np.inf, x.size - 1
    t = np.linspace(start, stop, grid + 1)
    at = argument(t)
    whole = np.floor((at - x[0]) / period)
    # The number of points passed, as a continuous function of the argument.
    passed = whole * count + np.interp(at - (whole * period if table.period else 0.0), x, np.arange(x.size))
    low, high = np.floor(np.minimum(passed[:-1], passed[1:])), np.floor(np.maximum(passed[:-1], passed[1:]))
    each = np.nan_to_num(high - low).astype(int)
    if not 0 < each.sum() <= MOST:
        return np.empty(0)
    step = np.repeat(np.arange(each.size), each)
    number = (low[step] + 1 + np.arange(each.sum()) - np.repeat(np.cumsum(each) - each, each)).astype(int)
    turns = (number - 1) // count if table.period else np.zeros_like(number)
    target = x[number - turns * count] + turns * (table.period or 0.0)
    from scipy.optimize.elementwise import find_root

    result = find_root(lambda at, goal: argument(at) - goal, (t[step], t[step + 1]), args=(target,))
    return np.asarray(np.where(np.isfinite(result.x), result.x, t[step + 1]))
