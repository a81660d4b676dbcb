"""docs/architecture.md says what there is: files, floors, contracts with their members, registries, recipes."""

from __future__ import annotations

import ast
import importlib
import inspect
import re
from collections import Counter
from functools import cache
from pathlib import Path
from types import ModuleType
from typing import Any

import pytest

from linkwright.compilation import pipeline, stages
from test_public import LEVELS, SOURCE, packages

ROOT = Path(__file__).parents[1]
PAGE = (ROOT / "docs" / "architecture.md").read_text(encoding="utf-8")
CHAPTERS = dict(re.findall(r"^## (.+?)\n(.*?)(?=^## |\Z)", PAGE, re.M | re.S))
CONTRACTS, RECIPES = (
    dict(re.findall(r"^### (.+?)\n(.*?)(?=^### |\Z)", CHAPTERS[chapter], re.M | re.S))
    for chapter in ("Contracts", "To add")
)
CODE = re.compile(r"`([^`]+)`")
FLOORS = re.findall(r"^\| *([-\d.]*) *\| `([\w/]+)` \| (.*) \|$", CHAPTERS["Floors"], re.M)
"""The rows of the table: floor, package, what it is for."""


def quoted(text: str) -> list[str]:
    """What stands in backticks."""
    return [" ".join(one.split()) for one in CODE.findall(text)]


def is_path(text: str) -> bool:
    return re.fullmatch(r"[\w./-]+(/|\.(py|md|yaml|json|js|csv|toml))", text) is not None or (
        re.fullmatch(r"[\w-]+(/[\w-]+)+", text) is not None
    )


def found(path: str, *bases: Path) -> Path | None:
    """Where a path of the page leads."""
    return next((base / path for base in bases if (base / path).exists()), None)


def module(path: str) -> ModuleType:
    return importlib.import_module("linkwright." + path.removesuffix(".py").replace("/", "."))


# Files.


def test_code_that_other_pages_name_is_there() -> None:
    pages = {path: path.read_text("utf-8") for path in (ROOT / "docs").rglob("*.md")}
    named = {(page.name, path) for page, text in pages.items() for path in re.findall(r"`(\w+(?:/\w+)+\.py)`", text)}
    assert len(named) > 30
    assert [one for one in sorted(named) if found(one[1], SOURCE, ROOT, ROOT / "tests") is None] == []


def test_every_file_and_folder_is_there() -> None:
    text = re.sub(r"^\|.*$", "", PAGE, flags=re.M)
    paths = {path for path in quoted(re.sub(r"^```.*?^```$", "", text, flags=re.M | re.S)) if is_path(path)}
    rows = CHAPTERS["How the house is kept"]
    paths |= {path for path in quoted(rows) if is_path(path)}
    assert len(paths) > 150
    assert {path for path in paths if found(path, SOURCE, ROOT) is None} == set()


def test_links_lead_to_pages() -> None:
    targets = re.findall(r"\]\(([\w./-]+)\)", PAGE)
    assert targets
    assert [target for target in targets if not (ROOT / "docs" / target).is_file()] == []


def test_lines_are_short_outside_of_tables() -> None:
    assert [line for line in PAGE.splitlines() if len(line) > 125 and not line.startswith("|")] == []


# The way and the floors.


def test_the_picture_has_the_stages_in_their_order() -> None:
    told = re.findall(r"^    (\w+) {2,}", pipeline.__doc__ or "", re.M)
    shown = re.findall(r"^ {6}(\w+) {2,}", CHAPTERS["One way through the house"], re.M)
    assert shown == told
    assert all(callable(getattr(stages, stage)) for stage in shown)


def test_the_picture_names_floors() -> None:
    picture = CHAPTERS["One way through the house"].split("```")[1]
    named = {name for line in picture.splitlines() for name in re.split(r", *", re.split(r" {4,}", line.rstrip())[-1])}
    assert {"model", "structure", "graph", "kernels", "results", "studies", "report", "exports"} <= named


def test_the_floors_are_those_of_the_imports() -> None:
    every = [name for floor, name, _ in FLOORS if floor]
    assert sorted(every) == sorted(LEVELS)
    assert {*every} == packages() - {"__init__"}
    assert [float(floor) for floor, _, _ in FLOORS if floor] == [LEVELS[name] for name in every]
    assert [LEVELS[name] for name in every] == sorted(LEVELS.values())


