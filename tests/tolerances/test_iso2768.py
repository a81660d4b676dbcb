"""ISO 2768-1: the tables as printed, and where they end."""

from __future__ import annotations

import math

import pytest

from linkwright.tolerances import NoTolerance, tolerance_class

# Table 1: of each class, the limit deviations (mm) from the range of 2 mm to that of 3000 mm.
LINEAR = {
    "f": [0.05, 0.05, 0.1, 0.15, 0.2, 0.3, 0.5, None],
    "m": [0.1, 0.1, 0.2, 0.3, 0.5, 0.8, 1.2, 2],
    "c": [0.2, 0.3, 0.5, 0.8, 1.2, 2, 3, 4],
    "v": [None, 0.5, 1, 1.5, 2.5, 4, 6, 8],
}
# Table 3: of each class, the limit deviations (degrees, minutes) up to 10, 50, 120, 400 mm and over.
ANGULAR = {
    "f": [(1, 0), (0, 30), (0, 20), (0, 10), (0, 5)],
    "m": [(1, 0), (0, 30), (0, 20), (0, 10), (0, 5)],
    "c": [(1, 30), (1, 0), (0, 30), (0, 15), (0, 10)],
    "v": [(3, 0), (2, 0), (1, 0), (0, 30), (0, 20)],
}


@pytest.mark.parametrize("letter", LINEAR)
def test_lengths(letter: str) -> None:
    found = tolerance_class(f"ISO 2768-{letter}")
    assert found is not None
    ranges = [
        (0.5, 3),
        (3.001, 6),
        (6.001, 30),
        (30.001, 120),
        (120.001, 400),
        (400.001, 1000),
        (1000.001, 2000),
        (2000.001, 4000),
    ]
    for ends, value in zip(ranges, LINEAR[letter], strict=True):
        for mm in ends:
            if value is None:
                with pytest.raises(NoTolerance):
                    found.limits(mm * 1e-3)
            else:
                assert found.limits(mm * 1e-3) == pytest.approx((-value * 1e-3, value * 1e-3), rel=1e-12)


@pytest.mark.parametrize("letter", ANGULAR)
def test_angles(letter: str) -> None:
    found = tolerance_class(f"ISO 2768-{letter}")
    assert found is not None
    for ends, (degrees, minutes) in zip(
        [(1, 10), (11, 50), (51, 120), (121, 400), (401, 9000)], ANGULAR[letter], strict=True
    ):
        for side in ends:
            value = math.radians(degrees + minutes / 60)
            assert found.angular(side * 1e-3) == pytest.approx((-value, value), rel=1e-12)


@pytest.mark.parametrize(
    ("letter", "mm", "ends"),
    [("m", 0.49, (0.5, 4000)), ("f", 2001, (0.5, 2000)), ("v", 3, (3, 4000)), ("c", 4001, (0.5, 4000))],
)
def test_sizes_that_it_leaves_open_are_refused(letter: str, mm: float, ends: tuple[float, float]) -> None:
    found = tolerance_class(f"ISO 2768-{letter}")
    assert found is not None
    with pytest.raises(NoTolerance) as caught:
        found.limits(mm * 1e-3)
    assert (caught.value.data["low"], caught.value.data["high"]) == pytest.approx([end * 1e-3 for end in ends])


@pytest.mark.parametrize("text", ["ISO 2768-m", "ISO 2768 - m", "ISO2768-m", "ISO 2768-mK", "ISO 2768-1-m"])
def test_spellings_of_drawings(text: str) -> None:
    found = tolerance_class(text)
    assert found is not None
    assert found.text == "ISO 2768-m"


@pytest.mark.parametrize("text", ["ISO 2768", "ISO 2768-g", "ISO 2768-K", "2768-m", "m"])
def test_other_texts_name_no_class(text: str) -> None:
    assert tolerance_class(text) is None


def test_classes_of_fits_have_no_angles() -> None:
    for text in ("h7", "IT8"):
        found = tolerance_class(text)
        assert found is not None
        with pytest.raises(NoTolerance, match="angle"):
            found.angular(0.05)
