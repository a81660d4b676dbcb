"""Results folders: what linkwright wrote is replaced, what it didn't write is left alone, one run at a time."""

from __future__ import annotations

import json
import os
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

import pytest
from click.testing import CliRunner, Result

import linkwright as lw
from app.models import SOUND, STUCK
from linkwright.app.manifest import NAME, OUTDATED, read_manifest
from linkwright.app.results_folder import LOCK, ResultsFolder
from linkwright.cli import cli
from linkwright.model.origin import Origin, hashed
from linkwright.studies.sampling_task import SampleTask
from studies.models import slider_crank

EXAMPLES = Path(__file__).parents[2] / "examples"
FILES = ["cycle.csv", NAME, "report.html", "summary.json"]
BROKEN = SOUND.replace("links:", "linkz:")
ORIGIN = Origin("a.yaml", "0" * 64)


@pytest.fixture
def model(tmp_path: Path) -> Path:
    path = tmp_path / "model.yaml"
    path.write_text(SOUND, "utf-8")
    return path


@pytest.fixture(scope="module")
def done(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The folder of a run of such a model."""
    path = tmp_path_factory.mktemp("done") / "model.yaml"
    path.write_text(SOUND, "utf-8")
    assert call("run", path).exit_code == 0
    return path.with_name("model_linkwright")


@pytest.fixture
def out(model: Path, done: Path) -> Path:
    """The folder of a run that is done."""
    return Path(shutil.copytree(done, model.with_name("model_linkwright")))


def call(*words: object) -> Result:
    return CliRunner().invoke(cli, [str(word) for word in words], catch_exceptions=False)


def names(folder: Path) -> list[str]:
    """All files below a folder, hidden ones too."""
    return sorted(str(p.relative_to(folder)).replace(os.sep, "/") for p in folder.rglob("*") if p.is_file())


def manifest(folder: Path) -> Any:
    return json.loads((folder / NAME).read_text("utf-8"))


def aside(*files: str) -> list[str]:
    return [f"{OUTDATED}/{name}" for name in files]


# The manifest.


def test_the_manifest_says_what_was_written_from_what(model: Path, out: Path) -> None:
    data = manifest(out)
    assert data["manifest"] == 1
    assert data["model"] == {"file": "model.yaml", "sha256": hashed(SOUND.encode()), "tables": {}}
    (part,) = data["written"].values()
    assert (part["state"], part["linkwright"]) == ("done", lw.__version__)
    listed = {entry["name"]: (entry["size"], entry["sha256"]) for entry in part["files"]}
    assert listed == {n: ((out / n).stat().st_size, hashed((out / n).read_bytes())) for n in FILES if n != NAME}


def test_the_hashes_of_tables_stand_there_too(tmp_path: Path) -> None:
    shutil.copy(EXAMPLES / "slider_crank_gas.yaml", tmp_path / "model.yaml")
    shutil.copy(EXAMPLES / "gas.csv", tmp_path)
    assert call("export", tmp_path / "model.yaml", "--to", "motor-expressions").exit_code == 0
    folder = tmp_path / "model_linkwright"
    assert manifest(folder)["model"]["tables"] == {"gas.csv": hashed((tmp_path / "gas.csv").read_bytes())}


# Nothing old looks current.


@pytest.mark.parametrize("text", [BROKEN, "{", STUCK.replace("start: 40 deg", "start: 170 deg")])
def test_after_a_model_that_is_refused_nothing_old_looks_current(model: Path, out: Path, text: str) -> None:
    model.write_text(text, "utf-8")
    result = call("run", model)
    assert result.exit_code in (1, 2)
    assert str(out / OUTDATED) in result.stderr
    assert names(out) == [NAME, *aside("cycle.csv", "report.html", "summary.json")]
    assert manifest(out)["written"]["studies"]["state"] == "failed"
    model.write_text(SOUND, "utf-8")
    assert call("run", model).exit_code == 0
    assert names(out) == FILES


def test_a_wrong_option_or_file_name_leaves_results_of_the_same_model(model: Path, out: Path) -> None:
    assert call("sweep", model, "--kernel", "abacus").exit_code == 2
    assert call("run", model.with_name("modell.yaml"), "--out", out).exit_code == 2
    assert names(out) == FILES


def test_two_models_that_are_refused_keep_the_last_results(model: Path, out: Path) -> None:
    page = (out / "report.html").read_bytes()
    for text in (BROKEN, BROKEN + "# again\n"):
        model.write_text(text, "utf-8")
        call("run", model)
    assert (out / OUTDATED / "report.html").read_bytes() == page


def test_an_interrupted_run_leaves_nothing_current(model: Path, out: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def interrupted(*given: object) -> None:
        raise KeyboardInterrupt

    with monkeypatch.context() as patch:
        patch.setattr("linkwright.app.job.report_data", interrupted)
        with pytest.raises(KeyboardInterrupt):
            lw.run(model, out)
    assert names(out) == [NAME, *aside("cycle.csv", "report.html", "summary.json")]
    assert manifest(out)["written"]["studies"]["state"] == "interrupted"


def test_a_fault_while_it_computes_is_a_failed_run(model: Path, out: Path) -> None:
    law = "position: 40 deg + 10 deg*sqrt(1 - t/(0.2 s))"
    model.write_text(SOUND.replace("speed: 120 rpm, start: 40 deg", law).replace("turns: 1 motor", "duration: 0.5 s"))
    assert call("run", model).exit_code in (1, 2)
    assert "cycle.csv" not in names(out)


def test_a_run_whose_requirements_fail_is_complete(model: Path, out: Path) -> None:
    model.write_text(STUCK, "utf-8")
    assert call("run", model).exit_code == 1
    assert names(out) == FILES
    assert manifest(out)["written"]["studies"]["state"] == "done"


def test_what_an_earlier_run_wrote_more_is_removed(model: Path, out: Path) -> None:
    assert call("run", model, "--netcdf").exit_code == 0
    assert "cycle.nc" in names(out)
    assert call("run", model).exit_code == 0
    assert names(out) == FILES


# Exports beside.


def test_an_export_of_the_same_model_stays_beside_the_results(model: Path, out: Path) -> None:
    assert call("export", model, "--to", "motor-expressions").exit_code == 0
    made = {*names(out)} - {*FILES}
    assert made and {*FILES} < {*names(out)}
    assert call("run", model).exit_code == 0
    assert {*names(out)} == {*FILES} | made


def test_an_export_of_a_changed_model_leaves_no_old_results_beside(model: Path, out: Path) -> None:
    model.write_text(SOUND + "# changed\n", "utf-8")
    assert call("export", model, "--to", "motor-expressions").exit_code == 0
    found = names(out)
    assert "report.html" not in found
    assert f"{OUTDATED}/report.html" in found
    assert call("run", model).exit_code == 0
    assert not [name for name in names(out) if name.startswith(OUTDATED)]


def test_an_export_asks_before_it_overwrites(model: Path) -> None:
    out = model.with_name("mine")
    out.mkdir()
    assert call("export", model, "--to", "motor-expressions", "--out", out).exit_code == 0
    file = next(name for name in names(out) if name != NAME)
    (out / file).write_text("mine", "utf-8")
    before = names(out)
    refused = call("export", model, "--to", "motor-expressions", "--out", out)
    assert (refused.exit_code, "folder.foreign" in refused.stderr) == (2, True)
    assert ((out / file).read_text("utf-8"), names(out)) == ("mine", before)
    assert call("export", model, "--to", "motor-expressions", "--out", out, "--force").exit_code == 0
    assert (out / file).read_text("utf-8") != "mine"


# Foreign files.


def test_all_foreign_files_are_named_and_left_alone(model: Path, tmp_path: Path) -> None:
    out = tmp_path / "mine"
    out.mkdir()
    for name in ("report.html", "cycle.csv", "notes.txt"):
        (out / name).write_text("mine", "utf-8")
    result = call("run", model, "--out", out)
    assert result.exit_code == 2
    assert "folder.foreign" in result.stderr
    assert "report.html, cycle.csv." in result.stderr
    assert "--force" in result.stderr
    assert names(out) == ["cycle.csv", "notes.txt", "report.html"]
    assert call("run", model, "--out", out, "--force").exit_code == 0
    assert names(out) == sorted([*FILES, "notes.txt"])
    assert (out / "notes.txt").read_text("utf-8") == "mine"


def test_they_are_looked_for_before_the_work(model: Path, out: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (out / "report.html").write_text("mine", "utf-8")
    monkeypatch.setattr("linkwright.app.job.perform", lambda *given: pytest.fail("it has begun to work"))
    assert call("run", model).exit_code == 2
    assert sorted({*names(out)} - {LOCK}) == FILES


def test_a_result_that_was_edited_is_foreign(model: Path, out: Path) -> None:
    (out / "cycle.csv").write_text("mine", "utf-8")
    (out / "summary.json").write_text((out / "summary.json").read_text("utf-8").replace("true", "True"), "utf-8")
    result = call("run", model, "--json")
    assert result.exit_code == 2
    (finding,) = json.loads(result.stdout)["findings"]
    assert finding["code"] == "folder.foreign"
    assert "summary.json, cycle.csv." in finding["what"]
    assert json.loads(result.stdout)["done"] is False
    assert names(out) == FILES


def test_an_edited_file_that_is_in_no_ones_way_stays(model: Path, out: Path) -> None:
    assert call("run", model, "--netcdf").exit_code == 0
    (out / "cycle.nc").write_text("mine", "utf-8")
    assert call("run", model).exit_code == 0
    assert (out / "cycle.nc").read_text("utf-8") == "mine"


def test_a_folder_without_a_manifest_is_another_ones(model: Path, out: Path) -> None:
    (out / NAME).unlink()
    assert call("run", model).exit_code == 2
    assert call("run", model, "--force").exit_code == 0
    assert names(out) == FILES


@pytest.mark.parametrize("text", ["", "{", "[]", '{"manifest": 2}', "mine"])
def test_a_damaged_manifest_is_no_manifest(model: Path, out: Path, text: str) -> None:
    (out / NAME).write_text(text, "utf-8")
    result = call("run", model)
    assert result.exit_code == 2
    assert NAME in result.stderr
    assert call("run", model, "--force").exit_code == 0


@pytest.mark.parametrize("name", ["../thesis.doc", "/etc/passwd", "..", "C:x", "a\\b"])
def test_a_manifest_never_leads_out_of_its_folder(out: Path, name: str) -> None:
    data = manifest(out)
    data["written"]["studies"]["files"][0]["name"] = name
    (out / NAME).write_text(json.dumps(data), "utf-8")
    assert read_manifest(out) is None
    data = manifest(out)
    data["written"]["studies"]["files"] = []
    data["written"]["studies"]["resumable"] = {name: "sweep"}
    (out / NAME).write_text(json.dumps(data), "utf-8")
    assert read_manifest(out) is None


def test_from_python(model: Path, tmp_path: Path) -> None:
    out = tmp_path / "mine"
    out.mkdir()
    (out / "cycle.csv").write_text("mine", "utf-8")
    with pytest.raises(lw.ModelError) as refused:
        lw.run(model, out)
    assert [finding.code for finding in refused.value.findings] == ["folder.foreign"]
    assert names(out) == ["cycle.csv"]
    assert lw.run(model, out, force=True).folder == out


# One at a time.


def test_a_second_run_is_refused_and_damages_nothing(model: Path, out: Path) -> None:
    with ResultsFolder(out, ORIGIN) as held:
        held.begin()
        before = names(out)
        result = call("run", model)
        assert result.exit_code == 2
        assert "folder.busy-with" in result.stderr
        assert f"a.yaml, started {ORIGIN.date}, process {os.getpid()}" in result.stderr
        assert names(out) == before
    assert LOCK not in names(out)
    assert call("run", model).exit_code == 0


def test_a_folder_that_was_only_just_locked(model: Path, tmp_path: Path) -> None:
    with ResultsFolder(tmp_path / "out", ORIGIN):
        assert "folder.busy" in call("run", model, "--out", tmp_path / "out").stderr


HELD = """\
import sys, time
from pathlib import Path
from linkwright.app.results_folder import ResultsFolder
from linkwright.model.origin import Origin
with ResultsFolder(Path(sys.argv[1]), Origin("other.yaml", "1" * 64)) as folder:
    folder.begin()
    folder.write("cycle.csv", "half a run")
    print("ready", flush=True)
    time.sleep(60)
"""


def test_a_killed_run_holds_nothing_and_its_files_are_replaced(model: Path, out: Path) -> None:
    """The lock is the system's: it ends with the process, though its file and the state "running" stay."""
    with subprocess.Popen([sys.executable, "-c", HELD, str(out)], stdout=subprocess.PIPE) as process:
        assert process.stdout is not None
        process.stdout.readline()
        assert "other.yaml" in call("run", model).stderr
        process.kill()
        process.wait()
    assert LOCK in names(out)
    assert manifest(out)["written"]["studies"]["state"] == "running"
    assert f"{OUTDATED}/report.html" in names(out)
    assert call("run", model).exit_code == 0
    assert names(out) == FILES


# Links that came with a folder lead nowhere.

LINKS = pytest.mark.skipif(os.name == "nt", reason="links are POSIX's")


def linked(path: Path, kind: str, elsewhere: Path) -> None:
    """A link in place of a path, to a file or a folder of another's, or to nothing."""
    if path.is_dir():
        shutil.rmtree(path)
    path.unlink(missing_ok=True)
    path.symlink_to({"file": elsewhere / "mine", "folder": elsewhere, "nothing": elsewhere / "new"}[kind])


@pytest.fixture
def elsewhere(tmp_path: Path) -> Path:
    (tmp_path / "elsewhere").mkdir()
    (tmp_path / "elsewhere" / "mine").write_text("mine", "utf-8")
    return tmp_path / "elsewhere"


def untouched(elsewhere: Path) -> bool:
    return {path.name: path.read_text("utf-8") for path in elsewhere.iterdir()} == {"mine": "mine"}


@LINKS
@pytest.mark.parametrize("kind", ["file", "folder", "nothing"])
@pytest.mark.parametrize("name", ["cycle.csv", "report.html", NAME, OUTDATED, LOCK])
def test_a_link_in_the_folder_is_refused_or_replaced(
    model: Path, out: Path, elsewhere: Path, name: str, kind: str
) -> None:
    linked(out / name, kind, elsewhere)
    refused = call("run", model)
    assert (refused.exit_code, name in refused.stderr, untouched(elsewhere)) == (2, True, True)
    assert call("run", model, "--force").exit_code == (2 if name == LOCK else 0)
    assert untouched(elsewhere)
    assert (out / name).is_symlink() is (name == LOCK)


@LINKS
def test_old_results_never_move_through_a_link(model: Path, out: Path, elsewhere: Path) -> None:
    """Not even where the file that is run has an error, so that only they are set aside."""
    linked(out / OUTDATED, "folder", elsewhere)
    model.write_text(BROKEN, "utf-8")
    assert call("run", model).exit_code == 2
    assert untouched(elsewhere)
    assert names(out) == FILES


@LINKS
def test_the_usual_folder_may_be_no_link_and_one_that_is_named_may(model: Path, tmp_path: Path) -> None:
    (tmp_path / "elsewhere").mkdir()
    (tmp_path / "model_linkwright").symlink_to(tmp_path / "elsewhere")
    for words in (["run", model], ["export", model, "--to", "motor-expressions"]):
        refused = call(*words)
        assert (refused.exit_code, "file.link" in refused.stderr) == (2, True)
    assert not names(tmp_path / "elsewhere")
    assert call("run", model, "--out", tmp_path / "model_linkwright").exit_code == 0
    assert names(tmp_path / "elsewhere") == FILES


@LINKS
@pytest.mark.parametrize("place", ["", "C.x", "C.x/c", "C.x/c/0", "zarr.json"])
def test_a_store_is_not_resumed_through_links(
    sweep: Path, tmp_path: Path, elsewhere: Path, place: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    pytest.importorskip("zarr")
    out = tmp_path / "out"
    stopped(sweep, out, monkeypatch)
    linked(out / "sweep.zarr" / place, "folder", elsewhere)
    for how in ([], ["--fresh"], ["--force"]):
        result = call("sweep", sweep, "--out", out, *how)
        assert untouched(elsewhere)
        if place or how != ["--force"]:
            assert (result.exit_code, "sweep.zarr" in result.stderr) == (2, True)


@LINKS
def test_states_are_not_read_through_links(
    sweep: Path, tmp_path: Path, elsewhere: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    pytest.importorskip("zarr")
    out = tmp_path / "out"
    stopped(sweep, out, monkeypatch)
    for name in manifest(out)["written"]["studies"]["resumable"]:
        if name != "sweep.zarr":
            linked(out / name, "file", elsewhere)
    assert "file.link" in call("sweep", sweep, "--out", out).stderr
    assert call("sweep", sweep, "--out", out, "--fresh").exit_code == 0
    assert untouched(elsewhere)


# Studies that go on.


@pytest.fixture
def sweep(tmp_path: Path) -> Path:
    asked = {"vary": {"r": {"normal": 50, "sigma": 0.1}}, "outputs": ["C.x"], "samples": 9000, "keep": "all"}
    studies = {"cycle": {"turns": "1 motor", "samples": 16}, "sweep": {**asked, "kernel": "numpy"}}
    lw.save(lw.Document.model_validate(slider_crank(studies=studies)), tmp_path / "model.yaml")
    return tmp_path / "model.yaml"


def stopped(sweep: Path, out: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A sweep that is interrupted with Ctrl-C in its first atom."""
    perform = SampleTask.perform

    def signalled(self: SampleTask, atom: int) -> Any:
        if atom == 0:
            signal.raise_signal(signal.SIGINT)
            time.sleep(0.1)
        return perform(self, atom)

    with monkeypatch.context() as patch:
        patch.setattr(SampleTask, "perform", signalled)
        with pytest.raises(KeyboardInterrupt):
            lw.sweep(sweep, out=out, workers=1)


def test_an_interrupted_sweep_goes_on_and_leaves_no_state(
    sweep: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    zarr = pytest.importorskip("zarr")
    out = tmp_path / "out"
    stopped(sweep, out, monkeypatch)
    part = manifest(out)["written"]["studies"]
    assert part["state"] == "interrupted"
    assert {name.split("-")[0] for name in part["resumable"]} == {"sweep", "sweep.zarr", "sweep.zarr.checkpoint"}
    assert {*part["resumable"]} == {p.name for p in out.iterdir()} - {NAME}
    lw.sweep(sweep, out=out, workers=1)
    assert {p.name for p in out.iterdir()} == {NAME, "report.html", "summary.json", "sweep.csv", "sweep_bands.csv"} | {
        "sweep.zarr"
    }
    (entry,) = [entry for entry in manifest(out)["written"]["studies"]["files"] if entry["name"] == "sweep.zarr"]
    assert entry["files"] > 3
    lw.sweep(sweep, out=tmp_path / "whole")
    values, whole = (zarr.open_group(f / "sweep.zarr", mode="r")["C.x"][...] for f in (out, tmp_path / "whole"))
    assert values.shape == (9000, 17)
    assert (values == whole).all()
    assert call("sweep", sweep, "--out", out).exit_code == 0  # and once more, over its own store


def test_a_sweep_that_another_version_has_begun_is_refused(
    sweep: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Of linkwright or of the kernel: it is named, with the way on."""
    pytest.importorskip("zarr")
    out = tmp_path / "out"
    with monkeypatch.context() as patch:
        patch.setattr("linkwright._version.__version__", "0.0.9")
        stopped(sweep, out, monkeypatch)
    refused = call("sweep", sweep, "--out", out)
    assert refused.exit_code == 2
    assert f"started with linkwright 0.0.9; this is linkwright {lw.__version__}" in refused.stderr
    assert "--fresh" in refused.stderr
    stopped(sweep, tmp_path / "other", monkeypatch)
    monkeypatch.setattr("linkwright.kernels.numpy_blocks.NumpyKernel.packages", ("pytest",))
    assert "this is kernel numpy pytest " in call("sweep", sweep, "--out", tmp_path / "other").stderr
    assert call("sweep", sweep, "--out", out, "--fresh").exit_code == 0


def test_the_state_of_another_model_is_removed_once_a_sweep_is_done(
    sweep: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    text = sweep.read_text("utf-8").replace("keep: all", "keep: reduced")
    sweep.write_text(text, "utf-8")
    out = tmp_path / "out"
    stopped(sweep, out, monkeypatch)
    state = {p.name for p in out.iterdir()} - {NAME}
    sweep.write_text(text.replace("samples: 9000", "samples: 50"), "utf-8")
    assert call("run", sweep.with_name("nothing.yaml"), "--out", out).exit_code == 2
    assert state < {p.name for p in out.iterdir()}
    assert call("sweep", sweep, "--out", out).exit_code == 0
    assert not state & {p.name for p in out.iterdir()}


def test_a_foreign_store_is_not_overwritten(sweep: Path, tmp_path: Path) -> None:
    out = tmp_path / "out"
    (out / "sweep.zarr").mkdir(parents=True)
    (out / "sweep.zarr" / "mine").write_text("mine", "utf-8")
    result = call("sweep", sweep, "--out", out)
    assert result.exit_code == 2
    assert "sweep.zarr" in result.stderr
    assert (out / "sweep.zarr" / "mine").exists()


def test_two_sweeps_at_once_into_one_store(sweep: Path, tmp_path: Path) -> None:
    """The second is refused; the first loses nothing."""
    zarr = pytest.importorskip("zarr")
    out = tmp_path / "out"
    command = [sys.executable, "-m", "linkwright", "sweep", str(sweep), "--out", str(out)]
    text = sweep.read_text("utf-8").replace("samples: 9000", "samples: 60000").replace("samples: 16", "samples: 100")
    sweep.write_text(text, "utf-8")
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE) as first:
        begun = time.monotonic()
        while not (out / "sweep.zarr").exists() and time.monotonic() - begun < 60:
            time.sleep(0.02)
        second = call("sweep", sweep, "--out", out)
        _, complaint = first.communicate(timeout=120)
    assert first.returncode == 0, complaint
    assert (second.exit_code, "folder.busy-with" in second.stderr) == (2, True)
    values = zarr.open_group(out / "sweep.zarr", mode="r")["C.x"][...]
    assert values.shape == (60000, 101)
    assert (values == values).all()  # no NaN, which stands where nothing was written


# Where results come from.


def test_summary_and_report_name_their_origin(model: Path, out: Path) -> None:
    summary = json.loads((out / "summary.json").read_text("utf-8"))
    assert summary["model"] == {"file": "model.yaml", "sha256": hashed(SOUND.encode())}
    assert len(summary["date"].split("T")[1]) == len("20:04:46+00:00")
    page = (out / "report.html").read_text("utf-8")
    for said in (
        "model.yaml",
        hashed(SOUND.encode())[:12],
        f"{summary['date'][:10]} {summary['date'][11:16]}",
        lw.__version__,
    ):
        assert said in page[page.index('class="title-block"') :][:1000]


def test_a_document_has_an_origin_too(tmp_path: Path) -> None:
    document = lw.Document.model_validate(slider_crank(studies={"cycle": {"turns": "1 motor", "samples": 8}}))
    lw.run(document, tmp_path / "out")
    summary = json.loads((tmp_path / "out" / "summary.json").read_text("utf-8"))
    assert summary["model"] == {"file": None, "sha256": hashed(lw.dump(document).encode())}
    assert "made in Python" in (tmp_path / "out" / "report.html").read_text("utf-8")


def test_the_manifest_of_a_document_is_read_back(tmp_path: Path) -> None:
    """It names no file; what is read is what was written."""
    with ResultsFolder(tmp_path / "out", Origin(None, "0" * 64)) as folder:
        folder.begin(["a.csv"])
        folder.write("a.csv", "a")
        folder.done()
    found = read_manifest(folder.path)
    assert found is not None and found.model.file is None and "file" not in manifest(folder.path)["model"]
    before = (folder.path / NAME).read_bytes()
    found.write(folder.path)
    assert (folder.path / NAME).read_bytes() == before


def test_csv_files_name_their_origin_where_asked(model: Path, out: Path) -> None:
    plain = (out / "cycle.csv").read_text("utf-8")
    assert plain.startswith("t [s],")
    assert call("run", model, "--csv-comments").exit_code == 0
    text = (out / "cycle.csv").read_text("utf-8")
    comments, table = text[: text.index("t [s],")], text[text.index("t [s],") :]
    assert table == plain
    lines = comments.splitlines()
    assert all(line.startswith("# ") for line in lines)
    assert lines[:3] == [
        f"# linkwright {lw.__version__}",
        "# model: model.yaml",
        f"# model sha256: {hashed(SOUND.encode())}",
    ]


def test_the_date_is_the_one_that_is_set(model: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Then two runs write the same bytes, the manifest's too."""
    monkeypatch.setenv("SOURCE_DATE_EPOCH", "1750000000")
    for name in ("a", "b"):
        assert call("run", model, "--netcdf", "--out", tmp_path / name).exit_code == 0
    for name in (*FILES, "cycle.nc"):
        assert (tmp_path / "a" / name).read_bytes() == (tmp_path / "b" / name).read_bytes()
    assert manifest(tmp_path / "a")["written"]["studies"]["date"] == "2025-06-15T15:06:40+00:00"
