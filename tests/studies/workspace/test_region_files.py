"""Regions kept in files: taken again bit by bit, never those of another study, never damaged ones."""

from __future__ import annotations

import errno
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

import linkwright as lw
from helpers.workspaces import arm, five_bar, four_bar
from linkwright.blocks import Threads, checkpoint
from linkwright.blocks.packing import pack
from linkwright.findings import ModelError
from linkwright.model.document import parse_document
from linkwright.studies.interruption import Stopped
from linkwright.studies.run_context import RunContext
from linkwright.studies.workspace import study
from linkwright.studies.workspace.options import WorkspaceOptions
from linkwright.studies.workspace.outcome import WorkspaceOutcome
from linkwright.studies.workspace.region_files import FOLDER, common
from linkwright.studies.workspace.regions import Region
from linkwright.studies.workspace.sheet import ModeSheet
from linkwright.studies.workspace.study import WorkspaceStudy

VALUES = [30, 35, 20, 25, 28]
SMALL = {"chord": 1e-3, "drives": {"motor": [80, 120], "servo": [40, 100]}}


def outcome_of(data: dict[str, Any], site: RunContext) -> WorkspaceOutcome:
    document = parse_document(data)
    assert document is not None
    options = WorkspaceOptions.model_validate(data["studies"]["workspace"])
    return WorkspaceStudy().run(lw.compile(document, site.folder), options, site)


def interrupted(data: dict[str, Any], out: Path, after: int = 2) -> int:
    """Interrupt a study after so many regions; how many it has kept by then."""

    def told(done: int, total: int) -> None:
        if done >= after:
            raise KeyboardInterrupt

    with pytest.raises(Stopped) as stopped:
        outcome_of(data, RunContext(out=out, progress=told))
    kept = len([*(out / FOLDER).iterdir()])
    (failure,) = stopped.value.outcome.failures
    assert failure.data["done"] == kept
    return kept


def bits(outcome: WorkspaceOutcome) -> list[Any]:
    """All that the regions and curves of an outcome hold, as bytes."""
    made = [pack((one.regions, one.curves, one.turning), {ModeSheet: "sheet"}) for one in outcome.workspaces]
    warnings = [pack(outcome.warnings)]
    return [
        {name: (array.dtype, array.shape, array.tobytes()) for name, array in one.items()} for one in made + warnings
    ]


@pytest.fixture
def found(monkeypatch: pytest.MonkeyPatch) -> list[tuple[float, ...]]:
    """The parameters of all regions that are computed, and not taken from their files."""
    computed: list[tuple[float, ...]] = []
    find = study._search_mode

    def counted(outcome: Any, signs: Any, parameters: Any) -> Any:
        computed.append(tuple(parameters))
        return find(outcome, signs, parameters)

    monkeypatch.setattr(study, "_search_mode", counted)
    return computed


MODELS: dict[str, dict[str, Any]] = {
    "regions": arm(chord=1e-3, **{"for": {"b": VALUES}}),
    "modes": five_bar(**SMALL, **{"for": {"base": [9, 10]}}),
    "curves": four_bar(chord=1e-4, **{"for": {"l": [40, 41, 42]}}),
}


@pytest.mark.parametrize("model", MODELS)
def test_resumed_it_gives_the_same_bits(model: str, tmp_path: Path, found: list[tuple[float, ...]]) -> None:
    whole = outcome_of(MODELS[model], RunContext())
    total = len(found)
    kept = interrupted(MODELS[model], tmp_path)
    assert 2 <= kept < total
    found.clear()
    told: list[tuple[int, int]] = []
    resumed = outcome_of(MODELS[model], RunContext(out=tmp_path, progress=lambda *done: told.append(done)))
    assert len(found) == total - kept
    assert told[-1] == (total, total)
    assert bits(resumed) == bits(whole)
    found.clear()
    again = outcome_of(MODELS[model], RunContext(out=tmp_path, runner=Threads(3)))
    assert not found and bits(again) == bits(whole)


def test_the_sheet_of_a_region_that_is_taken_is_that_of_its_values(tmp_path: Path) -> None:
    data = arm(chord=1e-3, **{"for": {"b": [30, 35]}})
    outcome_of(data, RunContext(out=tmp_path))
    for one in outcome_of(data, RunContext(out=tmp_path)).workspaces:
        (reached,) = one.regions
        x = reached.region.sheet.place(reached.region.mesh.q[:, :1] * 0)[0][0]
        assert x == pytest.approx(0.04 + one.values["b"])


