"""Runs what the documentation promises: every example and model of the gallery, every snippet of README.md and docs/.

    python3 dev.py smoke [names]            only what has one of the names in its path
    python3 dev.py smoke --remake [names]   puts what the commands print now into the `console` blocks

Of a Markdown file it takes, in the order in which they stand,

- `python` blocks, executed in one namespace per file; what they print is compared with a `text` block right after;
- `sh` and `console` blocks: the lines that start with `python3 dev.py`, `linkwright` or
  `python -m linkwright` (in `console` blocks after `$ `); other lines are skipped. What a `console` block shows of
  a command's output is compared with what it prints (`transcripts.py`);
- `yaml` blocks that start with `linkwright: 1`, given to `linkwright check`.

Commands of the Chinese pages (docs/zh/ and *.zh-CN.md) speak Chinese, as on a Chinese system, all others English.
The current folder holds a copy of examples/. The comment `<!-- exit 2 -->` before a block states the exit
code expected of each of its commands. A block after `<!-- no-run -->`, or with `no-run` beside its
language, is left out.
"""

import contextlib
import io
import json
import math
import os
import re
import shlex
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import time
import traceback
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from dataclasses import asdict, dataclass, replace
from functools import partial
from itertools import pairwise
from pathlib import Path
from typing import Any

import transcripts

ROOT = Path(__file__).resolve().parents[1]
AT_ONCE = 2
TIMEOUT = 300.0  # seconds for one command, script or snippet
OURS = f'"{sys.executable}" -m linkwright'
REMAKE = "--remake"
WARM = ROOT / "examples" / "four_bar.yaml"
"""A small model, which the processes that commands fork off run first."""
TAIL = 25  # lines shown of what failed
ENGLISH, CHINESE = "en_US.UTF-8", "zh_CN.UTF-8"  # values of LANG for commands

FENCE = re.compile(r"^(?P<indent>\s*)(?P<mark>`{3,}|~{3,})\s*(?P<info>[^`]*)$")
COMMENT = re.compile(r"<!--\s*(.*?)\s*-->")
COMMANDS = ("python3 dev.py", "python dev.py", "python3 -m linkwright", "python -m linkwright", "linkwright")
NOT_HERE = {"", "test", "lint", "smoke", "all", "bench", "help", "-h"}  # dev.py's own; CI runs them


class Failure(Exception):
    """What went wrong with an item, in words."""


@dataclass(frozen=True)
class Outcome:
    """What came of one item; `verdict` is `ok`, `FAIL` or `skip`."""

    name: str
    verdict: str
    seconds: float = 0.0
    detail: str = ""


@dataclass(frozen=True)
class Block:
    """A fenced block: its language, the line number of its first line of text, the exit code expected; of a `python`
    block also what it prints by the `text` block right after it."""

    language: str
    line: int
    text: str
    exit_code: int = 0
    skip: bool = False
    prints: str = ""


Unit = tuple[Callable[[Path], list[Outcome]], Path]  # what runs a file, and the file


def blocks(markdown: str) -> Iterator[Block]:
    """The fenced blocks of a Markdown text, with the comments that stand right above each."""
    lines = markdown.splitlines()
    notes: list[str] = []
    at = 0
    while at < len(lines):
        line = lines[at]
        at += 1
        fence = FENCE.match(line)
        if fence is None:
            comments = COMMENT.findall(line)
            notes = notes + comments if comments or not line.strip() else []
            continue
        first, closing = at, re.compile(rf"\s*{fence['mark']}{fence['mark'][0]}*\s*")
        while at < len(lines) and not closing.fullmatch(lines[at]):
            at += 1
        indent = len(fence["indent"])
        body = [text[min(indent, len(text) - len(text.lstrip())) :] for text in lines[first:at]]
        at += 1
        words = fence["info"].split() or [""]
        codes = [int(note.split()[1]) for note in notes if re.fullmatch(r"exit \d+", note)]
        skip = "no-run" in words or "no-run" in notes
        yield Block(words[0], first + 1, "\n".join(body) + "\n", codes[-1] if codes else 0, skip)
        notes = []


def with_prints(found: list[Block]) -> Iterator[Block]:
    """The blocks of a page, the `python` ones with what they print by the `text` block right after them."""
    for block, following in pairwise([*found, Block("", 0, "")]):
        apart = following.line - block.line - len(block.text.splitlines())  # a fence, a blank line, a fence
        if block.language == "python" and following.language == "text" and 0 < apart <= 3:
            yield replace(block, prints=following.text)
        else:
            yield block


