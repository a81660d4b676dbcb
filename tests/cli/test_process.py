"""The command line as processes of its own: start-up, streams, signals. Where neither matters, one forks off a process
that has started."""

from __future__ import annotations

import importlib.util
import json
import os
import re
import signal
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

import pytest

from app.models import NAMES, SOUND, STUCK
from helpers.longer import mostly_long
from helpers.outside import linkwright
from linkwright.app.results_folder import LOCK
from linkwright.words import say

FILES = ["cycle.csv", "linkwright-manifest.json", "report.html", "summary.json"]
EXAMPLES = Path(__file__).parents[2] / "examples"
PROGRAM = [sys.executable, "-m", "linkwright"]


def run(*words: Any, **options: Any) -> subprocess.CompletedProcess[str]:
    options.setdefault("encoding", "utf-8")
    return subprocess.run([*PROGRAM, *map(str, words)], capture_output=True, timeout=60, check=False, **options)


@pytest.fixture
def model(tmp_path: Path) -> Path:
    path = tmp_path / "model.yaml"
    path.write_text(SOUND, "utf-8")
    return path


@pytest.mark.parametrize("words", [["--help"], ["--version"], ["run", "--help"]], ids=" ".join)
def test_help_waits_for_no_slow_import(words: list[str]) -> None:
    """Help answers at once, because nothing that computes is loaded for it."""
    code = f"""\
import sys
sys.argv = ["linkwright", *{words!r}]
from linkwright.cli import main
try:
    main()
except SystemExit:
    pass
slow = ("numpy", "scipy", "pint", "pydantic", "ruamel", "rich", "xarray", "matplotlib", "linkwright.model")
print([name for name in slow if name in sys.modules], file=sys.stderr)
"""
    result = subprocess.run([sys.executable, "-c", code], capture_output=True, encoding="utf-8", timeout=60, check=True)
    assert result.stderr.splitlines()[-1] == "[]"


NOT_NEEDED = {
    "elements": "belt counterweight coupling differential friction gears geneva load path rack rolling spring weld",
    "elements.cam_contact": "contact entry entry_reader faults follower proof second",
    "reductions": "dwell efficiency mean straightness",
    "blocks": "cluster histogram kurtosis loop moments moments_code reductions runners sinks",
    "kernels": "llvm_kernel llvm_code llvm_source machine_code threaded still",
    "graph": "circuits constraints legs modes mode_survey redundant search standing statics still triads",
    "studies": "accuracy cam limits.study limits.extremes modes reactions sweep workspace",
    "app": "assembly_modes bench exports single_study",
    "expressions": "respelled respelled_units synonyms chinese_units",
    "model": "respelled_lines subassembly",
    "words.en": "schema findings.cams findings.elements cams accuracy sweep workspace",
    "words.zh": "schema findings.cams findings.elements cams accuracy sweep workspace",
    "": "cam",
}
"""What a run of a mechanism of pins and slides without loads and springs has no use for, by package."""


def test_a_run_imports_what_its_file_needs(tmp_path: Path) -> None:
    """Importing all that there is would double the time of a run."""
    code = """\
import sys
sys.argv = ["linkwright", "run", sys.argv[1], "--out", sys.argv[2]]
from linkwright.cli import main
try:
    main()
except SystemExit:
    pass
print(*sys.modules, file=sys.stderr)
"""
    command = [sys.executable, "-c", code, str(EXAMPLES / "paper_feeder.yaml"), str(tmp_path / "out")]
    result = subprocess.run(command, capture_output=True, encoding="utf-8", timeout=120, check=True)
    imported = {*result.stderr.split()}
    assert {"linkwright.elements.slide", "linkwright.studies.cycle.study"} <= imported
    listed = [
        f"linkwright.{of}.{name}".replace("..", ".") for of, names in NOT_NEEDED.items() for name in names.split()
    ]
    assert [name for name in listed if importlib.util.find_spec(name) is None] == []
    assert {*listed, "scipy", "pint", "xarray", "llvmlite", "concurrent.futures"} & imported == set()


# Nothing that a name holds reaches the terminal as anything but letters.

ODD = "\x1b[31mred\x07\nerror: \u202e\x9b1m"
UNSEEN = re.compile(r"[\x00-\x09\x0b-\x1f\x7f-\x9f\u2028\u2029\u202a-\u202e\u2066-\u2069]")


