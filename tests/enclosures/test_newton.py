"""Solutions over cells: against closed forms at random places."""

from __future__ import annotations

import numpy as np
import pytest

from linkwright.enclosures.forms import AffineForm
from linkwright.enclosures.newton import inverted, solved

COUNT = 50


def circles(size: float) -> tuple[list[AffineForm], np.ndarray]:
    """The square of a radius 2 + size (u + v / 2), and the start where it is crossed at some angles."""
    radius = AffineForm(2.0 * np.ones(COUNT), size * np.ones(COUNT), size / 2 * np.ones(COUNT), np.zeros(COUNT))
    return [radius.square()], np.linspace(0.3, 1.2, COUNT)


@pytest.mark.parametrize("unknowns", [2, 3])
@pytest.mark.parametrize("size", [1e-5, 1e-2, 0.1])
def test_where_a_ray_meets_a_circle_that_grows(unknowns: int, size: float) -> None:
    """x^2 + y^2 = r^2 on a ray of a given angle, and z = x y."""
    (square,), phi = circles(size)
    x, y = 2 * np.cos(phi), 2 * np.sin(phi)
    c, s = AffineForm(np.cos(phi)), AffineForm(np.sin(phi))

    def equations(off: list[AffineForm]) -> list[AffineForm]:
        a, b = AffineForm(x) + off[0], AffineForm(y) + off[1]
        f, zero, one = [a * a + b * b - square, b * c - a * s], AffineForm(np.zeros(COUNT)), AffineForm(np.ones(COUNT))
        two = AffineForm(2.0)
        if unknowns == 2:
            return [*f, two * a, two * b, -s, c]
        z = AffineForm(x * y) + off[2]
        return [*f, z - a * b, two * a, two * b, zero, -s, c, zero, -b, -a, one]

    found, proven = solved(equations, unknowns, COUNT)
    assert proven.all()
    for u, v in np.random.default_rng(0).uniform(-1, 1, (100, 2)):
        r = 2 + size * (u + v / 2)
        true = [r * np.cos(phi) - x, r * np.sin(phi) - y, r * r * np.cos(phi) * np.sin(phi) - x * y]
        for form, value in zip(found, true, strict=False):
            assert (np.abs(value - form.value - u * form.u - v * form.v) <= form.rest + 1e-15).all()
    assert max(one.rest.max() for one in found) < 20 * size**2 + 1e-14  # of second order


def test_two_solutions_that_meet_are_not_proven() -> None:
    """x^2 = u over a cell that holds u = 0."""
    none = np.zeros(1)

    def equations(off: list[AffineForm]) -> list[AffineForm]:
        x = AffineForm(np.array([1e-3])) + off[0]
        u = AffineForm(none, np.array([1e-2]), none, none)
        return [x * x - u, off[1], AffineForm(2.0) * x, AffineForm(none), AffineForm(none), AffineForm(np.ones(1))]

    assert not solved(equations, 2, 1)[1].any()


@pytest.mark.parametrize("size", [2, 3])
def test_inverses(size: int) -> None:
    matrices = np.random.default_rng(0).normal(size=(20, size, size))
    np.testing.assert_allclose(inverted(matrices.transpose(1, 2, 0)).transpose(2, 0, 1), np.linalg.inv(matrices))