def command_lines(block: Block) -> Iterator[tuple[int, str]]:
    """The commands of an `sh` or `console` block with their line numbers; a backslash joins lines."""
    lines = enumerate(block.text.splitlines(), block.line)
    for number, line in lines:
        command = line.strip()
        if block.language == "console" and not command.startswith("$ "):
            continue  # what the command answers
        command = command.removeprefix("$ ")
        while command.endswith("\\"):
            command = command[:-1].rstrip() + " " + next(lines, (0, ""))[1].strip().removeprefix(">").lstrip()
        command = re.sub(r"(^|\s+)#(\s.*)?$", "", command)
        if command:
            yield number, command


def shown(block: Block, number: int) -> range:
    """The numbers of the lines in which a `console` block shows what the command of line `number` prints."""
    lines = block.text.splitlines()
    start = number - block.line + 1
    while lines[start - 1].endswith("\\"):
        start += 1
    rest = [line.startswith("$ ") for line in lines[start:]]
    end = start + (rest.index(True) if True in rest else len(rest))
    return range(block.line + start, block.line + end)


def compare(block: Block, number: int, said: str) -> None:
    """Fails if a `console` block shows what the command of line `number` doesn't print."""
    lines = block.text.splitlines()
    expected = [lines[at - block.line] for at in shown(block, number)]
    if block.language == "console" and expected and (failure := transcripts.difference(expected, said)):
        raise Failure(failure)


def translate(command: str) -> str | None:
    """The shell command that runs a documented one with this Python; None for one that isn't run here."""
    for start in COMMANDS:
        rest = command.removeprefix(start)
        if rest != command and rest[:1] in ("", " "):
            words = rest.split()
            if "dev.py" in start and (words[0] if words else "") in NOT_HERE:
                return None
            return OURS + rest
    return None


def is_model(block: Block) -> bool:
    """Whether a `yaml` block is a whole model file."""
    says = (line.split("#")[0].strip() for line in block.text.splitlines())
    return block.language == "yaml" and next(filter(None, says), "") == "linkwright: 1"


def plain(command: str | list[str]) -> list[str] | None:
    """The words of a command line of linkwright; None for another command, or one that a shell has work with."""
    if isinstance(command, str):
        if set(command.removeprefix(OURS)) & set("|&;<>()$`*?[]#~!{}\\\n"):
            return None
        command = shlex.split(command)
    start = [sys.executable, "-m", "linkwright"]
    return command[3:] if command[:3] == start else None


class Forks(threading.local):
    """A process for each thread that has imported linkwright; commands fork off it from the second one on."""

    commands = 0
    server: "subprocess.Popen[str] | None" = None

    def __call__(self, words: list[str], cwd: Path, timeout: float, language: str) -> tuple[int, str] | None:
        """Exit code and what was said; None for the first one, or where there are no forks."""
        self.commands += 1
        if self.commands == 1 or not hasattr(os, "fork"):
            return None
        if self.server is None:
            script, pipe = [str(ROOT / "tools" / "forked_commands.py"), str(WARM)], subprocess.PIPE
            environment = {**bare_environment(), "OPENBLAS_NUM_THREADS": "1"}  # its threads outlive no fork
            self.server = subprocess.Popen(
                [sys.executable, *script], env=environment, stdin=pipe, stdout=pipe, text=True
            )
        assert self.server.stdin is not None
        assert self.server.stdout is not None
        asked = {"folder": str(cwd), "path": [], "words": words, "seconds": timeout}
        asked |= {"environment": {"LANG": language}, "merged": True}
        self.server.stdin.write(json.dumps(asked) + "\n")
        self.server.stdin.flush()
        code, said, _ = json.loads(self.server.stdout.readline())
        if code == -signal.SIGALRM:
            raise Failure(f"not done after {timeout:.0f} s\n{said}")
        return code, said


forked = Forks()


def bare_environment() -> dict[str, str]:
    """The environment without the size of a terminal and without a language; text is UTF-8."""
    left = {"COLUMNS", "LINES", "LC_ALL", "LC_MESSAGES"}
    kept = {name: value for name, value in os.environ.items() if name not in left}
    return {**kept, "PYTHONUTF8": "1"}


