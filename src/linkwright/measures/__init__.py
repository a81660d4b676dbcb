"""Measures: numbers taken of a run, with the places where expressions break, searches, grades and their check."""

from linkwright.measures.bound_measure import BoundMeasure, bound_measures
from linkwright.measures.check import misfit
from linkwright.measures.enclosed import enclose
from linkwright.measures.found import MeasureResult
from linkwright.measures.live import LiveMeasure, live_measures, live_rows, sampled_times
from linkwright.measures.measure import Measurer, measure_all
from linkwright.measures.probe import Probe, Search
from linkwright.measures.signal_in_run import SignalInRun

__all__ = [
    "BoundMeasure",
    "LiveMeasure",
    "MeasureResult",
    "Measurer",
    "Probe",
    "Search",
    "SignalInRun",
    "bound_measures",
    "enclose",
    "live_measures",
    "live_rows",
    "measure_all",
    "misfit",
    "sampled_times",
]
