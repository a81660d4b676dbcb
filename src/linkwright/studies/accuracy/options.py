"""The options of the accuracy study."""

from __future__ import annotations

from typing import Annotated

from pydantic import Field

from linkwright.elements.fields import freeze
from linkwright.expressions.fields import FrozenDict, Text
from linkwright.expressions.fields import Name as NameField
from linkwright.expressions.typed_fields import Quantity
from linkwright.expressions.units import TIME
from linkwright.kernels.registry import KERNELS
from linkwright.studies.accuracy.allocation_options import Allocate
from linkwright.studies.accuracy.calibration_options import Calibrate
from linkwright.studies.accuracy.stated_options import DeviationOptions
from linkwright.studies.sampling_options import Sampling, one_of

PlanName = one_of("accuracy", "plan", ["random", "latin", "sobol"])
KernelName = one_of("accuracy", "kernel", ["auto", *KERNELS])


class AccuracyOptions(DeviationOptions, Sampling):
    """Which outputs, what deviates and how, and what is asked of it."""

    study = "accuracy"

    # Where it is looked.
    positions: Annotated[dict[NameField, Annotated[Text, Quantity(TIME)]], freeze] = Field(
        default_factory=FrozenDict, examples=[{"far": "max E.x", "out": "end of feed", "grip": "0.2 s"}]
    )

    # The way back: tolerances from what is wanted, dimensions from what is measured.
    allocate: Allocate | None = None
    calibrate: Calibrate | None = None

    # The random samples.
    samples: int = Field(10_000, ge=0, le=10**9)
    plan: PlanName = "random"  # type: ignore[valid-type]
    seed: int = Field(0, ge=0, le=2**63)
    kernel: KernelName = "auto"  # type: ignore[valid-type]

    # Clearances in joints.
    contact: float = Field(0.05, gt=0, lt=1)

    # The worst case by evaluating the mechanism.
    nonlinear: float = Field(0.05, ge=0, le=1)

    @property
    def deviating(self) -> bool:
        return super().deviating or self.allocate is not None or self.calibrate is not None
