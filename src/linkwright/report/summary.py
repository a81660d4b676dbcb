"""What ``summary.json`` holds of some outcomes."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from linkwright.findings import Finding, Said
from linkwright.model.document import Document
from linkwright.model.origin import Origin
from linkwright.results import Result
from linkwright.studies.registry import Outcomes

SCHEMA = 2
"""The version of the layout of ``summary.json``: 2 has grades, and ``null`` with ``unbounded`` where 1 had numbers."""


def drawn(outcomes: Outcomes) -> Result | None:
    """What the report of some outcomes draws."""
    results = (outcomes[name].result for name in outcomes.ranked())
    return next((result for result in results if result is not None), None)


def found(outcomes: Outcomes) -> list[Finding]:
    """What the studies found: failures and warnings; no warning of what is another one's failure."""
    failures = [finding for outcome in outcomes.values() for finding in outcome.failures]
    warnings = [finding for outcome in outcomes.values() for finding in outcome.warnings]
    told = {(finding.code, finding.path) for finding in failures}
    return [*failures, *(finding for finding in warnings if (finding.code, finding.path) not in told)]


def summary(document: Document, outcomes: Outcomes, findings: list[Finding], origin: Origin) -> dict[str, Any]:
    """What ``summary.json`` holds: origin, name, author, revision, verdict, the entries of each study, all findings of
    the file and its run."""
    done = bool(outcomes) and all(outcome.done for outcome in outcomes.values())
    done = done and not any(finding.severity == "error" for finding in findings)
    data: dict[str, Any] = {"schema": SCHEMA, "linkwright": origin.version, **origin.as_dict()}
    head = {"name": document.title, "author": document.author, "revision": document.revision}
    data |= {key: text for key, text in head.items() if text is not None} | {"done": done}
    for report in outcomes.reports():
        entry = dict(report.summary)
        if "measures" in entry:  # the file's own stay what they are
            entry |= {"measures": entry["measures"] | data.get("measures", {})}
        data |= entry
    return dict(worded(data)) | {"findings": [finding.as_dict() for finding in findings]}


def worded(data: Any) -> Any:
    """Plain data with its texts in words."""
    if isinstance(data, Mapping):
        return {key: worded(value) for key, value in data.items()}
    if isinstance(data, list | tuple):
        return [worded(value) for value in data]
    return str(data) if isinstance(data, Said) else data