def call(
    command: str | list[str], cwd: Path, exit_code: int = 0, timeout: float = TIMEOUT, language: str = ENGLISH
) -> str:
    """What a command prints; fails unless it ends with the exit code expected."""
    words = plain(command)
    code, said = (words is not None and forked(words, cwd, timeout, language)) or alone(command, cwd, timeout, language)
    if "Traceback (most recent call last)" in said:
        raise Failure(f"a traceback\n{said}")
    if code != exit_code:
        raise Failure(f"exit code {code}, expected {exit_code}\n{said}")
    return said


def alone(command: str | list[str], cwd: Path, timeout: float, language: str) -> tuple[int, str]:
    """A command in a process of its own: exit code and what it said."""
    try:
        done = subprocess.run(
            command,
            cwd=cwd,
            env={**bare_environment(), "LANG": language},
            shell=isinstance(command, str),
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            encoding="utf-8",
            errors="replace",
            timeout=timeout,
        )
    except subprocess.TimeoutExpired as error:
        said = error.stdout or b""
        text = said.decode(errors="replace") if isinstance(said, bytes) else said
        raise Failure(f"not done after {timeout:.0f} s\n{text}") from None
    return done.returncode, done.stdout


def timed(name: str, item: Callable[[], None]) -> Outcome:
    """Runs an item and says what came of it."""
    start = time.perf_counter()
    verdict, detail = "ok", ""
    try:
        item()
    except Failure as failure:
        verdict, detail = "FAIL", str(failure)
    except Exception:
        verdict, detail = "FAIL", traceback.format_exc()
    return Outcome(name, verdict, time.perf_counter() - start, detail)


@contextlib.contextmanager
def workplace() -> Iterator[Path]:
    """A temporary folder with a copy of examples/ in it."""
    with tempfile.TemporaryDirectory(prefix="linkwright-smoke-", ignore_cleanup_errors=True) as folder:
        place = Path(folder).resolve()
        if (ROOT / "examples").is_dir():
            leave = shutil.ignore_patterns("*_linkwright", "__pycache__")
            shutil.copytree(ROOT / "examples", place / "examples", ignore=leave)
        yield place


def not_a_number(value: Any, at: str = "summary") -> Iterator[str]:
    """The places in a parsed JSON document that hold a number which isn't one."""
    if isinstance(value, dict):
        for key, item in value.items():
            yield from not_a_number(item, f"{at}.{key}")
    elif isinstance(value, list):
        for index, item in enumerate(value):
            yield from not_a_number(item, f"{at}[{index}]")
    elif isinstance(value, float) and not math.isfinite(value):
        yield f"{at} is {value}"


def check_results(out: Path) -> None:
    """Fails unless a run has left its report, its table and a summary of sound numbers."""
    table = "reactions.csv" if (out / "reactions.csv").is_file() else "cycle.csv"  # what nothing drives has no cycle
    for name in ("report.html", "summary.json", table):
        if not (out / name).is_file() or not (out / name).stat().st_size:
            raise Failure(f"{name} is missing or empty")
    if bad := list(not_a_number(json.loads((out / "summary.json").read_text(encoding="utf-8")))):
        raise Failure("summary.json: " + ", ".join(bad))


def smoke_model(path: Path) -> list[Outcome]:
    """Runs one model of examples/."""

    def item() -> None:
        with workplace() as place:
            model = place / path.relative_to(ROOT)
            call([sys.executable, "-m", "linkwright", "run", str(model), "--out", str(place / "out")], place)
            check_results(place / "out")

    return [timed(path.relative_to(ROOT).as_posix(), item)]


def has_source(path: Path) -> bool:
    """Whether a model names its source: the founding cases, which wheel_cases.py runs from an installed wheel."""
    return "\nsource:" in path.read_text(encoding="utf-8")


def smoke_gallery(path: Path) -> list[Outcome]:
    """Takes one model out of the gallery and runs it; nothing is found in it, its certificate is sound."""

    def item() -> None:
        with workplace() as place:
            call([sys.executable, "-m", "linkwright", "new", path.stem], place)
            call([sys.executable, "-m", "linkwright", "run", f"{path.stem}.yaml", "--out", "out"], place)
            check_results(place / "out")
            summary = json.loads((place / "out" / "summary.json").read_text(encoding="utf-8"))
            if summary["findings"]:
                raise Failure(f"findings: {summary['findings']}")
            certificate = summary["certificate"]
            if max(certificate[proof] or 0.0 for proof in ("closure", "equilibrium", "power", "work")) > 1e-9:
                raise Failure(f"the certificate isn't sound: {certificate}")

    return [timed(path.relative_to(ROOT).as_posix(), item)]


