"""Polynomials in the driving joint for the joints of a group that has no closed form."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.polynomial import chebyshev

from linkwright.exports.process_simulate.joints import ToolJoint
from linkwright.exports.process_simulate.linkage import Linkage
from linkwright.exports.process_simulate.trees import Array, Tree, add, joint, multiply, number
from linkwright.structure import HigherGroup

MOST = 20
"""The highest degree: beyond, powers lose more digits than they add."""
Moved = Callable[[ToolJoint], tuple[Array, float]]
"""By the solver: a joint's values since the zero pose as the tool counts them, and its value there, of the child less
the parent (rad or mm)."""


def polynomial(x: Array, y: Array, tolerance: float) -> tuple[Array, float]:
    """The polynomial of least degree, at most ``MOST``, in u = -1..1 over the range of ``x`` that is within a tolerance
    of ``y``: its coefficients by rising power, and its largest error."""
    low, high = float(x.min()), float(x.max())
    u = (2 * x - low - high) / (high - low)
    basis, factors = np.linalg.qr(chebyshev.chebvander(u, MOST))
    shares = basis.T @ y
    for size in range(1, MOST + 2):
        error = float(np.abs(basis[:, :size] @ shares[:size] - y).max())
        if error <= tolerance:
            break
    series = np.linalg.solve(factors[:size, :size], shares[:size])
    return np.asarray(chebyshev.cheb2poly(series), dtype=float), error


def horner(coefficients: Array, variable: Tree) -> Tree:
    """A polynomial with sums and products only."""
    total = number(float(coefficients[-1]))
    for coefficient in coefficients[-2::-1]:
        total = add(multiply(variable, total), number(float(coefficient)))
    return total


def fit(links: Linkage, higher_group: HigherGroup, drive: ToolJoint, moved: Moved, tolerance: float) -> int:
    """Give the joints of a higher group polynomials, within a tolerance (rad or mm) if that can be: the highest
    degree."""
    x, degree = links.poses, 0
    low, high = float(x.min()), float(x.max())
    variable = add(joint(drive.kind, drive.joint), number(-(low + high) / 2))
    variable = multiply(number(2 / (high - low)), variable)
    around = {*higher_group.links, *(link for c in higher_group.joints for link in (c.a, c.b))}
    for found in links.joints:
        if found.joint in links.at_zero or not {found.parent, found.child} <= around:
            continue
        values, at_zero = moved(found)
        coefficients, _ = polynomial(x, found.sign * values, tolerance)
        degree = max(degree, len(coefficients) - 1)
        links.set_function(found, horner(coefficients, variable))
        links.at_zero[found.joint] = at_zero
    _place(links, higher_group)
    return degree


def _place(links: Linkage, higher_group: HigherGroup) -> None:
    """Put the links on one another by joints that are known now."""
    for edge in higher_group.edges:
        links.sit(edge.joint, edge.base, edge.link)
        for found in links.joints:
            known = found.kind == "T" and found.child == edge.link and found.parent in links.angles
            if edge.joint.kind.angular and known:
                links.angles[edge.link] = links.angles[found.parent].plus(links.offset(found))
                break
            known = found.kind == "T" and found.parent == edge.link and found.child in links.angles
            if edge.joint.kind.angular and known:
                links.angles[edge.link] = links.angles[found.child].plus(links.offset(found), -1)
                break
