"""Studies: what a model file asks to be done with its mechanism."""

from linkwright.studies import cycle, modes  # noqa: F401  (register themselves)
from linkwright.studies.cycle import CycleOptions, CycleOutcome
from linkwright.studies.measures import MeasureResult
from linkwright.studies.modes import ModesOptions, ModesOutcome, find_modes
from linkwright.studies.registry import STUDIES, Task, read_studies

__all__ = [
    "STUDIES",
    "CycleOptions",
    "CycleOutcome",
    "MeasureResult",
    "ModesOptions",
    "ModesOutcome",
    "Task",
    "find_modes",
    "read_studies",
]