def smoke_script(path: Path) -> list[Outcome]:
    """Runs one Python script of examples/."""

    def item() -> None:
        with workplace() as place:
            call([sys.executable, str(place / path.relative_to(ROOT))], place)

    return [timed(path.relative_to(ROOT).as_posix(), item)]


def smoke_document(path: Path) -> list[Outcome]:
    """Runs the blocks of one Markdown file."""
    with workplace() as place, Snippets(path, place) as snippets:
        return list(run_document(path.relative_to(ROOT).as_posix(), path, place, snippets))


def remake_document(path: Path) -> list[Outcome]:
    """Runs the blocks of one Markdown file, and puts what the commands print into its `console` blocks."""
    printed: dict[int, tuple[Block, str]] = {}
    with workplace() as place, Snippets(path, place) as snippets:
        name = path.relative_to(ROOT).as_posix()
        outcomes = list(run_document(name, path, place, snippets, printed))
    lines = path.read_text(encoding="utf-8").splitlines()
    for number, (block, said) in sorted(printed.items(), reverse=True):
        where = shown(block, number)
        old = lines[where.start - 1 : where.stop - 1]
        if block.language == "console" and any(old) and transcripts.difference(old, said):
            indent = len(lines[number - 1]) - len(block.text.splitlines()[number - block.line])
            new = [(" " * indent + line).rstrip() for line in transcripts.remade(old, said)]
            lines[where.start - 1 : where.stop - 1] = new
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")
    return outcomes


class Snippets:
    """A process for the `python` blocks of one Markdown file, so that a snippet can't harm the rest; it starts with the
    first of them, with nothing imported."""

    def __init__(self, path: Path, place: Path) -> None:
        self.path, self.place = path, place
        self.process: subprocess.Popen[str] | None = None

    def __enter__(self) -> "Snippets":
        return self

    def __exit__(self, *_: object) -> None:
        if self.process is not None:
            self.process.communicate()

    def __call__(self, block: Block) -> None:
        """Executes a block; fails as it does."""
        if self.process is None:
            command = [sys.executable, str(Path(__file__).resolve()), "--snippets", str(self.path)]
            pipe = subprocess.PIPE
            self.process = subprocess.Popen(command, cwd=self.place, stdin=pipe, stdout=pipe, encoding="utf-8")
        assert self.process.stdin is not None
        assert self.process.stdout is not None
        late = threading.Timer(TIMEOUT, self.process.kill)
        late.start()
        try:
            with contextlib.suppress(BrokenPipeError):
                self.process.stdin.write(json.dumps(asdict(block)) + "\n")
                self.process.stdin.flush()
            told = self.process.stdout.readline()
        finally:
            late.cancel()
        if not told:
            raise Failure(f"the process of the snippets ended with {self.process.wait()}, or took over {TIMEOUT:.0f} s")
        if failure := json.loads(told):
            raise Failure(failure)


def snippets_main(path: Path) -> int:
    """The process of one file's snippets: blocks come as lines of JSON; what failed leaves, or an empty text."""
    sys.path[0] = str(Path.cwd())  # as for a script that stands beside README.md
    namespace: dict[str, Any] = {"__name__": "__main__"}
    asked, told = os.fdopen(os.dup(0), encoding="utf-8"), os.fdopen(os.dup(1), "w", encoding="utf-8")
    os.dup2(os.open(os.devnull, os.O_RDONLY), 0)  # the streams are no snippet's
    os.dup2(2, 1)
    for line in asked:
        failure = timed("", partial(run_python, Block(**json.loads(line)), path, namespace)).detail
        print(json.dumps(failure), file=told, flush=True)
    return 0


def language_of(name: str) -> str:
    """The locale of the commands of a page."""
    return CHINESE if name.startswith("docs/zh/") or name.endswith(".zh-CN.md") else ENGLISH


