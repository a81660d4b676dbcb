"""Extremes of random expressions on random mechanisms, against dense samples that are refined where they are largest.

The samples are the product's own values, so that only the search for extremes is judged here.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

import linkwright as lw
from helpers.adversary import Answer, Said, answers
from helpers.expressions import expression, signals
from helpers.plain import document_of
from helpers.random_mechanisms import RECIPES, Seeded, build
from studies.models import at

Array = NDArray[np.float64]
Values = Callable[[Array], Array]
DURATION, SAMPLES, DENSE = 1.0, 24, 20_000
COUNT = 16
"""Expressions for each mechanism."""
HALVINGS = 6


def document(recipe: str, seed: int) -> dict[str, Any]:
    """A random mechanism with a cycle; of those that get stuck, the next one."""
    data = document_of(build(recipe, Seeded(seed)))
    return data | {"studies": {"cycle": {"duration": f"{DURATION} s", "samples": SAMPLES}}}


def model(recipe: str, seed: int) -> tuple[dict[str, Any], Any]:
    """The document and its run."""
    while True:
        data = document(recipe, seed)
        try:
            job = lw.run(lw.Document.model_validate(data))
        except lw.ModelError:
            job = None
        if job is not None and job.cycle is not None and not job.cycle.failures:
            return data, job.cycle.result.run
        seed += 100


def with_zeros(source: Seeded, run: Any, names: list[str]) -> list[str]:
    """Each signal less a value that it takes, so that quotients have poles."""
    t = np.array([source.uniform(0.1, 0.9) * DURATION])
    return [f"({name}-({float(at(run, name, t)[0])!r}))" for name in names]


def measured(data: dict[str, Any], texts: dict[str, str]) -> tuple[dict[str, Answer], Any]:
    """The extremes of some expressions; those that the check refuses as constant nonsense are left out."""
    for _ in range(len(texts) + 1):
        try:
            measures = {name: {"extremes": text} for name, text in texts.items()}
            job = lw.run(lw.Document.model_validate(data | {"measures": measures}))
            assert job.cycle is not None
            return answers(job), job.cycle.result.run
        except lw.ModelError as error:
            wrong = {str(finding.path[1]) for finding in error.findings if finding.path[:1] == ("measures",)}
            assert wrong, error
            texts = {name: text for name, text in texts.items() if name not in wrong}
    raise AssertionError


@dataclass
class Course:
    """An expression over the run: dense samples, and values anywhere."""

    values: Values
    t: Array
    y: Array

    @property
    def middle(self) -> float:
        return float(np.median(np.abs(self.y[np.isfinite(self.y)])))

    def refined(self, sign: int, more: tuple[float, ...] = ()) -> tuple[float, float]:
        """The largest value of sign * f and its time: golden section about the largest few samples and other places."""
        y = np.where(np.isfinite(self.y), sign * self.y, -np.inf)
        padded = np.concatenate([[-np.inf], y, [-np.inf]])
        tops = np.flatnonzero((y >= padded[:-2]) & (y >= padded[2:]) & np.isfinite(y))
        tops = tops[np.argsort(-y[tops])][:5]
        step = self.t[1] - self.t[0]
        centres = np.array([*self.t[tops], *more])
        low, high = np.maximum(centres - 1.5 * step, self.t[0]), np.minimum(centres + 1.5 * step, self.t[-1])
        x, best = self._golden(low, high, sign)
        i = int(np.argmax(best))
        return (float(best[i]), float(x[i])) if best[i] >= y.max() else (float(y.max()), float(self.t[np.argmax(y)]))

    def _golden(self, a: Array, b: Array, sign: int) -> tuple[Array, Array]:
        def height(t: Array) -> Array:
            return np.nan_to_num(sign * self.values(t), nan=-np.inf, posinf=np.inf, neginf=-np.inf)

        ratio = (math.sqrt(5) - 1) / 2
        c, d = b - ratio * (b - a), a + ratio * (b - a)
        fc, fd = height(c), height(d)
        best = np.maximum(fc, fd)
        at_ = np.where(fc >= fd, c, d)
        for _ in range(75):
            left = fc > fd
            a, b = np.where(left, a, c), np.where(left, d, b)
            new = np.where(left, b - ratio * (b - a), a + ratio * (b - a))
            f = height(new)
            c, d, fc, fd = (
                np.where(left, new, d),
                np.where(left, c, new),
                np.where(left, f, fd),
                np.where(left, fc, f),
            )
            at_ = np.where(f > best, new, at_)
            best = np.maximum(best, f)
        return at_, best

    def noise(self, time: float) -> float:
        """How far the value moves over some ulps of the time: round-off, and what its conditioning makes of it."""
        near = time + np.arange(-4, 5) * np.spacing(max(abs(time), DURATION / 1024))
        values = self.values(np.clip(near, self.t[0], self.t[-1]))
        values = values[np.isfinite(values)]
        if not values.size:
            return 0.0
        return float(np.spacing(np.abs(values).max()) + np.median(np.abs(values - np.median(values))))

    def grows(self, time: float, side: int, sign: int) -> bool:
        """Whether the values grow towards a time from a side: far above the rest, or at every halving."""
        h = side * (self.t[1] - self.t[0]) * 2.0 ** -np.arange(0, 24)
        values = sign * self.values(time + h[(time + h >= self.t[0]) & (time + h <= self.t[-1])])
        values = values[np.isfinite(values)]
        if values.size < HALVINGS:
            return False
        return bool(values.max() > 1e3 * self.middle or (np.diff(values[-8:]) > 0).all())

    def doubles(self, sign: int) -> bool:
        """Whether the largest of the samples lie beside a pole: doubled as the distance halves, again and again."""
        value, time = self.refined(sign)
        if not value > 1e3 * self.middle > 0:
            return False
        for side in (-1, 1):
            h = side * (self.t[1] - self.t[0]) * 2.0 ** -np.arange(10, 11 + HALVINGS)
            if self.t[0] <= time + h[0] <= self.t[-1]:
                values = sign * self.values(time + h)
                if (values > 0).all() and (values[1:] > 1.9 * values[:-1]).all():
                    return True
        return False


def fault(course: Course, label: str, said: Said) -> str:
    """What is wrong with a reported extreme, or nothing."""
    sign = 1 if label == "max" else -1
    if math.isnan(said.value):
        return "NaN"
    if math.isinf(said.value):
        if said.value * sign < 0:
            return "the wrong infinity"
        if said.time is None:
            return "infinite nowhere"
        sides = (said.side,) if said.side else (-1, 1)
        return "" if any(course.grows(said.time, side, sign) for side in sides) else f"no growth at {said.time}"
    if course.doubles(sign):
        return "a number beside a pole"
    finite = course.y[np.isfinite(course.y)]
    best, time = course.refined(sign, () if said.time is None else (said.time,))
    size = float(np.ptp(finite))
    slack = 1e-9 * size + 64 * max(course.noise(time), course.noise(said.time or time))
    seen = best if said.width == 0 else (sign * finite).max()  # between samples a feature may be too narrow to be found
    if sign * said.value < seen - slack:
        return f"a value of {sign * seen!r} lies outside"
    if sign * said.value > best + slack:
        return f"not found there: {sign * best!r}"
    return ""


@pytest.mark.parametrize("recipe", RECIPES)
def test_extremes_of_random_expressions(recipe: str) -> None:
    seed = list(RECIPES).index(recipe)
    source = Seeded(1000 + seed)
    data, run = model(recipe, seed)
    names = signals(build_of(recipe, data, seed))
    leaves = names + with_zeros(source, run, names)
    texts = {f"m{i}": expression(source, leaves, source.pick((2, 3, 3, 4))) for i in range(COUNT)}
    given, run = measured(data, texts)
    t = np.linspace(run.start, run.stop, DENSE + 1)
    wrong, told, known = [], 0, 0
    for name, answer in given.items():

        def values(times: Array, text: str = texts[name]) -> Array:
            return at(run, text, times)

        course = Course(values, t, values(t))
        if not np.isfinite(course.y).any():
            continue
        known += bool(np.isfinite(course.y).all())
        told += bool(answer.said)
        if not answer.said and not answer.codes:
            wrong.append(f"{texts[name]}: neither a number nor a finding")
        for label, said in answer.said.items():
            if why := fault(course, label, said):
                wrong.append(f"{texts[name]} {label} {said.value!r} at {said.time!r} ({said.kind}): {why}")
    assert wrong == []
    assert told >= known / 2


def build_of(recipe: str, data: dict[str, Any], seed: int) -> Any:
    """The plain mechanism of a document."""
    while document(recipe, seed) != data:
        seed += 100
    return build(recipe, Seeded(seed))


# The test of the test: what it must find.

T = np.linspace(0.0, 1.0, DENSE + 1)


def course(f: Values) -> Course:
    with np.errstate(all="ignore"):
        return Course(f, T, f(T))


@pytest.mark.parametrize(
    ("f", "said", "why"),
    [
        (lambda t: np.sin(7 * t), Said(1.0, math.pi / 14), ""),
        (lambda t: np.sin(7 * t), Said(1.0 - 1e-6, math.pi / 14), "outside"),
        (lambda t: np.sin(7 * t), Said(1.0 + 1e-6, math.pi / 14), "not found"),
        (lambda t: np.sin(7 * t), Said(math.inf, math.pi / 14), "no growth"),
        (lambda t: np.sin(7 * t), Said(math.nan, math.pi / 14), "NaN"),
        (lambda t: 1 / (t - 0.30001), Said(math.inf, 0.30001, 1), ""),
        (lambda t: 1 / (t - 0.30001), Said(math.inf, 0.30001, -1), "no growth"),
        (lambda t: 1 / (t - 0.30001), Said(-math.inf, 0.30001, -1), "wrong infinity"),
        (lambda t: 1 / (t - 0.30001), Said(2.0e6, 0.30001), "beside a pole"),
        (lambda t: -np.log(np.abs(t - 0.30001)), Said(math.inf, 0.30001, -1), ""),
        (lambda t: np.arctan2(t - 0.3, -1.0), Said(math.pi, 0.3), ""),
        (lambda t: np.arctan2(t - 0.3, -1.0), Said(math.pi + 1e-6, 0.3), "not found"),
        (lambda t: 1e-8 / ((t - 0.300012) ** 2 + 1e-8), Said(1.0, 0.300012), ""),
        (lambda t: 1e-12 / ((t - 0.300012) ** 2 + 1e-12), Said(1.0, 0.300012), ""),
        (lambda t: 1e-12 / ((t - 0.300012) ** 2 + 1e-12), Said(0.01, 0.3), "not found|outside"),
    ],
)  # fmt: skip
def test_what_the_test_finds(f: Values, said: Said, why: str) -> None:
    with np.errstate(all="ignore"):
        found = fault(course(f), "max", said)
    assert (not found) == (not why)
    assert not why or any(part in found for part in why.split("|")), found