def test_that_a_mode_reaches_nothing_is_kept_too(tmp_path: Path, found: list[tuple[float, ...]]) -> None:
    data = arm(point="B")
    first = outcome_of(data, RunContext(out=tmp_path))
    assert len(found) == 1 and [f.code for f in first.failures] == ["workspace.no-area"]
    second = outcome_of(data, RunContext(out=tmp_path))
    assert len(found) == 1 and second.failures == first.failures


def test_faults_are_kept_with_their_regions(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Half of the annulus taken away from each region that is made."""
    import shapely

    made = study.region

    def halved(*given: Any, **more: Any) -> Region:
        whole = made(*given, **more)
        return replace(whole, shape=whole.shape.intersection(shapely.box(0, -1, 1, 1)))

    monkeypatch.setattr(study, "region", halved)
    first = outcome_of(arm(chord=1e-3), RunContext(out=tmp_path))
    monkeypatch.setattr(study, "region", None)
    second = outcome_of(arm(chord=1e-3), RunContext(out=tmp_path))
    assert [f.code for f in first.failures] == ["workspace.incomplete"]
    assert second.failures == first.failures


def _flipped(content: bytes) -> bytes:
    middle = len(content) // 2
    return content[:middle] + bytes([content[middle] ^ 1]) + content[middle + 1 :]


DAMAGES: dict[str, Callable[[bytes], bytes]] = {
    "a bit flipped": _flipped,
    "truncated": lambda content: content[: len(content) // 2],
    "empty": lambda content: b"",
    "another kind of file": lambda content: b"type: FeatureCollection\n",
}


@pytest.mark.parametrize("damage", DAMAGES)
def test_a_damaged_file_is_told_and_its_region_found_again(
    damage: str, tmp_path: Path, found: list[tuple[float, ...]]
) -> None:
    data = arm(chord=1e-3, **{"for": {"b": [30, 35]}})
    whole = outcome_of(data, RunContext(out=tmp_path))
    path = min((tmp_path / FOLDER).iterdir())
    sound = path.read_bytes()
    path.write_bytes(DAMAGES[damage](sound))
    found.clear()
    mended = outcome_of(data, RunContext(out=tmp_path))
    assert len(found) == 1 and mended.done
    (note,) = mended.warnings
    assert (note.code, note.severity) == ("workspace.part-damaged", "note")
    assert str(path) in note.what and note.mend
    assert bits(mended)[:-1] == bits(whole)[:-1]
    assert path.read_bytes() == sound
    assert not outcome_of(data, RunContext(out=tmp_path)).warnings


def test_a_sound_file_of_another_region_is_not_taken(tmp_path: Path) -> None:
    data = arm(chord=1e-3, **{"for": {"b": [30, 35]}})
    whole = outcome_of(data, RunContext(out=tmp_path))
    first, second = sorted((tmp_path / FOLDER).iterdir())
    first.write_bytes(second.read_bytes())
    mended = outcome_of(data, RunContext(out=tmp_path))
    assert [f.code for f in mended.warnings] == ["workspace.part-damaged"]
    assert bits(mended)[:-1] == bits(whole)[:-1]


def test_a_file_of_classes_that_have_changed_is_not_taken(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Written with a region that had a field more; its checksum and its key are right."""
    import linkwright.blocks.packing as packing

    data = arm(chord=1e-3)
    whole = outcome_of(data, RunContext(out=tmp_path))
    (path,) = (tmp_path / FOLDER).iterdir()
    fields = packing.fields

    def fewer(kind: Any) -> Any:
        name = kind.__name__ if isinstance(kind, type) else type(kind).__name__
        return [f for f in fields(kind) if (name, f.name) != ("Region", "rough")]

    with monkeypatch.context() as patch:
        patch.setattr(packing, "fields", fewer)
        outcome_of(data, RunContext(out=tmp_path, fresh=True))
    assert path.exists()
    mended = outcome_of(data, RunContext(out=tmp_path))
    assert [f.code for f in mended.warnings] == ["workspace.part-damaged"]
    assert bits(mended)[:-1] == bits(whole)[:-1]


# What a file belongs to.


def said(folder: Path | None = None, **changes: Any) -> str:
    """What all regions of a study depend on; changes of the study, and of the file by ``_NAME``."""
    data = five_bar(**({**SMALL, **{k: v for k, v in changes.items() if k[0] != "_"}}))
    for name, value in changes.items():
        if name[0] == "_":
            data[name[1:]] = {**data.get(name[1:], {}), **value}
    document = parse_document(data)
    assert document is not None
    compiled = lw.compile(document, folder)
    options = WorkspaceOptions.model_validate(data["studies"]["workspace"])
    return common(WorkspaceOutcome(compiled, options, options.chord * compiled.graph.size, options.box(compiled)))


@pytest.mark.parametrize(
    "change",
    [
        {"point": "B"},
        {"chord": 2e-3},
        {"drives": {"motor": [80, 120], "servo": [40, 101]}},
        {"drives": {"motor": [80, 120]}},
        {"_parameters": {"l": 12.000000000000002}},
        {"_units": {"length": "cm"}},
        {"_assembly": {"C": "right of D-B"}},
        {"_links": {"left": {"points": {"A": [0, 0], "B": [11, 0]}}}},
    ],
    ids=str,
)
def test_what_changes_a_region_changes_its_key(change: dict[str, Any]) -> None:
    assert said(**change) != said()


@pytest.mark.parametrize(
    "change",
    [
        {"modes": "own"},
        {"for": {"base": [9, 10]}},
        {"quality": {"steps": 20}},
        {"fits": {"table": {"circle": 5}}},
        {"_studies": {"workspace": {"point": "C", **SMALL}, "limits": {}}},
    ],
    ids=str,
)
def test_what_only_chooses_or_uses_regions_does_not(change: dict[str, Any]) -> None:
    assert said(**change) == said()


def test_tables_are_in_the_key(tmp_path: Path) -> None:
    table = {"_tables": {"law": {"file": "law.csv", "x": "t s", "y": "h deg"}}}
    table |= {"_drives": {"motor": {"turns": "left", "on": "frame", "position": "law(t)"}}}
    keys = []
    for row in ("1,1", "1,2"):
        (tmp_path / "law.csv").write_text(f"t,h\n0,0\n{row}\n2,0\n3,0\n", "utf-8")
        keys += [said(tmp_path, **table), said(tmp_path, **table)]
    assert keys[0] == keys[1] != keys[2] == keys[3]


def test_a_changed_parameter_takes_nothing_and_a_further_value_the_rest(
    tmp_path: Path, found: list[tuple[float, ...]]
) -> None:
    outcome_of(arm(chord=1e-3, **{"for": {"b": [30, 35]}}), RunContext(out=tmp_path))
    found.clear()
    other = outcome_of(arm(a=41, chord=1e-3, **{"for": {"b": [30, 35]}}), RunContext(out=tmp_path))
    assert len(found) == 2
    assert bits(other) == bits(outcome_of(arm(a=41, chord=1e-3, **{"for": {"b": [30, 35]}}), RunContext()))
    found.clear()
    outcome_of(arm(chord=1e-3, **{"for": {"b": [20, 35, 30]}}), RunContext(out=tmp_path))
    assert len(found) == 1


# The folder.


def test_fresh_passes_over_what_is_there(tmp_path: Path, found: list[tuple[float, ...]]) -> None:
    outcome_of(arm(chord=1e-3), RunContext(out=tmp_path))
    (path,) = (tmp_path / FOLDER).iterdir()
    path.write_bytes(b"damaged")
    fresh = outcome_of(arm(chord=1e-3), RunContext(out=tmp_path, fresh=True))
    assert len(found) == 2 and not fresh.warnings


def test_the_folder_is_announced_before_it_is_made(tmp_path: Path) -> None:
    told = []

    def keep(path: Path, name: str) -> None:
        told.append((path, name, path.exists()))

    outcome_of(arm(chord=1e-3), RunContext(out=tmp_path / "new", keep=keep))
    assert told == [(tmp_path / "new" / FOLDER, "workspace", False)]


def test_a_full_disk_stops_the_study_and_what_was_kept_is_taken(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, found: list[tuple[float, ...]]
) -> None:
    data, write = arm(chord=1e-3, **{"for": {"b": VALUES}}), checkpoint.write_aside

    def full(*words: Any, **options: Any) -> None:
        if len(found) > 2:
            raise OSError(errno.ENOSPC, "No space left on device")
        write(*words, **options)

    with monkeypatch.context() as patch, pytest.raises(ModelError) as stopped:
        patch.setattr(checkpoint, "write_aside", full)
        outcome_of(data, RunContext(out=tmp_path))
    assert [f.code for f in stopped.value.findings] == ["blocks.no-space"]
    assert len([*(tmp_path / FOLDER).iterdir()]) == 2
    found.clear()
    assert outcome_of(data, RunContext(out=tmp_path)).done and len(found) == len(VALUES) - 2


def test_a_folder_that_cannot_be_made(tmp_path: Path) -> None:
    (tmp_path / FOLDER).write_text("a file", "utf-8")
    with pytest.raises(ModelError) as refused:
        outcome_of(arm(chord=1e-3), RunContext(out=tmp_path))
    assert [f.code for f in refused.value.findings] == ["blocks.unwritable"]
