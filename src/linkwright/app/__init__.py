"""What the commands do, for Python too: examine a model file, perform its studies, write the results."""

from linkwright.app.accuracies import accuracy
from linkwright.app.assembly_modes import ModesJob, modes, modes_of_file
from linkwright.app.batch import export_batch
from linkwright.app.bench import Bench, bench_file
from linkwright.app.cams import plate_cam
from linkwright.app.exports import ExportJob, examine_export, export, export_into, export_of, no_target
from linkwright.app.job import Examined, Job, Writing, carry_out, check, examine_file, perform, run, write
from linkwright.app.single_study import examine_alone, placed, runner_of
from linkwright.app.sweeps import sweep
from linkwright.app.workspaces import workspace

__all__ = [
    "Bench",
    "Examined",
    "ExportJob",
    "Job",
    "ModesJob",
    "Writing",
    "accuracy",
    "bench_file",
    "carry_out",
    "check",
    "examine_alone",
    "examine_export",
    "examine_file",
    "export",
    "export_batch",
    "export_into",
    "export_of",
    "modes",
    "modes_of_file",
    "no_target",
    "perform",
    "placed",
    "plate_cam",
    "run",
    "runner_of",
    "sweep",
    "workspace",
    "write",
]
