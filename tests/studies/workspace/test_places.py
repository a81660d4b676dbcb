"""Which places a mode reaches, and how often, against circles that meet."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray

from helpers.compiled import compiled_from
from helpers.reach import Chain, FiveBar, Guide, TwoCylinders, TwoSlides
from helpers.reach.circles import TURN, left, meetings
from helpers.reach.mechanisms import Mechanism
from linkwright.studies.workspace.places import FOLD, LIMIT, MODES, KnownPoses
from studies.workspace.made_up import MM, places_of
from studies.workspace.models import arm, triad_turned_round

Array = NDArray[np.float64]
FIVE_BAR = FiveBar(18.0, 30.0, 27.0, 20.0, 22.0, 14.0, 0.7)
PART = FiveBar(18.0, 30.0, 27.0, 20.0, 22.0, 14.0, 0.7, motor=(0.5, 3.0), servo=(-1.0, 2.5))
MECHANISMS: dict[str, Mechanism] = {
    "five-bar": FIVE_BAR,
    "five-bar with ranges": PART,
    "two cylinders": TwoCylinders(50.0, (40.0, 70.0), (35.0, 60.0)),
    "two slides": TwoSlides(3 + 25j, (0.2, -0.4), 30.0, 31.0, 18.0, 1.1, (-40.0, 40.0), (-40.0, 40.0)),
    "crank and its slide": Guide(6.0, 4 + 3j, (-0.3, 2.0), (20.0, 60.0)),
    "four-bar and an arm": Chain(15.0, 40.0, 35.0, 50.0, 20.0),
}


def around(mechanism: Mechanism, count: int) -> Array:
    """Places in a square round all that is reached (m)."""
    centre, radius = mechanism.round
    z = centre + np.random.default_rng(8).uniform(-1, 1, (count, 2)) @ [radius, 1j * radius]
    return np.stack([z.real, z.imag]) * MM


@pytest.mark.parametrize("name", MECHANISMS)
def test_depth_is_positive_where_the_mechanism_gets_and_nowhere_else(name: str) -> None:
    mechanism = MECHANISMS[name]
    at = around(mechanism, 20_000)
    with np.errstate(all="ignore"):
        bits = mechanism.reached((at[0] + 1j * at[1]) / MM)
    for mode in range(len(mechanism.modes)):
        places = places_of(mechanism, mode)
        depth = places.depth(at)
        assert not np.isnan(depth).any()
        expected = (bits >> mode) & 1 == 1
        assert 100 < expected.sum() < at.shape[1]
        np.testing.assert_array_equal(depth > 0, expected)
        np.testing.assert_array_equal(places.count(at) > 0, expected)


@pytest.mark.parametrize("name", MECHANISMS)
def test_forward_poses_lead_to_places_that_are_reached(name: str) -> None:
    """And the drives' values there lead back."""
    mechanism = MECHANISMS[name]
    places = places_of(mechanism, 0)
    low, high = (np.array(end)[:, None] for end in (places.box.low, places.box.high))
    q = np.random.default_rng(9).uniform(low, high, (2, 2000))
    at, reach = places.sheet.place(q)
    at = at[:, np.isfinite(at).all(axis=0) & (reach > 1e-6)]
    assert at.shape[1] > 100 and (places.depth(at) > 0).all()
    values, depths = places.drives(at)
    for branch in range(len(places.branches)):
        good = depths[branch] > 1e-6
        found = values[branch][:, good]
        assert ((found >= low - 1e-12) & (found <= high + 1e-12)).all()
        np.testing.assert_allclose(places.sheet.place(found)[0], at[:, good], atol=1e-10)
    assert (depths.max(axis=0) > 0).all()


