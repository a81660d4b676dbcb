"""What the commands do, for Python too: examine a model file, perform its studies, write the results."""

from linkwright.app.assembly_modes import ModesJob, modes, modes_of_file
from linkwright.app.bench import Bench, bench_file
from linkwright.app.job import Examined, Job, check, examine_file, perform, run, write
from linkwright.app.sweeps import examine_sweep, runner_of, sweep

__all__ = [
    "Bench",
    "Examined",
    "Job",
    "ModesJob",
    "bench_file",
    "check",
    "examine_file",
    "examine_sweep",
    "modes",
    "modes_of_file",
    "perform",
    "run",
    "runner_of",
    "sweep",
    "write",
]