ASKED = {
    "command": [ODD],
    "file": ["check", ODD],
    "option": ["check", f"--{ODD}"],
    "number": ["bench", "x", "--poses", ODD],
    "gallery": ["new", ODD],
    "target": ["export", "{}", "--to", ODD],
    "setting": ["export", "{}", "--to", "mjcf", "--set", ODD],
    "folder": ["run", "{}", "--out", ODD],
    "cluster": ["sweep", "{}", "--cluster", ODD],
}


@pytest.mark.parametrize("words", ASKED.values(), ids=ASKED)
def test_arguments_are_quoted_as_letters(words: list[str], model: Path, tmp_path: Path) -> None:
    result = linkwright(tmp_path, *(word.format(model) for word in words))
    assert result.returncode in (0, 2)
    assert not UNSEEN.search(result.stdout + result.stderr)
    assert "\nerror: " not in result.stdout + result.stderr


@pytest.mark.skipif(os.name == "nt", reason="such names can't be")
@pytest.mark.parametrize("name", [f"{ODD}.yaml".encode(), b"a\xff.yaml"])
def test_files_of_any_name(name: bytes, model: Path, tmp_path: Path) -> None:
    path = os.fsdecode(os.path.join(os.fsencode(tmp_path), name))  # noqa: PTH118
    Path(path).write_text(SOUND, "utf-8")
    result = run("run", path, "--csv-comments", cwd=tmp_path)
    assert result.returncode == 0
    assert not UNSEEN.search(result.stdout + result.stderr)
    folder = Path(path).with_name(f"{Path(path).stem}_linkwright")
    assert sorted(file.name for file in folder.iterdir()) == FILES
    for file in folder.iterdir():
        assert not UNSEEN.search(file.read_text("utf-8").split("<style>")[0].replace("\t", ""))


def test_importing_the_package_loads_nothing_slow() -> None:
    slow = ("numpy", "scipy", "pint", "pydantic")
    code = f"import sys, linkwright; print([name for name in {slow} if name in sys.modules])"
    assert subprocess.check_output([sys.executable, "-c", code], encoding="utf-8").strip() == "[]"


def test_a_whole_run(model: Path, tmp_path: Path) -> None:
    result = run("run", model, "--out", tmp_path / "out", cwd=tmp_path)
    assert result.returncode == 0
    assert result.stderr == ""
    assert "swing" in result.stdout
    assert sorted(p.name for p in (tmp_path / "out").iterdir()) == FILES


def test_a_relative_path_without_a_folder(model: Path, tmp_path: Path) -> None:
    assert run("run", model.name, cwd=tmp_path).returncode == 0
    assert (tmp_path / "model_linkwright" / "summary.json").exists()


def test_json_alone_on_stdout(model: Path, tmp_path: Path) -> None:
    for text, code in ((SOUND, 0), (STUCK, 1), (NAMES, 2)):
        model.write_text(text, "utf-8")
        result = linkwright(tmp_path, "run", str(model), "--json")
        assert result.returncode == code
        assert json.loads(result.stdout)["done"] is (code == 0)
        assert "Traceback" not in result.stderr


def test_faults_on_stderr_with_lines(model: Path, tmp_path: Path) -> None:
    model.write_text(NAMES, "utf-8")
    result = linkwright(tmp_path, "check", str(model))
    assert result.returncode == 2
    assert result.stdout == ""
    assert f"{model}:13: " in result.stderr
    assert "Traceback" not in result.stderr


def test_no_colours_or_wrapped_lines_in_a_pipe(model: Path) -> None:
    model.write_text(NAMES, "utf-8")
    result = run("check", model, env={**os.environ, "COLUMNS": "40", "TERM": "xterm-256color"})
    assert "\x1b" not in result.stderr
    assert any(len(line) > 60 for line in result.stderr.splitlines())


@pytest.mark.parametrize("encoding", ["ascii", "cp1252", pytest.param("gbk", marks=pytest.mark.long)])
def test_a_terminal_that_knows_few_letters(model: Path, encoding: str) -> None:
    """A tick it can't show is no reason to fail."""
    model.write_text(SOUND.replace("name: Four-bar", "name: Four-bar 四连杆 ä ✓"), "utf-8")
    environment = {**os.environ, "PYTHONIOENCODING": encoding, "PYTHONUTF8": "0"}
    told, summary = (
        run(*words, env=environment, encoding=encoding) for words in (("run", model), ("run", model, "--json"))
    )
    for result in (told, summary):
        assert result.returncode == 0, result.stderr
        assert "Traceback" not in result.stderr
    assert "swing" in told.stdout
    assert json.loads(summary.stdout)["done"] is True


