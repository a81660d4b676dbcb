"""Checking and running model files and documents from Python."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

import linkwright as lw
from app.models import FORM, FORM_LINES, KINDS, NAMES, NAMES_LINES, NO_STUDY, SOUND, STUCK, UNMET, WARNED
from linkwright.app import examine_file, perform
from linkwright.studies import STUDIES


def file(folder: Path, text: str) -> Path:
    path = folder / "model.yaml"
    path.write_text(text, "utf-8")
    return path


def test_check_of_a_sound_file(tmp_path: Path) -> None:
    path = file(tmp_path, SOUND)
    assert lw.check(path) == []
    assert lw.check(str(path)) == []
    assert lw.check(lw.load(path)) == []
    assert sorted(p.name for p in tmp_path.iterdir()) == ["model.yaml"]


def without_origin(summary: dict[str, Any]) -> dict[str, Any]:
    """A summary without what tells two runs of one model apart."""
    return {key: value for key, value in summary.items() if key not in ("model", "date")}


def test_run_of_a_file_and_of_its_document_are_one(tmp_path: Path) -> None:
    path = file(tmp_path, SOUND)
    jobs = [lw.run(path), lw.run(str(path)), lw.run(lw.load(path))]
    for job in jobs:
        assert isinstance(job, lw.Job)
        assert job.exit_code == 0
        assert job.folder is None
        assert without_origin(job.summary) == without_origin(jobs[0].summary)
    assert sorted(p.name for p in tmp_path.iterdir()) == ["model.yaml"]


def test_run_writes_where_it_is_told(tmp_path: Path) -> None:
    out = tmp_path / "deep" / "down"
    job = lw.run(file(tmp_path, SOUND), out)
    assert job.folder == out
    assert sorted(p.name for p in out.iterdir()) == [
        "cycle.csv",
        "linkwright-manifest.json",
        "report.html",
        "summary.json",
    ]
    assert json.loads((out / "summary.json").read_text("utf-8")) == json.loads(json.dumps(job.summary))


def test_what_an_outcome_shows_is_made_once(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    study, made = STUDIES["cycle"], []
    report = study.report
    monkeypatch.setattr(study, "report", lambda outcome: made.append(outcome) or report(outcome))
    job = lw.run(file(tmp_path, SOUND), tmp_path / "out")
    assert job.summary and job.outcomes.reports()
    assert made == [job.cycle]
    job.outcomes["cycle"] = lw.run(file(tmp_path, SOUND)).cycle
    assert job.outcomes.reports() and made == [made[0], job.cycle]


@pytest.mark.parametrize(("text", "code"), KINDS.values(), ids=KINDS)
def test_exit_code_by_kind(tmp_path: Path, text: str, code: int) -> None:
    job = perform(examine_file(file(tmp_path, text)))
    assert job.exit_code == code
    assert job.summary["done"] is (code == 0)
    if code:
        findings = [f for f in job.summary["findings"] if f["severity"] == "error"]
        assert findings or [m for m in job.summary["measures"].values() if m.get("met") is False]


@pytest.mark.parametrize(("text", "lines"), [(FORM, FORM_LINES), (NAMES, NAMES_LINES)], ids=["form", "names"])
def test_every_fault_at_once_each_with_its_line(tmp_path: Path, text: str, lines: list[int]) -> None:
    path = file(tmp_path, text)
    found = lw.check(path)
    assert sorted({finding.line for finding in found}) == lines
    for finding in found:
        assert isinstance(finding, lw.Finding)
        assert finding.severity == "error"
        assert finding.element
        assert len(finding.what) > 10
        assert len(finding.mend) > 5
    with pytest.raises(lw.ModelError) as caught:
        lw.run(path)
    assert list(caught.value.findings) == found
    for finding in found:
        assert finding.what in str(caught.value)
        assert f"line {finding.line}" in str(caught.value)


def test_a_document_has_no_lines_but_the_same_findings(tmp_path: Path) -> None:
    path = file(tmp_path, NAMES)
    of_file, of_document = lw.check(path), lw.check(lw.load(path))
    assert {f.element: f.located(None) for f in of_file} == {f.element: f for f in of_document}
    assert all(f.line is None for f in of_document)


@pytest.mark.parametrize(
    ("name", "code"),
    [("nowhere.yaml", "file.not-found"), ("", "file.irregular"), ("a\0b", "file.unreadable")],
    ids=["missing", "a folder", "no name"],
)
def test_a_file_that_can_not_be_read(tmp_path: Path, name: str, code: str) -> None:
    path = tmp_path / name
    (finding,) = lw.check(path)
    assert finding.code == code
    assert str(path).replace("\0", r"\x00") in finding.what
    with pytest.raises(lw.ModelError):
        lw.run(path)


def test_a_file_of_no_sane_size_is_not_even_read(tmp_path: Path) -> None:
    path = tmp_path / "huge.yaml"
    with path.open("wb") as stream:
        stream.truncate(1 << 33)
    (finding,) = lw.check(path)
    assert finding.code == "file.too-large"


def test_a_motion_that_stops_is_no_exception(tmp_path: Path) -> None:
    job = lw.run(file(tmp_path, STUCK))
    assert job.cycle is not None
    assert [f.code for f in job.cycle.failures] == ["motion.cannot-assemble"]
    assert job.exit_code == 1
    assert not job.cycle.done


def test_a_requirement_not_met_is_no_exception(tmp_path: Path) -> None:
    job = lw.run(file(tmp_path, UNMET))
    assert job.cycle is not None
    assert job.cycle.failures == []
    assert job.exit_code == 1


def test_a_warning_is_told_and_stops_nothing(tmp_path: Path) -> None:
    job = lw.run(file(tmp_path, WARNED))
    assert job.exit_code == 0
    (finding,) = job.summary["findings"]
    assert (finding["code"], finding["severity"]) == ("motion.not-periodic", "warning")


def test_compile_raises_with_every_finding(tmp_path: Path) -> None:
    document = lw.load(file(tmp_path, NAMES))
    with pytest.raises(lw.ModelError) as caught:
        lw.compile(document)
    assert {f.path[0] for f in caught.value.findings} == {"drives", "measures", "require"}


def test_compile_takes_what_check_and_run_take(tmp_path: Path) -> None:
    path = file(tmp_path, SOUND)
    programs = [lw.compile(model) for model in (path, str(path), lw.load(path))]
    assert len({repr(program) for program in programs}) == 1
    with pytest.raises(lw.ModelError) as caught:
        lw.compile(file(tmp_path, NAMES))
    assert {(f.path[0], f.line) for f in caught.value.findings if f.path[0] in ("drives", "measures")} <= {
        (f.path[0], f.line) for f in lw.check(path)
    }
    assert all(f.line for f in caught.value.findings)
    with pytest.raises(lw.ModelError) as caught:
        lw.compile("nowhere.yaml")
    assert [f.code for f in caught.value.findings] == ["file.not-found"]


def test_dump_and_save_want_a_document(tmp_path: Path) -> None:
    path = str(file(tmp_path, SOUND))
    for wrong in (lambda: lw.dump(path), lambda: lw.save(path, tmp_path / "copy.yaml")):  # type: ignore[arg-type]
        with pytest.raises(TypeError, match=r"linkwright\.load"):
            wrong()


def test_load_raises_with_every_finding(tmp_path: Path) -> None:
    with pytest.raises(lw.ModelError) as caught:
        lw.load(file(tmp_path, FORM))
    assert sorted({f.line for f in caught.value.findings}) == FORM_LINES
    with pytest.raises(OSError):
        lw.load(tmp_path / "nowhere.yaml")


def test_a_model_error_survives_pickling(tmp_path: Path) -> None:
    import pickle

    with pytest.raises(lw.ModelError) as caught:
        lw.run(file(tmp_path, NAMES))
    again = pickle.loads(pickle.dumps(caught.value))
    assert again.findings == caught.value.findings
    assert str(again) == str(caught.value)


def test_the_same_run_twice_is_the_same_to_the_bit(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Their date apart, which they write as they are told."""
    monkeypatch.setenv("SOURCE_DATE_EPOCH", "1750000000")
    path = file(tmp_path, SOUND)
    for name in ("one", "two"):
        lw.run(path, tmp_path / name)
    for name in ("cycle.csv", "summary.json", "report.html"):
        assert (tmp_path / "one" / name).read_bytes() == (tmp_path / "two" / name).read_bytes()


