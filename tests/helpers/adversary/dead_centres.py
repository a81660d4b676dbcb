"""Cases of a slider-crank at its dead centres, where strokes, speeds and angles vanish together: gaps of 0/0, roots,
poles, and the same a little beside them."""

from __future__ import annotations

import random
from typing import Any

import mpmath
import numpy as np
from mpmath import mpf

from helpers.adversary.cases import UNITS, Batch, Case, reduced, sound
from helpers.adversary.features import Draw, background
from helpers.adversary.trees import ROUND, Tree, call, signal
from helpers.adversary.truths import Mark, bounds


class SliderCrank:
    """Crank r at the origin, a rod (m), the pin C on the x axis ahead of the crank; the crank's angle is phi0 + w t."""

    def __init__(self, r: float, rod: float, phi0: float, speed: float) -> None:
        self.r, self.rod, self.phi0, self.speed = r, rod, phi0, speed

    def _numbers(self, t: Any) -> tuple[Any, Any, Any, Any, Any, Any]:
        exact = isinstance(t, mpmath.mpf)
        r, rod, phi0, speed = map(mpf, (self.r, self.rod, self.phi0, self.speed)) if exact else (
            self.r, self.rod, self.phi0, self.speed
        )  # fmt: skip
        angle = phi0 + speed * t
        sine, cosine = (mpmath.sin, mpmath.cos) if exact else (np.sin, np.cos)
        return r, rod, speed, angle, sine(angle), cosine(angle)

    def angle(self, t: Any) -> Any:
        return self._numbers(t)[3]

    def place(self, t: Any) -> Any:
        """The pin's distance from the crank's pivot."""
        r, rod, _, _, sine, cosine = self._numbers(t)
        root = mpmath.sqrt if isinstance(t, mpmath.mpf) else np.sqrt
        return r * cosine + root(rod**2 - (r * sine) ** 2)

    def velocity(self, t: Any) -> Any:
        r, rod, speed, _, sine, cosine = self._numbers(t)
        root = (mpmath.sqrt if isinstance(t, mpmath.mpf) else np.sqrt)(rod**2 - (r * sine) ** 2)
        return -r * sine * speed * (1 + r * cosine / root)

    def document(self, length: float, samples: int) -> dict[str, Any]:
        return {
            "linkwright": 1,
            "units": UNITS,
            "links": {
                "frame": {"points": {"A": [0, 0]}},
                "crank": {"points": {"A": [0, 0], "B": [self.r, 0]}},
                "rod": {"points": {"B": [0, 0], "C": [self.rod, 0]}},
                "slider": {"points": {"C": [0, 0]}},
            },
            "joints": {"guide": {"prismatic": ["frame", "slider"], "line": ["A at 0 deg", "C at 0 deg"]}},
            "assembly": {"C": "ahead of B along guide"},
            "drives": {
                "motor": {
                    "turns": "crank",
                    "on": "frame",
                    "speed": f"{self.speed!r} rad/s",
                    "start": f"{self.phi0!r} rad",
                }
            },
            "windows": {},
            "measures": {},
            "studies": {"cycle": {"duration": f"{length!r} s", "samples": samples}},
        }


def dead_centre_batch(seed: int, source: random.Random, count: int) -> Batch:
    """The outer dead centre at angle 0, passed once on or between the samples; strokes are taken from r + rod."""
    length, samples = source.choice((1.0, 2.0, 3.0)), source.choice((12, 50, 100, 200))
    # Binary fractions, so that r + rod, the dead centre's time and the stroke there are exact.
    r, rod = source.randrange(20, 60) / 128, source.randrange(80, 250) / 128
    speed, phi0 = float(source.choice((1, 2))), -source.randrange(10, 100) / 128
    crank = SliderCrank(r, rod, phi0, speed)
    batch = Batch(seed, crank.document(length, samples))
    most = r + rod
    angle = signal("(crank.angle/(1 rad))", crank.angle, crank.angle, lambda t: 8 * ROUND)
    place = signal("(guide.s/(1 m))", crank.place, crank.place, lambda t: 16 * ROUND)
    velocity = signal("(guide.v/(1 m/s))", crank.velocity, crank.velocity, lambda t: 32 * ROUND)
    gap = most - place
    inner = [mpf(k) * mpmath.pi for k in range(-1, 3)]
    marks = tuple(Mark((at - mpf(phi0)) / mpf(speed), 0.05) for at in inner)

    def forms(d: Draw) -> tuple[Tree, ...]:
        w = d.w / length
        return (
            gap / angle**2,
            gap**2 / angle**4,
            velocity**2 / gap,
            velocity / angle,
            call("sqrt", abs(gap)),
            call("sqrt", abs(gap)) / angle,
            velocity / call("sqrt", abs(gap)),
            abs(gap) ** 1.5 / angle**2,
            (gap - angle**2) / angle**2,
            w * velocity / gap,
            w / velocity,
            w**2 / (gap + w**2),
            call("atan2", velocity, gap),
            velocity * angle / (gap + w**2),
        )

    for _ in range(count):
        d = Draw(source, length, samples)
        d.w = length * d.log(-6, -1)
        form = d.pick(*forms(d))
        if d.pick(False, True):
            form = form + background(d)[0]
        b = bounds(form, [(mpf(0), mpf(length))], marks)
        if not sound(b):
            continue
        measure, numbers = reduced(d.pick("extremes", "max", "min", "span"), form.text, b, length)
        name = f"m{len(batch.cases)}"
        batch.add(Case("dead centre", name, measure, numbers, d.w, d.w / length, form, (0.0, length)))
    return batch
