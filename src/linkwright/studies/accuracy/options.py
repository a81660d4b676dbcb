"""The options of the accuracy study."""

from __future__ import annotations

from pydantic import Field

from linkwright.kernels import Compiled
from linkwright.kernels.registry import KERNELS
from linkwright.studies.accuracy.deviations import Deviations
from linkwright.studies.asked import Sampling, one_of

PlanName = one_of("accuracy", "plan", ["random", "latin", "sobol"])
KernelName = one_of("accuracy", "kernel", ["auto", *KERNELS])


class AccuracyOptions(Sampling):
    """Which outputs, what deviates and how, and what is asked of it."""

    study = "accuracy"

    # The random samples.
    samples: int = Field(10_000, ge=0, le=10**9, description="random samples; 0 for none")
    plan: PlanName = Field("random", description="how samples are chosen")  # type: ignore[valid-type]
    seed: int = Field(0, ge=0, le=2**63, description="another seed gives other samples")
    kernel: KernelName = Field("auto", description="what computes it: chosen by the size of the work, or one by name")  # type: ignore[valid-type]

    # The worst case by evaluating the mechanism.
    nonlinear: float = Field(
        0.05, ge=0, le=1, description="the worst case is searched where the linear one is off by more of its width"
    )

    def drawn(self, compiled: Compiled) -> Deviations:
        """The random samples of the deviations that the file states."""
        from linkwright.studies.accuracy.stated import contributors  # which looks at these options

        return Deviations(compiled, contributors(compiled, self), self.plan, self.samples, self.seed)
