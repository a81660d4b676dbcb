"""linkwright: planar mechanisms from one readable file.

    import linkwright as lw
    job = lw.run("paper_feeder.yaml")
    job.cycle.result["E.vx"]            # m/s, one value a sampled time

The names below are the public ones; each is loaded when it is first used.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from linkwright._lazy import names_of
from linkwright._version import __version__ as __version__

if TYPE_CHECKING:
    from linkwright.app import Job, accuracy, check, export, modes, plate_cam, run, sweep, workspace
    from linkwright.compilation import compile_model as compile
    from linkwright.findings import Finding, ModelError
    from linkwright.kernels import Compiled
    from linkwright.model.builder import Builder
    from linkwright.model.document import Document, dump, load, save
    from linkwright.model.mechanism import Mechanism
    from linkwright.results import Certificate, Result, Run
    from linkwright.words import in_language


_PLACES = {
    "Builder": "linkwright.model.builder.Builder",
    "Certificate": "linkwright.results.Certificate",
    "Compiled": "linkwright.kernels.Compiled",
    "Document": "linkwright.model.document.Document",
    "Finding": "linkwright.findings.Finding",
    "Job": "linkwright.app.Job",
    "Mechanism": "linkwright.model.mechanism.Mechanism",
    "ModelError": "linkwright.findings.ModelError",
    "Result": "linkwright.results.Result",
    "Run": "linkwright.results.Run",
    "accuracy": "linkwright.app.accuracy",
    "check": "linkwright.app.check",
    "compile": "linkwright.compilation.compile_model",
    "dump": "linkwright.model.document.dump",
    "export": "linkwright.app.export",
    "in_language": "linkwright.words.in_language",
    "load": "linkwright.model.document.load",
    "modes": "linkwright.app.modes",
    "plate_cam": "linkwright.app.plate_cam",
    "run": "linkwright.app.run",
    "save": "linkwright.model.document.save",
    "sweep": "linkwright.app.sweep",
    "workspace": "linkwright.app.workspace",
}

__all__ = [
    "Builder",
    "Certificate",
    "Compiled",
    "Document",
    "Finding",
    "Job",
    "Mechanism",
    "ModelError",
    "Result",
    "Run",
    "accuracy",
    "check",
    "compile",
    "dump",
    "export",
    "in_language",
    "load",
    "modes",
    "plate_cam",
    "run",
    "save",
    "sweep",
    "workspace",
]


__getattr__ = names_of(__name__, _PLACES)


def __dir__() -> list[str]:
    return [*__all__, "__version__"]
