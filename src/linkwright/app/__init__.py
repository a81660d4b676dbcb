"""What the commands do, for Python too: examine a model file, perform its studies, write the results."""

from linkwright.app.accuracies import accuracy
from linkwright.app.alone import examine_alone, runner_of
from linkwright.app.assembly_modes import ModesJob, modes, modes_of_file
from linkwright.app.bench import Bench, bench_file
from linkwright.app.job import Examined, Job, check, examine_file, perform, run, write
from linkwright.app.sweeps import sweep
from linkwright.app.workspaces import workspace, write_png

__all__ = [
    "Bench",
    "Examined",
    "Job",
    "ModesJob",
    "accuracy",
    "bench_file",
    "check",
    "examine_alone",
    "examine_file",
    "modes",
    "modes_of_file",
    "perform",
    "run",
    "runner_of",
    "sweep",
    "workspace",
    "write",
    "write_png",
]
