"""Studies: what a model file asks to be done with its mechanism."""

from linkwright.measures import MeasureResult
from linkwright.studies.accuracy.study import AccuracyStudy  # noqa: F401  (each registers itself)
from linkwright.studies.cam.outcome import CamOutcome
from linkwright.studies.cam.study import CamStudy  # noqa: F401
from linkwright.studies.cycle.options import CycleOptions
from linkwright.studies.cycle.outcome import CycleOutcome
from linkwright.studies.cycle.study import Cycle  # noqa: F401
from linkwright.studies.interruption import Stopped
from linkwright.studies.limits.outcome import LimitsOutcome
from linkwright.studies.limits.study import LimitsOptions
from linkwright.studies.modes.outcome import ModesOutcome
from linkwright.studies.modes.study import ModesOptions, find_modes
from linkwright.studies.reactions.study import Reactions  # noqa: F401
from linkwright.studies.registry import STUDIES, Study, StudyTask, read_studies
from linkwright.studies.run_context import NOWHERE, RunContext
from linkwright.studies.sampling import Interrupted
from linkwright.studies.sweep.options import SweepOptions
from linkwright.studies.sweep.outcome import SweepOutcome
from linkwright.studies.sweep.study import SweepStudy  # noqa: F401
from linkwright.studies.workspace.outcome import WorkspaceOutcome
from linkwright.studies.workspace.study import WorkspaceStudy  # noqa: F401

__all__ = [
    "NOWHERE",
    "STUDIES",
    "CamOutcome",
    "CycleOptions",
    "CycleOutcome",
    "Interrupted",
    "LimitsOptions",
    "LimitsOutcome",
    "MeasureResult",
    "ModesOptions",
    "ModesOutcome",
    "RunContext",
    "Stopped",
    "Study",
    "StudyTask",
    "SweepOptions",
    "SweepOutcome",
    "WorkspaceOutcome",
    "find_modes",
    "read_studies",
]
