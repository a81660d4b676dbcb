"""What the commands do, for Python too: examine a model file, perform its studies, write the results."""

from typing import TYPE_CHECKING

from linkwright._lazy import names_of

if TYPE_CHECKING:
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

_PLACES = {
    "Bench": "linkwright.app.bench.Bench",
    "Examined": "linkwright.app.job.Examined",
    "ExportJob": "linkwright.app.exports.ExportJob",
    "Job": "linkwright.app.job.Job",
    "ModesJob": "linkwright.app.assembly_modes.ModesJob",
    "Writing": "linkwright.app.job.Writing",
    "accuracy": "linkwright.app.accuracies.accuracy",
    "bench_file": "linkwright.app.bench.bench_file",
    "carry_out": "linkwright.app.job.carry_out",
    "check": "linkwright.app.job.check",
    "examine_alone": "linkwright.app.single_study.examine_alone",
    "examine_export": "linkwright.app.exports.examine_export",
    "examine_file": "linkwright.app.job.examine_file",
    "export": "linkwright.app.exports.export",
    "export_batch": "linkwright.app.batch.export_batch",
    "export_into": "linkwright.app.exports.export_into",
    "export_of": "linkwright.app.exports.export_of",
    "modes": "linkwright.app.assembly_modes.modes",
    "modes_of_file": "linkwright.app.assembly_modes.modes_of_file",
    "no_target": "linkwright.app.exports.no_target",
    "perform": "linkwright.app.job.perform",
    "placed": "linkwright.app.single_study.placed",
    "plate_cam": "linkwright.app.cams.plate_cam",
    "run": "linkwright.app.job.run",
    "runner_of": "linkwright.app.single_study.runner_of",
    "sweep": "linkwright.app.sweeps.sweep",
    "workspace": "linkwright.app.workspaces.workspace",
    "write": "linkwright.app.job.write",
}

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

__getattr__ = names_of(__name__, _PLACES)
