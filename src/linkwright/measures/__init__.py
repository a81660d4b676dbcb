"""Measures: numbers taken of a run, with the places where expressions break, searches, grades and their check."""

from linkwright.measures.check import misfit
from linkwright.measures.enclosed import enclose
from linkwright.measures.found import Found, MeasureResult
from linkwright.measures.grades import Grade
from linkwright.measures.measure import Measurer, bound, instants, measure_all
from linkwright.measures.probe import Probe, Search
from linkwright.measures.rules import RULES

__all__ = [
    "RULES",
    "Found",
    "Grade",
    "MeasureResult",
    "Measurer",
    "Probe",
    "Search",
    "bound",
    "enclose",
    "instants",
    "measure_all",
    "misfit",
]
