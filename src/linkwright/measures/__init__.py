"""Measures: numbers taken of a run, with the places where expressions break, searches, grades and their check."""

from linkwright.measures.bound_measure import BoundMeasure, bound_measures
from linkwright.measures.check import misfit
from linkwright.measures.enclosed import enclose
from linkwright.measures.found import MeasureResult
from linkwright.measures.measure import Measurer, measure_all
from linkwright.measures.probe import Probe, Search
from linkwright.measures.signal_in_run import SignalInRun

__all__ = [
    "BoundMeasure",
    "MeasureResult",
    "Measurer",
    "Probe",
    "Search",
    "SignalInRun",
    "bound_measures",
    "enclose",
    "measure_all",
    "misfit",
]