def test_every_package_within_a_package_has_its_row_below_it() -> None:
    inner = {path.parent.relative_to(SOURCE).as_posix() for path in SOURCE.rglob("*/*/__init__.py")}
    assert sorted(name for floor, name, _ in FLOORS if not floor) == sorted(inner)
    order = [name for _, name, _ in FLOORS]
    assert all(order[order.index(name) - 1].split("/")[0] == name.split("/")[0] for name in inner)


@pytest.mark.parametrize(("name", "text"), [row[1:] for row in FLOORS], ids=[row[1] for row in FLOORS])
def test_a_floor_s_files_lie_in_it(name: str, text: str) -> None:
    files = [path for path in quoted(text) if is_path(path)]
    assert [path for path in files if not (SOURCE / name / path).is_file()] == []
    assert bool(files) or LEVELS.get(name, 9) <= 2 or not (SOURCE / name).is_dir()
    assert len(files) <= 14


# The contracts.


def classes(contract: str) -> dict[str, type[Any]]:
    """The classes that a contract's first paragraph names, each found in one of the files that it names."""
    head = quoted(CONTRACTS[contract].split("\n- ")[0])
    files = [module(path) for path in head if path.endswith(".py") and found(path, SOURCE)]
    names = [name for name in head if re.fullmatch(r"[A-Z][A-Za-z]+(\.\w+)?", name) and "_" not in name]
    made = {}
    for name in names:
        owner, _, member = name.partition(".")
        made[owner] = next((getattr(file, owner) for file in files if hasattr(file, owner)), None)
        if made[owner] is None and member:  # of a class that another contract or floor has
            made.pop(owner)
    assert None not in made.values(), made
    return {name: of for name, of in made.items() if inspect.isclass(of)}


def entries(contract: str) -> dict[str, str]:
    """What a contract says, by what is asked: must give, may give, gets, asks, holds."""
    items = re.findall(r"^- \*([\w ]+)\*(.*?)(?=^- |\Z)", CONTRACTS[contract], re.M | re.S)
    assert items
    return dict(items)


def members(of: type[Any]) -> set[str]:
    """All names of a class: what it defines, and what it annotates alone."""
    return {name for base in of.__mro__ for name in (*vars(base), *vars(base).get("__annotations__", {}))}


def required(of: type[Any]) -> set[str]:
    """What a class leaves open: of a protocol all, else abstract methods and class variables without a value."""
    if getattr(of, "_is_protocol", False):
        return {name for name in (*vars(of), *of.__annotations__) if not name.startswith("_")}
    annotated = vars(of).get("__annotations__", {})
    return {*getattr(of, "__abstractmethods__", ())} | {
        name for name, said in annotated.items() if str(said).startswith("ClassVar") and not hasattr(of, name)
    }


NAME = re.compile(r"[a-z_]\w*")


def given(contract: str) -> set[str]:
    """The members that a contract tells of."""
    said = entries(contract)
    names = [name for key in ("must give", "may give", "gets") for name in quoted(said.get(key, ""))]
    return {name for name in names if NAME.fullmatch(name)}


WITH_CLASSES = [name for name in CONTRACTS if name not in ("Text on its way out", "Language")]


def test_there_are_contracts_for_all_that_was_promised() -> None:
    assert len(CONTRACTS) >= 15
    assert [name for name in WITH_CLASSES if not classes(name)] == []


@pytest.mark.parametrize("contract", CONTRACTS)
def test_a_contract_says_who_asks_and_what_holds_it(contract: str) -> None:
    said = entries(contract)
    assert {"asks", "holds"} <= said.keys() <= {"must give", "may give", "gets", "asks", "holds"}
    tests = quoted(said["holds"])
    assert tests and all(path.startswith("tests/") and (ROOT / path).is_file() for path in tests)


@pytest.mark.parametrize("contract", WITH_CLASSES)
def test_members_of_contracts_are_there(contract: str) -> None:
    known = {name for of in classes(contract).values() for name in members(of)}
    others = {"done", "failures", "warnings", "exports"}  # of outcomes and of files
    assert given(contract) - known - others == set()


