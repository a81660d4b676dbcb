"""Studies: what a model file asks to be done with its mechanism. Each is imported only where it is asked for."""

from linkwright.studies.interruption import Stopped
from linkwright.studies.registry import STUDIES, Study, StudyTask, read_studies
from linkwright.studies.run_context import NOWHERE, RunContext

__all__ = ["NOWHERE", "STUDIES", "RunContext", "Stopped", "Study", "StudyTask", "read_studies"]