def run_document(
    name: str,
    path: Path,
    place: Path,
    snippets: Callable[[Block], None],
    printed: dict[int, tuple[Block, str]] | None = None,
) -> Iterator[Outcome]:
    """Runs the blocks of one Markdown file in a folder, in order; what commands print is kept by the number of their
    lines in `printed`, or else compared with what the page shows."""
    language = language_of(name)
    for block in with_prints(list(blocks(path.read_text(encoding="utf-8")))):
        label = f"{name}:{block.line}"
        if block.skip:
            yield Outcome(f"{label} {block.language}", "skip")
        elif block.language == "python":
            yield timed(f"{label} python", partial(snippets, block))
        elif block.language in ("sh", "console"):
            for number, command in command_lines(block):
                translated = translate(command)
                if translated is None:
                    yield Outcome(f"{name}:{number} {command}", "skip")
                    continue

                def item(block: Block = block, number: int = number, translated: str = translated) -> None:
                    said = call(translated, place, block.exit_code, language=language)
                    if printed is None:
                        compare(block, number, said)
                    else:
                        printed[number] = block, said

                yield timed(f"{name}:{number} {command}", item)
        elif is_model(block):
            model = place / f"{path.stem}_line_{block.line}.yaml"
            model.write_text(block.text, encoding="utf-8")
            check = [sys.executable, "-m", "linkwright", "check", str(model)]

            def checked(block: Block = block, check: list[str] = check) -> None:
                call(check, place, block.exit_code)

            yield timed(f"{label} yaml", checked)


def run_python(block: Block, path: Path, namespace: dict[str, Any]) -> None:
    """Executes a `python` block; a traceback names the lines of the Markdown file."""
    said = io.StringIO()
    exit_code: object = 0
    try:
        with contextlib.redirect_stdout(said), contextlib.redirect_stderr(said):
            exec(compile("\n" * (block.line - 1) + block.text, str(path), "exec"), namespace)
    except SystemExit as left:
        exit_code = left.code or 0
    except Exception:
        raise Failure(said.getvalue() + traceback.format_exc()) from None
    if exit_code != block.exit_code:
        raise Failure(f"{said.getvalue()}exit code {exit_code}, expected {block.exit_code}")
    if block.prints and (failure := transcripts.difference(block.prints.splitlines(), said.getvalue())):
        raise Failure(failure)


def units(names: list[str]) -> list[Unit]:
    """What there is to run: a function and the file for it, those with one of the names in their path."""
    found: list[Unit] = [
        *((smoke_model, path) for path in sorted(ROOT.glob("examples/*.yaml"))),
        *((smoke_gallery, path) for path in sorted(ROOT.glob("src/linkwright/gallery/*.yaml")) if not has_source(path)),
        *((smoke_script, path) for path in sorted(ROOT.glob("examples/*.py"))),
        *((smoke_document, path) for path in [*sorted(ROOT.glob("README*.md")), *sorted(ROOT.glob("docs/**/*.md"))]),
    ]
    if not names:
        return found
    return [unit for unit in found if any(name in unit[1].relative_to(ROOT).as_posix() for name in names)]


def show(outcome: Outcome) -> None:
    print(f"{outcome.verdict:4} {outcome.seconds:6.1f} s  {outcome.name}", flush=True)
    if outcome.verdict == "FAIL":
        for line in outcome.detail.rstrip().splitlines()[-TAIL:]:
            print(f"      {line}", flush=True)


def main(names: list[str]) -> int:
    passed = failed = 0
    chosen = units([name for name in names if name != REMAKE])
    if REMAKE in names:
        chosen = [(remake_document, path) for function, path in chosen if function is smoke_document]
    with ThreadPoolExecutor(AT_ONCE) as pool:  # each thread waits for a process
        for outcomes in pool.map(lambda unit: unit[0](unit[1]), chosen):
            for outcome in outcomes:
                show(outcome)
                passed += outcome.verdict == "ok"
                failed += outcome.verdict == "FAIL"
    if not passed + failed:
        print("nothing to run: no examples and no snippets found")
    print(f"{passed} passed, {failed} failed")
    return 0 if passed and not failed else 1


if __name__ == "__main__":
    os.environ.setdefault("MPLBACKEND", "Agg")
    if sys.argv[1:2] == ["--snippets"]:
        sys.exit(snippets_main(Path(sys.argv[2])))
    sys.exit(main(sys.argv[1:]))
