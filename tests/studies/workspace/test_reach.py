"""The raster by which regions are judged, against closed forms, printed figures and itself; and the judge."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
import shapely
from scipy import ndimage

from helpers.reach import FAMILIES, Chain, Claim, FiveBar, Guide, TwoCylinders, TwoSlides, judge, make, raster
from helpers.reach.judging import OFF, OPEN, RIGHT, WRONG, claims, judged
from helpers.reach.known import KNOWN, Known
from helpers.reach.mechanisms import Mechanism
from helpers.reach.raster import Raster, Truth, counted, looked
from studies.workspace.test_regions import lens

FULL = 2 * np.pi
CYLINDERS = TwoCylinders(500, (400, 700), (350, 600))
UPPER = (lens(700, 600, 500) - lens(400, 600, 500) - lens(700, 350, 500) + lens(400, 350, 500)) / 2


def paper(alpha: float) -> FiveBar:
    """The five-bar of Peng and Zi (2010) for an angle of P (deg)."""
    return FiveBar(8, 26, 28, 10, 30, 20, -np.radians(alpha))


def coarse(mechanism: Mechanism) -> Raster:
    """A raster of 2048 cells a side."""
    return raster(mechanism, first=1024)


def close(truth: Truth, area: float, slack: float = 0.0) -> bool:
    return abs(truth.area - area) <= truth.error + slack and truth.error < 6e-4 * area


def test_two_cylinders_reach_a_quadrangle_of_arcs_on_either_side() -> None:
    for truth in coarse(CYLINDERS).truths.values():
        assert close(truth, UPPER)
        assert (truth.parts, truth.holes) == ((1, 1), (0, 0))


def test_long_strokes_leave_a_hole_about_a_foot() -> None:
    """Half of the lens of the outer circles, less half of the disc about B that the cylinder there can't enter."""
    both = TwoCylinders(100, (0.01, 150), (20, 140))
    truth = coarse(both).truths["left"]
    assert close(truth, (lens(150, 140, 100) - np.pi * 20**2) / 2, 1e-3)


@pytest.mark.parametrize("p", [0j, 12 - 7j])
def test_a_crank_with_a_slide_reaches_an_annulus(p: complex) -> None:
    """Half of it where the crank turns through 180 deg; P lies |p.y + 4| aside of the crank's axis."""
    for crank, share in ((None, 1.0), ((0.5, 0.5 + np.pi), 0.5)):
        (truth,) = coarse(Guide(4.0, p, crank, (10.0, 30.0))).truths.values()
        ring = np.pi * ((30 + p.real) ** 2 - (10 + p.real) ** 2)
        assert close(truth, ring * share)
        assert truth.parts == (1, 1)
        assert truth.holes == ((1, 1) if crank is None else (0, 0))


@pytest.mark.parametrize(
    ("alpha", "left", "right", "holes"),
    [
        (0, 344.137, 344.137, (0, 0)),
        (60, 508.556, 389.945, (1, 0)),
        (90, 528.6016, 464.5803, (1, 1)),
        (180, 500.154, 500.154, (1, 1)),
    ],
)
def test_the_five_bar_of_the_paper(alpha: float, left: float, right: float, holes: tuple[int, int]) -> None:
    one, other = coarse(paper(alpha)).truths.values()
    assert close(one, left, 5e-4) and close(other, right, 5e-4)
    assert [truth.parts for truth in (one, other)] == [(1, 1), (1, 1)]
    assert [truth.holes for truth in (one, other)] == [(n, n) for n in holes]


def test_what_both_modes_reach_at_180_deg() -> None:
    """500.154 mm2 each, 96.861 of them in both; the holes have 292.781 mm2."""
    found = coarse(paper(180))
    both, error = found.area(lambda bits: bits == 3)
    assert both == pytest.approx(96.861, abs=error + 5e-4)
    left = (found.bits & 1).astype(bool)
    assert (ndimage.binary_fill_holes(left) & ~left).sum() * found.cell**2 == pytest.approx(292.781, rel=2e-3)


MECHANISMS: list[Mechanism] = [
    replace(paper(60), motor=(0.3, 4.0), servo=(-1.0, 2.0)),
    KNOWN[0].mechanism,
    CYLINDERS,
    TwoSlides(10 + 15j, (0.0, 0.7), 20, 25, 12, 0.4, (-20, 30), (-25, 20)),
    Guide(-3.0, 5 + 2j, (1.0, 4.0), (-20.0, 15.0)),
    Chain(15, 40, 35, 50, 20, (0.0, 5.0), (-1.0, 2.5)),
]


@pytest.mark.parametrize("mechanism", MECHANISMS, ids=lambda one: type(one).__name__)
def test_what_the_drives_reach_is_reached_and_nothing_else(mechanism: Mechanism) -> None:
    """All places that values of the drives give, in their mode; and with narrower ranges fewer."""
    spans = np.array(mechanism.spans)[:, :, None]
    q = np.random.default_rng(4).uniform(spans[:, 0] + 1e-9, spans[:, 1] - 1e-9, (2, 20_000))
    for mode in range(len(mechanism.modes)):
        at = mechanism.placed(q, mode)
        at = at[np.isfinite(at.real)]
        assert len(at) > 500
        assert ((looked(mechanism, at) >> mode & 1) == 1).mean() > 0.9999  # but for round-off where B, D and C line up