def poses(
    bar: FiveBar, z: NDArray[np.complex128], mode: int
) -> tuple[NDArray[np.int_], NDArray[np.int_], NDArray[np.int_]]:
    """Of places: in how many poses P gets there in a mode with the drives in their ranges, in how many of either mode,
    and in how many with the drives anywhere."""
    own, either, anywhere = (np.zeros(z.shape, dtype=int) for _ in range(3))
    with np.errstate(all="ignore"):
        for d in meetings(bar.l5, bar.l4, z, bar.r):
            c = d + (z - d) * (bar.l3 / bar.r * np.exp(-1j * bar.angle))
            for b in meetings(0j, bar.l1, c, bar.l2):
                ok = np.isfinite(b.real)
                low, high = bar.motor or (0.0, TURN)
                within = ok & (np.mod(np.angle(b) - low, TURN) <= high - low)
                low, high = bar.servo or (0.0, TURN)
                within &= np.mod(np.angle(d - bar.l5) - low, TURN) <= high - low
                is_own = left(b, d, c) == (mode == 0)
                own += within & is_own
                either += within
                anywhere += ok
    return own, either, anywhere


@pytest.mark.parametrize("bar", [FIVE_BAR, PART], ids=["whole turns", "ranges"])
@pytest.mark.parametrize("mode", [0, 1])
def test_how_many_poses_lead_to_a_place(bar: FiveBar, mode: int) -> None:
    at = around(bar, 20_000)
    own, _, _ = poses(bar, (at[0] + 1j * at[1]) / MM, mode)
    assert len({*own.tolist()}) >= 3
    np.testing.assert_array_equal(places_of(bar, mode).count(at), own)


def test_two_poses_meet_at_a_fold_and_one_leaves_at_a_change_of_mode_or_a_ranges_end() -> None:
    """Along lines across the plane each jump of the count is one of these: all poses of both modes, with the drives
    anywhere, come and go by twos; those of the mode alone also by one into the other mode or beyond a range."""
    places = places_of(PART, 0)
    seen = set()
    for y in (-9.0, 4.0, 13.0):
        x = np.linspace(-50, 60, 40_001)
        z = x + 1j * y
        _, either, anywhere = poses(PART, z, 0)
        count = places.count(np.stack([z.real, z.imag]) * MM)
        for k in np.flatnonzero(np.diff(count)):
            jump, there, all_ = (int(abs(n[k + 1] - n[k])) for n in (count, either, anywhere))
            expected = FOLD if all_ else (LIMIT if there else MODES)
            assert jump == 2 if expected == FOLD else jump == 1, (x[k], y)
            seen.add(expected)
            # A function of that kind changes its sign.
            beside = np.stack([x[k : k + 2], [y, y]]) * MM
            functions, depths = places.functions(beside), places.depths(beside)
            inside = int(count[k + 1] > count[k])
            (new, *_) = np.flatnonzero((depths[:, inside] > 0) & ~(depths[:, 1 - inside] > 0))
            below = functions[new, :, 1 - inside] < 0
            assert expected in np.array(places.kinds)[below], (x[k], y)
    assert seen == {FOLD, MODES, LIMIT}


def test_forms_hold_the_functions_all_over_their_squares() -> None:
    places = places_of(PART, 0)
    random = np.random.default_rng(6)
    middle, half = random.uniform(-0.03, 0.05, (2, 200)), random.uniform(1e-4, 2e-3, 200)
    count, told = len(places.branches), 0
    of, branch = np.repeat(np.arange(200), count), np.tile(np.arange(count), 200)
    forms, square = places.forms(middle[:, of], half[of], branch)
    np.testing.assert_array_equal(square, np.arange(of.size))
    for u, v in random.uniform(-1, 1, (10, 2)):
        at = middle + half * np.array([[u], [v]])
        functions = places.functions(at)  # (branches, functions, squares)
        exists = (functions[:, [kind == FOLD for kind in places.kinds]] >= 0).all(axis=1)
        for k in range(of.size):
            if exists[branch[k], of[k]]:
                true = functions[branch[k], :, of[k]]
                off = np.abs(true - forms.value[:, k] - u * forms.u[:, k] - v * forms.v[:, k])
                known = np.isfinite(forms.rest[:, k])
                assert (off[known] <= forms.rest[known, k] + 1e-15).all()
                told += int(known.sum())
    assert told > 1000


def test_of_what_has_no_closed_form_there_are_no_poses() -> None:
    assert KnownPoses.of(compiled_from(triad_turned_round()), "P") is None
    assert KnownPoses.of(arm(1.0, 0.6), "P") is not None
