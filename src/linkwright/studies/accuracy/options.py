"""The options of the accuracy study."""

from __future__ import annotations

from typing import Annotated

from pydantic import Field, FiniteFloat

from linkwright.elements.fields import freeze
from linkwright.expressions.fields import FrozenDict, Text
from linkwright.expressions.fields import Name as NameField
from linkwright.expressions.typed_fields import Quantity
from linkwright.expressions.units import PURE, TIME
from linkwright.kernels.registry import KERNELS
from linkwright.model.tolerances import ClassName, DistributionName
from linkwright.studies.accuracy.allocate import Allocate
from linkwright.studies.accuracy.calibrate import Calibrate
from linkwright.studies.accuracy.clearance_options import Clearance
from linkwright.studies.accuracy.stated_options import Correlation, Thermal
from linkwright.studies.asked import Sampling, one_of

PlanName = one_of("accuracy", "plan", ["random", "latin", "sobol"])
KernelName = one_of("accuracy", "kernel", ["auto", *KERNELS])


class AccuracyOptions(Sampling):
    """Which outputs, what deviates and how, and what is asked of it."""

    study = "accuracy"

    # Where it is looked.
    positions: Annotated[dict[NameField, Annotated[Text, Quantity(TIME)]], freeze] = Field(
        default_factory=FrozenDict,
        description="named positions at which signals are looked at: 'max E.x', 'end of WINDOW', a time",
        examples=[{"far": "max E.x", "out": "end of feed", "grip": "0.2 s"}],
    )

    # What deviates.
    parameters: tuple[NameField, ...] | None = Field(
        None, max_length=1000, description="parameters that deviate; by default all with a tolerance or the general one"
    )
    general: ClassName | None = Field(
        None, description="class of the lengths that state no tolerance, and of such angles with a side"
    )
    distribution: DistributionName = Field("normal", description="of the deviations that state none")
    cp: FiniteFloat = Field(1.0, description="capability: a standard deviation is the limits' width/(6 cp)")
    correlations: tuple[Correlation, ...] = Field(
        (), max_length=1000, description="deviations that go together, with their correlation coefficients"
    )
    thermal: Annotated[dict[Text, Thermal], Quantity(PURE), freeze] = Field(
        default_factory=FrozenDict, max_length=100, description="changes of temperature by name"
    )

    # The way back: tolerances from what is wanted, dimensions from what is measured.
    allocate: Allocate | None = Field(None, description="the cheapest tolerances for a wanted accuracy")
    calibrate: Calibrate | None = Field(None, description="actual dimensions from measured outputs")

    # The random samples.
    samples: int = Field(10_000, ge=0, le=10**9, description="random samples; 0 for none")
    plan: PlanName = Field("random", description="how samples are chosen")  # type: ignore[valid-type]
    seed: int = Field(0, ge=0, le=2**63, description="another seed gives other samples")
    kernel: KernelName = Field("auto", description="what computes it: chosen by the size of the work, or one by name")  # type: ignore[valid-type]

    # Clearances in joints.
    clearances: Annotated[dict[NameField, Clearance], freeze] = Field(
        default_factory=FrozenDict, description="joints with clearance: pins and prismatic joints by name"
    )
    contact: float = Field(
        0.05, gt=0, lt=1, description="the share of a joint's RMS reaction below which contact may be lost"
    )

    # The worst case by evaluating the mechanism.
    nonlinear: float = Field(
        0.05, ge=0, le=1, description="the worst case is searched where the linear one is off by more of its width"
    )