def test_notes_come_last_and_change_no_exit_code(tmp_path: Path) -> None:
    """Gravity of 9.81 mm/s^2 is a warning, 1 deg/s a note, though it stands before it."""
    text = SOUND.replace("gravity: [0, -9.80665 m/s^2]\n", "").replace("120 rpm", "1")
    path = file(tmp_path, text.replace("studies:", "gravity: [0, -9.81]\nstudies:"))
    assert [(f.code, f.severity) for f in lw.check(path)] == [("gravity.size", "warning"), ("plausible.speed", "note")]
    job = lw.run(path, tmp_path / "out")
    assert job.exit_code == 0
    assert [f["severity"] for f in job.summary["findings"]] == ["warning", "note"]
    page = (tmp_path / "out" / "report.html").read_text("utf-8").replace("\u00a0", " ")
    assert '<section id="errors"' not in page and "Errors" not in page.split("<main>")[0]
    banner, notes = (page.split(f'<section id="{name}"')[1].split("</section>")[0] for name in ("warnings", "notes"))
    assert "gravity.size" in banner and "plausible.speed" not in banner
    assert "plausible.speed" in notes
    assert "240 deg/s" not in page and "motor: crank on frame, 1 deg/s = 0.166667 rpm, 360 s per revolution" in page


def test_a_warning_is_no_study(tmp_path: Path) -> None:
    path = file(tmp_path, NO_STUDY.replace("-9.80665 m/s^2", "-9.81"))
    job = perform(examine_file(path))
    assert {f["code"] for f in job.summary["findings"]} == {"gravity.size", "study.none"}