CHINESE = """\
linkwright: 1
name: 曲柄滑块机构 ä µ ② ✓ 龘
units: {length: mm, angle: deg, time: s}
links:
  frame: {points: {A: [0, 0]}}
  曲柄: {points: {A: [0, 0], B: [50, 0]}}
  连杆: {points: {B: [0, 0], C: [160, 0]}}
  滑块: {points: {C: [0, 0]}}
joints:
  导轨: {prismatic: [frame, 滑块], line: [A at 0 deg, C at 0 deg]}
assembly: {C: ahead of B along 导轨}
drives:
  电机: {turns: 曲柄, on: frame, speed: 60 rpm, start: 0 deg}
measures:
  行程: {span: 导轨.s}
studies:
  cycle: {turns: 1 电机, samples: 12}
"""
ASKED_IN_CHINESE = [
    (["run", "{}"], 0), (["run", "{}", "--json"], 0), (["check", "错.yaml"], 2), (["运行", "{}"], 2),
    (["run", "{}", "--打开"], 2), (["check", "无此文件 ✓.yaml"], 2), (["modes", "{}"], 0), (["schema"], 0),
]  # fmt: skip


@pytest.mark.parametrize(
    ("encoding", "language", "most"),
    [("gbk", "zh", 8), pytest.param("cp936", "en", 3, marks=pytest.mark.long), ("cp1252", "zh", 4)],
)
def test_consoles_of_chinese_and_western_systems(encoding: str, language: str, most: int, tmp_path: Path) -> None:
    """Letters that one lacks are replaced; nothing fails, and JSON is whole."""
    (model := tmp_path / "曲柄滑块.yaml").write_text(CHINESE, "utf-8")
    (tmp_path / "错.yaml").write_text(CHINESE.replace("speed: 60 rpm", "speed：60转／分"), "utf-8")
    environment = {**os.environ, "PYTHONIOENCODING": encoding, "PYTHONUTF8": "0", "LANG": "zh_CN.GBK"}
    for words, code in ASKED_IN_CHINESE[:most]:
        asked = [word.format(model.name) for word in words]
        result = run(*asked, "--lang", language, cwd=tmp_path, env=environment, encoding=encoding)
        assert result.returncode == code, (asked, result.stderr)
        assert "Traceback" not in result.stderr
        if "--json" in asked or "schema" in asked:
            json.loads(result.stdout)
        elif asked[0] == "run" and code == 0:
            assert (encoding == "cp1252") or "行程" in result.stdout


@pytest.mark.parametrize(
    "name", mostly_long(["zh_CN.GBK", "zh_CN.GB18030", "zh_CN.UTF-8", "zh_TW.Big5"], lambda name: "GB1" not in name)
)
def test_the_language_of_a_chinese_system(name: str, model: Path) -> None:
    environment = {**os.environ, "LANG": name, "LC_ALL": name, "PYTHONIOENCODING": "utf-8", "PYTHONUTF8": "0"}
    result = run("check", model, env=environment)
    assert result.returncode == 0 and "自由度" in result.stdout


@pytest.mark.skipif(os.name == "nt", reason="a closed pipe is another thing on Windows")
@pytest.mark.parametrize(
    ("text", "words", "code"),
    [
        (SOUND, ["run"], 0), (SOUND, ["check"], 0), (STUCK, ["run"], 1), (NAMES, ["check", "--json"], 2),
        (SOUND, ["schema"], 0), (SOUND, ["--help"], 0),
        *(pytest.param(SOUND, words, 0, marks=pytest.mark.long)
          for words in (["run", "--json"], ["limits", "--json"], ["new", "--list"])),
    ],
)  # fmt: skip
def test_a_reader_that_leaves_early(model: Path, text: str, words: list[str], code: int) -> None:
    """The exit code is that of what was asked, and there is no complaint."""
    model.write_text(text, "utf-8")
    given = [] if words[0] in ("schema", "new", "--help") else [str(model)]
    with subprocess.Popen([*PROGRAM, *words, *given], stdout=subprocess.PIPE, stderr=subprocess.PIPE) as process:
        assert process.stdout is not None
        assert process.stderr is not None
        process.stdout.close()
        complaint = process.stderr.read()
        process.wait(60)
    assert b"Traceback" not in complaint
    assert b"Broken" not in complaint
    assert process.returncode == code


