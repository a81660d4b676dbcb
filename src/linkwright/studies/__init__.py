"""Studies: what a model file asks to be done with its mechanism."""

from linkwright.studies import cycle, limits, modes  # noqa: F401  (each registers itself)
from linkwright.studies.cycle import CycleOptions, CycleOutcome
from linkwright.studies.limits import LimitsOptions, LimitsOutcome
from linkwright.studies.measures import MeasureResult
from linkwright.studies.modes import ModesOptions, ModesOutcome, find_modes
from linkwright.studies.registry import STUDIES, Task, read_studies

__all__ = [
    "STUDIES",
    "CycleOptions",
    "CycleOutcome",
    "LimitsOptions",
    "LimitsOutcome",
    "MeasureResult",
    "ModesOptions",
    "ModesOutcome",
    "Task",
    "find_modes",
    "read_studies",
]