@pytest.mark.parametrize("mechanism", MECHANISMS, ids=lambda one: type(one).__name__)
def test_all_that_is_said_to_be_reached_is(mechanism: Mechanism) -> None:
    """Each reached cell well inside has a place near that values of the drives on a lattice give."""
    found = raster(mechanism, halved=0, first=64)
    low, high = np.array(mechanism.spans).T
    lattice = np.meshgrid(*(np.linspace(a, b, 1500) for a, b in zip(low, high, strict=True)))
    q = np.array(lattice).reshape(2, -1)
    for mode in range(len(mechanism.modes)):
        at = (mechanism.placed(q, mode) - found.corner) / found.cell / np.exp(0.2971j)
        at = at[np.isfinite(at.real)]
        hit = np.zeros(found.bits.shape, bool)
        hit[at.real.astype(int), at.imag.astype(int)] = True
        inside = (found.bits >> mode & 1).astype(bool)
        missed = inside & ~hit
        assert missed.sum() < 0.01 * inside.sum()  # beside folds, where the lattice's places lie far apart


@pytest.mark.parametrize("known", KNOWN, ids=lambda one: one.name)
def test_known_mechanisms(known: Known) -> None:
    """What the table holds."""
    for k, truth in enumerate(coarse(known.mechanism).truths.values()):
        assert close(truth, known.areas[k], known.error)
        assert truth.parts == (known.parts[k],) * 2
        assert truth.holes[1] == known.holes[k] and truth.holes[1] - truth.holes[0] <= 1  # a narrow neck may close


def test_counts_of_what_is_too_small_to_tell() -> None:
    """Two discs joined by a neck two cells wide are one or two, a dot is nothing, a disc of 16 cells may be a part."""
    i, k = np.indices((200, 200))
    here = ((i - 60) ** 2 + (k - 60) ** 2 < 900) | ((i - 140) ** 2 + (k - 140) ** 2 < 900)
    cross = np.array([[0, 1, 0], [1, 1, 1], [0, 1, 0]])
    assert counted(here, cross) == (2, 2)
    here[20, 180] = True
    assert counted(here, cross) == (2, 2)
    here[178:182, 18:22] = True
    assert counted(here, cross) == (2, 3)
    here[60:62, 60:140] = here[60:140, 139:141] = True
    assert counted(here, cross) == (1, 3)


def test_cases_come_again_by_their_seed_and_cover_the_families() -> None:
    cases = [make(seed) for seed in range(160)]
    assert [case.mechanism for case in cases] == [make(seed).mechanism for seed in range(160)]
    assert {case.family for case in cases} == {*FAMILIES}
    assert sum(case.family.startswith("five-bar") for case in cases) == 136
    bars = [case.mechanism for case in cases if case.family == "five-bar, nearly equal"]
    assert all(abs(bar.l2 - bar.l3) < 0.021 * (bar.l2 + bar.l3) for bar in bars if isinstance(bar, FiveBar))


TRUTH = Truth(area=UPPER, error=8.0, parts=(1, 1), holes=(0, 0), cell=0.28)
SOUND = Claim("left", (UPPER - 1, UPPER + 1), 1, 0, certified=True, certified_parts=True, certified_holes=True)


def bounded(claim: Claim, **changes: object) -> Claim:
    return replace(claim, **changes)  # type: ignore[arg-type]


@pytest.mark.parametrize(
    ("claim", "outcome", "why"),
    [
        (SOUND, RIGHT, ""),
        (bounded(SOUND, area=(UPPER + 10, UPPER + 12)), WRONG, "area"),
        (bounded(SOUND, area=(np.nan, np.nan)), WRONG, "area"),
        (bounded(SOUND, parts=2), WRONG, "parts 2, truth 1"),
        (bounded(SOUND, holes=1), WRONG, "holes 1, truth 0"),
        (bounded(SOUND, holes=1, certified_holes=False), RIGHT, "holes"),
        (bounded(SOUND, certified=False, certified_parts=False, certified_holes=False), OPEN, ""),
        (bounded(SOUND, certified=False, certified_parts=False, certified_holes=False, parts=2), OFF, "parts"),
        (bounded(SOUND, certified=False, parts=2), WRONG, "parts"),
    ],
)
def test_claims_are_judged(claim: Claim, outcome: str, why: str) -> None:
    square = shapely.box(300, 400, 400, 500)
    verdict = judge(CYLINDERS, 0, TRUTH, replace(claim, shape=square))
    assert verdict.outcome == outcome
    assert why in verdict.why and bool(why) == bool(verdict.why)


@pytest.mark.parametrize(("y", "outcome"), [(450.0, RIGHT), (100.0, WRONG)])
def test_a_narrow_part_more_than_the_raster_sees_is_right_where_its_places_are_reached(y: float, outcome: str) -> None:
    shape = shapely.MultiPolygon([shapely.box(300, 400, 400, 430), shapely.box(300, y, 301, y + 1)])
    verdict = judge(CYLINDERS, 0, TRUTH, replace(SOUND, parts=2, shape=shape))
    assert verdict.outcome == outcome


def test_a_mode_of_which_nothing_is_said_is_wrong_where_it_reaches_something() -> None:
    truths = {"left": TRUTH, "right": TRUTH}
    assert [one.outcome for one in judged(CYLINDERS, truths, [SOUND])] == [RIGHT, WRONG]


def test_claims_of_entries() -> None:
    entry = {"mode": "P: left of A-B", "area": 100.0, "parts": 1, "holes": 2}
    nothing = {"grade": "searched", "certified": False, "area": None, "parts": False, "holes": False, "faults": []}
    certificate = {**nothing, "grade": "enclosed", "certified": True, "area": [99.5, 100.5], "parts": True}
    given = [{**entry, "certificate": one} for one in (nothing, certificate)]
    plain, sure = claims(given, [None, None], ("left", "right"))
    assert plain == Claim("left", (100.0, 100.0), 1, 2)
    assert sure == Claim("left", (99.5, 100.5), 1, 2, certified=True, certified_parts=True)