def through_a_shell(redirected: str, *words: Any) -> subprocess.CompletedProcess[str]:
    command = ["sh", "-c", f'exec "$@" {redirected}', "sh", *PROGRAM, *map(str, words)]
    return subprocess.run(command, capture_output=True, encoding="utf-8", timeout=60, check=False)


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="there is no device that is full")
@pytest.mark.parametrize("words", [["--help"], ["run", "--json"], ["run"]], ids=" ".join)
def test_standard_output_on_a_full_disk(model: Path, words: list[str]) -> None:
    """The results are written; that they can't be told is one line and an exit code of its own."""
    result = through_a_shell("> /dev/full", *words, *([model] if words != ["--help"] else []))
    assert result.returncode == 2
    assert result.stderr.splitlines() == ["Stopped: standard output can't be written: No space left on device."]
    if words != ["--help"]:
        assert sorted(p.name for p in (model.parent / "model_linkwright").iterdir()) == FILES


@pytest.mark.skipif(os.name == "nt", reason="shells are POSIX's")
@pytest.mark.parametrize(
    ("text", "code", "closed"),
    [
        (SOUND, 0, ">&-"), (SOUND, 0, "<&- >&- 2>&-"), (NAMES, 2, "2>&-"), (NAMES, 2, "<&- >&- 2>&-"),
        pytest.param(SOUND, 0, "2>&-", marks=pytest.mark.long), pytest.param(NAMES, 2, ">&-", marks=pytest.mark.long),
    ],
)  # fmt: skip
def test_closed_streams(model: Path, text: str, code: int, closed: str) -> None:
    """No file that is written gets the number of a closed stream, and so what is printed."""
    model.write_text(text, "utf-8")
    result = through_a_shell(closed, "run", model, "--json")
    assert (result.returncode, "Traceback" in result.stderr) == (code, False)
    if code == 0:
        assert json.loads((model.parent / "model_linkwright" / "summary.json").read_text("utf-8"))["done"] is True


AT_AN_IMPORT = """\
import os, signal, sys
from linkwright.__main__ import main
class Interrupting:
    def find_spec(self, name, path=None, target=None):
        if name == AT:
            sys.meta_path.remove(self)
            os.kill(os.getpid(), signal.SIGINT)
sys.meta_path.insert(0, Interrupting())
main()
"""


@pytest.mark.skipif(os.name == "nt", reason="signals are POSIX's")
@pytest.mark.parametrize(
    "name",
    [
        "linkwright.cli",
        pytest.param("click", marks=pytest.mark.long),
        "numpy._core._multiarray_umath",
        pytest.param("pydantic_core._pydantic_core", marks=pytest.mark.long),
    ],
)
def test_an_interrupt_within_an_import(model: Path, name: str) -> None:
    """Of one's own, of what compiled modules import for themselves: never another error, never lost."""
    command = [sys.executable, "-c", AT_AN_IMPORT.replace("AT:", f"{name!r}:"), "run", str(model)]
    result = subprocess.run(command, capture_output=True, encoding="utf-8", timeout=60, check=False)
    assert (result.returncode, result.stdout) == (130, "")
    assert result.stderr.splitlines() == [say("cli.interrupted")]


INTERRUPTED = """\
import os, signal, sys
from pathlib import Path
from linkwright.__main__ import main
replace = Path.replace
def stopped(self, target):
    if Path(target).name == STOP_AT:
        os.kill(os.getpid(), signal.SIGINT)
    return replace(self, target)
Path.replace = stopped
class Ready:
    # Says that the program has begun: what comes before isn't its own.
    def find_spec(self, name, path=None, target=None):
        if name == "linkwright.cli":
            print("ready", flush=True)
sys.meta_path.insert(0, Ready())
main()
"""


