"""Reductions of measures, one file each: what a file says of it, its figures, derivatives, bounds, checks."""

from linkwright.reductions.derivative import Derivative, Local
from linkwright.reductions.entry import ENTRIES, SIGNAL, Measure, OfPath, figure, of_signal, reduced
from linkwright.reductions.figures import Figures, FoundFigure, Peak, Unmeasured
from linkwright.reductions.grades import SAMPLED, Grade, ProofKind
from linkwright.reductions.interpolant import Interpolant
from linkwright.reductions.kind import REDUCTIONS, MeasureKind, kind_of, register
from linkwright.reductions.protocols import InRun, InSamples, WithDeviations, WithPlay
from linkwright.reductions.samples import OnSamples, SampledFigure, SampledFigures, SampledInputs

__all__ = [
    "ENTRIES",
    "REDUCTIONS",
    "SAMPLED",
    "SIGNAL",
    "Derivative",
    "Figures",
    "FoundFigure",
    "Grade",
    "InRun",
    "InSamples",
    "Interpolant",
    "Local",
    "Measure",
    "MeasureKind",
    "OfPath",
    "OnSamples",
    "Peak",
    "ProofKind",
    "SampledFigure",
    "SampledFigures",
    "SampledInputs",
    "Unmeasured",
    "WithDeviations",
    "WithPlay",
    "figure",
    "kind_of",
    "of_signal",
    "reduced",
    "register",
]
