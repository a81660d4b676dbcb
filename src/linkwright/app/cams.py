"""The cam study by itself: that of a file, or one stated in Python."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from linkwright.app.job import read_file
from linkwright.app.single_study import perform_alone
from linkwright.model.document import Document
from linkwright.studies.cam.outcome import CamOutcome


def plate_cam(
    model: str | Path | Document,
    name: str | None = None,
    *,
    post: str | Sequence[str] | None = None,
    options: Mapping[str, Any] | None = None,
    out: str | Path | None = None,
    folder: str | Path | None = None,
    force: bool = False,
) -> CamOutcome:
    """A plate cam from its law to its NC code.

    What isn't given is that of the file's study ``cam``: ``name`` of the cam (its key ``cam``), ``post``, the controls
    that NC code is written for (``nc: post``); ``options`` are further keys of it, written as there. With ``out``, a
    folder, files are written there, over those that linkwright didn't write only with ``force``. Raises
    :class:`ModelError` with all findings.
    """
    given = {**(options or {}), **({"cam": name} if name is not None else {})}
    document = model if isinstance(model, Document) else read_file(Path(model)).document
    outcome = perform_alone(model, "cam", given | _posts(document, given, post), out=out, folder=folder, force=force)
    assert isinstance(outcome, CamOutcome)
    return outcome


def _posts(document: Document | None, given: Mapping[str, Any], post: str | Sequence[str] | None) -> dict[str, Any]:
    """The section ``nc`` with other controls."""
    if post is None:
        return {}
    stated = (document.studies.get("cam") or {}) if document is not None else {}
    section = given.get("nc", stated.get("nc"))
    return {"nc": {**(section or {}), "post": [post] if isinstance(post, str) else [*post]}}