@pytest.mark.skipif(os.name == "nt", reason="signals are POSIX's")
@pytest.mark.parametrize("delay", mostly_long([0.0, 0.1, 0.5, 1.5], lambda delay: delay != 0.1))
def test_an_interrupt_leaves_nothing_half_written(tmp_path: Path, delay: float) -> None:
    """Whatever it is at: no traceback, and files in the folder are whole or not there."""
    path, out = tmp_path / "long.yaml", tmp_path / "out"
    text = SOUND.replace("samples: 24", "samples: 60000").replace("turns: 1 motor", "turns: 50 motor")
    path.write_text(text, "utf-8")
    command = [sys.executable, "-c", INTERRUPTED.replace("STOP_AT", "None"), "run", str(path), "--out", str(out)]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE) as process:
        assert process.stdout is not None
        process.stdout.readline()
        time.sleep(delay)
        process.send_signal(signal.SIGINT)
        _, complaint = process.communicate(timeout=60)
    # Once all is done the process dies of the signal itself.
    assert process.returncode in (0, 130, -signal.SIGINT), complaint
    assert b"Traceback" not in complaint
    found = sorted(p.name for p in out.iterdir()) if out.exists() else []
    assert set(found) <= {*FILES, LOCK}  # a lock that is left belongs to nobody: the next run takes it over
    if "summary.json" in found:
        json.loads((out / "summary.json").read_text("utf-8"))
    if "report.html" in found:
        assert (out / "report.html").read_text("utf-8").rstrip().endswith("</html>")
    if "cycle.csv" in found:
        assert (out / "cycle.csv").read_text("utf-8").count("\n") == 60002


@pytest.mark.skipif(os.name == "nt", reason="signals are POSIX's")
@pytest.mark.parametrize("at", [pytest.param("cycle.csv", marks=pytest.mark.long), "report.html", "summary.json"])
def test_an_interrupt_while_writing(model: Path, tmp_path: Path, at: str) -> None:
    """The signal comes when a file is written aside but not yet in its place; what is then said is true."""
    out = tmp_path / "out"
    command = [sys.executable, "-c", INTERRUPTED.replace("STOP_AT", repr(at)), "run", str(model), "--out", str(out)]
    result = subprocess.run(command, capture_output=True, encoding="utf-8", timeout=60, check=False)
    assert result.returncode == 130
    assert "Traceback" not in result.stderr
    assert "nterrupted" in result.stderr
    found = {p.name for p in out.iterdir()} if out.exists() else set()
    assert found <= {*FILES} - {at}
    assert not found or "nothing was written" not in result.stderr


AT_HOME_NOWHERE = """\
import pwd, sys, tempfile
from linkwright.__main__ import main
def unusable(*given):
    raise FileNotFoundError(2, "No usable temporary directory found")
def unknown(number):
    raise KeyError(number)
tempfile._get_default_tempdir, pwd.getpwuid = unusable, unknown
main()
"""


@pytest.mark.skipif(os.name == "nt", reason="users are POSIX's")
@pytest.mark.parametrize(
    ("words", "code"),
    [
        (["sweep", "four_bar_sweep.yaml", "--kernel", "llvm"], ""),
        (["sweep", "slider_crank_gas.yaml"], "file.no-temporary"),
        (["bench", "four_bar.yaml", "--poses", "10"], ""),
        (["cam", "groove_cam.yaml"], "file.package-fails"),
    ],
    ids=lambda given: given if isinstance(given, str) else given[0],
)  # fmt: skip
def test_neither_a_home_nor_a_temporary_folder(tmp_path: Path, words: list[str], code: str) -> None:
    """A user whom the system doesn't know: what needs no such folder is done, the rest says what is missing."""
    needs = {"--kernel": "llvmlite", "cam": "build123d"}
    for word in words:
        pytest.importorskip(needs.get(word, "linkwright"))
    for path in (Path(__file__).parents[2] / "examples").glob("*.[yc][as][mv]*"):
        (tmp_path / path.name).write_bytes(path.read_bytes())
    with (tmp_path / "slider_crank_gas.yaml").open("a") as stream:
        stream.write("  sweep: {vary: {r: {uniform: [44, 46]}}, outputs: [C.x], samples: 4}\n")
    unset = ("HOME", "XDG_CACHE_HOME")
    environment = {name: value for name, value in os.environ.items() if name not in unset}
    command = [sys.executable, "-c", AT_HOME_NOWHERE, *words]
    told = subprocess.run(command, cwd=tmp_path, env=environment, capture_output=True, encoding="utf-8", timeout=120)
    assert (told.returncode, "Traceback" in told.stderr) == (2 if code else 0, False), told.stderr
    assert code in told.stderr
