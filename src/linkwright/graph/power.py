"""Power of what acts on links: what an element supplies to the mechanism, and what it takes and doesn't store."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

from linkwright.elements.force import Acting
from linkwright.notation import Body, Scalar, Wrench
from linkwright.symbols import as_symbol, derivatives_along

if TYPE_CHECKING:
    from linkwright.graph.view import View


def power_of_wrench(body: Body, wrench: Wrench) -> Scalar:
    """The power (W) of a wrench on a link: force times velocity, moment times angular velocity."""
    return wrench.force.dot(body.velocity(wrench.about)) + body.turn.d[0] * wrench.moment


def supplied(view: View, one: Acting) -> Scalar:
    """The power (W) that an element supplies to the links on which it acts; negative where it takes some."""
    wrenches: Iterable[tuple[str, Wrench]] = one.kind.wrenches(view, one.name, one.entry)
    return sum((power_of_wrench(view.bodies[link], wrench) for link, wrench in wrenches), 0.0)


def dissipated(view: View, one: Acting) -> Scalar:
    """The power (W) that an element takes and doesn't store: what it doesn't supply, less the rate of its energy."""
    lost = -supplied(view, one)
    if one.kind.stores:
        energy = as_symbol(one.kind.energy(view, one.name, one.entry))
        lost = lost - derivatives_along([energy], view.graph.flow(view))[0]
    return lost


def totals(view: View, attribute: str) -> Scalar:
    """The power of all drives (``supplied``), or what all elements take and don't store (``dissipated``)."""
    if attribute == "supplied":
        return sum((view.row(f"{drive}.power") for drive in view.graph.motors), 0.0)
    return sum((dissipated(view, one) for one in view.graph.actions.every if one.kind.acts), 0.0)
