"""Studies of many samples: what such a study adds to its options, so that the samples can be computed."""

from __future__ import annotations

from typing import Any, Protocol, runtime_checkable

from linkwright.kernels import Compiled
from linkwright.studies.plans import Draws
from linkwright.studies.registry import STUDIES
from linkwright.studies.sampling_options import Sampling


@runtime_checkable
class SampledStudy(Protocol):
    """A registered study whose options are a :class:`Sampling`."""

    def sampled_mechanism(self, compiled: Compiled) -> Compiled:
        """The mechanism of which the samples are taken."""

    def draws(self, compiled: Compiled, options: Any) -> Draws:
        """The samples that the options ask for."""


def sampled_study(options: Sampling) -> SampledStudy:
    """The study to which options of many samples belong."""
    study = STUDIES[options.study]
    assert isinstance(study, SampledStudy), options.study
    return study