@pytest.mark.parametrize("contract", WITH_CLASSES)
def test_what_a_contract_leaves_open_is_told(contract: str) -> None:
    """Abstract methods, class variables without a value, all of a protocol: one must give them, or may."""
    said = entries(contract)
    told = {name for key in ("must give", "may give") for name in quoted(said.get(key, ""))}
    for of in classes(contract).values():
        assert required(of) <= told, (of.__name__, required(of) - told)


@pytest.mark.parametrize("contract", WITH_CLASSES)
def test_who_asks_a_contract_knows_it(contract: str) -> None:
    """By its class, by the registry beside that, or by a member that hardly any other contract has too."""
    spoken = Counter(name for one in CONTRACTS for name in given(one))
    beside = {of.__module__.removeprefix("linkwright.").replace(".", "/") + ".py" for of in classes(contract).values()}
    words = [rf"\b{name}\b" for name in (*classes(contract), *(name for name, file in registries() if file in beside))]
    words += [rf"\.{name}\b" for name in given(contract) if spoken[name] <= 2]
    asked = re.compile("|".join(words))
    paths = [path for path in quoted(entries(contract)["asks"]) if path.endswith(".py")]
    assert paths
    assert [path for path in paths if not asked.search((SOURCE / path).read_text("utf-8"))] == []


# To add.


@cache
def registries() -> frozenset[tuple[str, str]]:
    """(name, file) of each registry of the package, and of each function that registers without one."""
    every: set[tuple[str, str]] = set()
    for path in SOURCE.rglob("*.py"):
        file, body = path.relative_to(SOURCE).as_posix(), ast.parse(path.read_text("utf-8")).body
        stated = [node for node in body if isinstance(node, ast.AnnAssign)]
        own = [ast.unparse(node.target) for node in stated if "Registry[" in ast.unparse(node.annotation)]
        if not own:
            own = [node.name for node in body if isinstance(node, ast.FunctionDef) and node.name.startswith("register")]
        every |= {(name, file) for name in own}
    return frozenset(every)


def test_every_registry_is_told_of() -> None:
    every = registries()
    assert len(every) >= 20
    assert {("KINDS", "elements/joint.py"), ("register", "enclosures/intervals.py")} <= every
    told = {pair for text in RECIPES.values() for pair in re.findall(r"`(\w+)` of\s+`([\w/.]+)`", text)}
    assert every <= told, every - told


@pytest.mark.parametrize("what", RECIPES)
def test_steps_are_in_order_with_a_file_to_copy_and_tests(what: str) -> None:
    text = RECIPES[what]
    numbers = [int(number) for number in re.findall(r"^(\d+)\. ", text, re.M)]
    assert numbers == [*range(1, len(numbers) + 1)] and 1 <= len(numbers) <= 5
    copied = [path for path in quoted(text.split("\n1. ")[0].split("Registr")[0]) if is_path(path)]
    assert text.strip().startswith("Copy ") and copied
    assert all(found(path, SOURCE, ROOT) for path in copied)
    tested = [path for path in quoted(text.split("\nTests: ")[1]) if path.startswith("tests/")]
    assert tested and all((ROOT / path).is_file() for path in tested)


@pytest.mark.parametrize("what", RECIPES)
def test_names_of_recipes_are_in_their_files(what: str) -> None:
    """`NAME` of, in or among ... `FILE`."""
    pairs = re.findall(r"`([A-Za-z_]\w*)`(?: with its\s\w+)? (?:of|in|among)\s+`([\w/.]+\.py)`", RECIPES[what])
    for name, path in pairs:
        file = found(path, SOURCE, ROOT)
        assert file is not None
        assert re.search(rf"\b{name}\b", file.read_text("utf-8")), (name, path)


# The house.


def test_every_rule_is_kept_by_something() -> None:
    rows = re.findall(r"^\| (.+) \| (.+) \|$", CHAPTERS["How the house is kept"], re.M)[1:]
    assert len(rows) >= 10
    assert all(any(found(path, SOURCE, ROOT) for path in quoted(kept)) for _, kept in rows)
