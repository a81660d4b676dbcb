"""What others may rely on: the public names, the registries, and that imports go down only."""

from __future__ import annotations

import ast
import importlib
import inspect
from collections.abc import Iterator
from functools import cache
from graphlib import CycleError, TopologicalSorter
from pathlib import Path
from typing import Any

import pytest

import linkwright
from helpers.offenders import nobody_breaks
from linkwright.elements import FORCES, KINDS
from linkwright.elements.entries import SECTIONS
from linkwright.elements.follower import FOLLOWERS
from linkwright.exports import TARGETS
from linkwright.exports import register as register_target
from linkwright.groups import REGISTRY
from linkwright.groups.dyad import register as register_group
from linkwright.kernels import KERNELS
from linkwright.kernels.registry import register as register_kernel
from linkwright.model.mechanism import FOLLOWING
from linkwright.studies import STUDIES
from linkwright.studies.registry import Study
from linkwright.studies.registry import register as register_study

PUBLIC = [
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
SOURCE = Path(linkwright.__file__).parent
FILES = {path.relative_to(SOURCE).as_posix(): path for path in sorted(SOURCE.rglob("*.py"))}


@cache
def tree(path: Path) -> ast.Module:
    """The syntax tree of a module, parsed once for all tests."""
    return ast.parse(path.read_text("utf-8"))


# Names.


def test_the_public_names() -> None:
    assert linkwright.__all__ == PUBLIC
    assert sorted(PUBLIC) == PUBLIC
    assert sorted(dir(linkwright)) == sorted([*PUBLIC, "__version__"])


def silent(name: str) -> list[str]:
    """What a public name leaves unsaid: itself, or its own functions and properties."""
    thing = getattr(linkwright, name)
    assert callable(thing) and thing is getattr(linkwright, name), name
    assert not inspect.isclass(thing) or thing.__name__ == name
    members = {
        member: value
        for member, value in (vars(thing).items() if inspect.isclass(thing) else ())
        if not member.startswith(("_", "model_")) and (inspect.isfunction(value) or isinstance(value, property))
    }
    return [part for part, value in {name: thing, **members}.items() if not inspect.getdoc(value)]


def test_each_name_is_there_and_says_what_it_is() -> None:
    nobody_breaks({name: silent(name) for name in PUBLIC})


def test_a_star_import_gives_them_all() -> None:
    names: dict[str, Any] = {}
    exec("from linkwright import *", names)
    assert set(PUBLIC) <= set(names)


@pytest.mark.parametrize("name", ["nothing", "Cycle", "_run"])
def test_no_other_name(name: str) -> None:
    with pytest.raises(AttributeError, match=name):
        getattr(linkwright, name)


def test_version_is_the_projects() -> None:
    import tomllib

    project = SOURCE.parents[1] / "pyproject.toml"
    if project.exists():
        assert tomllib.loads(project.read_text("utf-8"))["project"]["version"] == linkwright.__version__


def test_typing_sees_what_is_loaded() -> None:
    """The names under TYPE_CHECKING are the ones that __getattr__ gives."""
    body = tree(SOURCE / "__init__.py").body
    (block,) = [node for node in body if isinstance(node, ast.If) and "TYPE_CHECKING" in ast.dump(node.test)]
    seen = {}
    for node in block.body:
        assert isinstance(node, ast.ImportFrom)
        for alias in node.names:
            seen[alias.asname or alias.name] = getattr(importlib.import_module(node.module or ""), alias.name)
    assert seen == {name: getattr(linkwright, name) for name in PUBLIC}


# Registries are loud.


def test_the_registered_names() -> None:
    assert set(REGISTRY) == {"RRR", "RRP", "RPR", "PRP", "RPP"}
    assert set(KERNELS) == {"jax", "llvm", "numpy"}
    assert set(STUDIES) == {"accuracy", "cam", "cycle", "limits", "modes", "reactions", "sweep", "workspace"}
    assert set(TARGETS) == {"mjcf", "motor-expressions", "process-simulate"}


@pytest.mark.parametrize("entry", REGISTRY.values(), ids=REGISTRY)
def test_a_group_registers_once(entry: Any) -> None:
    before = dict(REGISTRY)
    with pytest.raises(ValueError, match=entry.signature):
        register_group(type("Second", (), {"signature": entry.signature}))  # type: ignore[arg-type]
    assert before == REGISTRY


@pytest.mark.parametrize("name", KERNELS)
def test_a_kernel_registers_once(name: str) -> None:
    before = dict(KERNELS)
    with pytest.raises(ValueError, match=name):
        register_kernel(type("Second", (), {"name": name}))
    assert before == KERNELS


@pytest.mark.parametrize("name", STUDIES)
def test_a_study_registers_once(name: str) -> None:
    before = dict(STUDIES)
    with pytest.raises(ValueError, match=name):
        register_study(type("Second", (type(STUDIES[name]),), {}))
    assert before == STUDIES


@pytest.mark.parametrize("missing", ["run", "report"])
def test_a_study_runs_and_says_what_it_found(missing: str) -> None:
    """Nothing is a study that can't be performed or of which nothing can be shown."""
    both = {"run": lambda *given: None, "report": lambda *given: None}
    assert type("Whole", (Study,), {"name": "whole", **both})()
    del both[missing]
    before = dict(STUDIES)
    with pytest.raises(TypeError, match=missing):
        register_study(type("Half", (Study,), {"name": "half", **both}))
    assert before == STUDIES and all(isinstance(study, Study) for study in STUDIES.values())


@pytest.mark.parametrize("name", TARGETS)
def test_a_target_registers_once(name: str) -> None:
    before = dict(TARGETS)
    with pytest.raises(ValueError, match=name):
        register_target(type("Second", (), {"name": name}))
    assert before == TARGETS


@pytest.mark.parametrize(
    ("registry", "key"), [(REGISTRY, "signature"), (KERNELS, "name"), (STUDIES, "name"), (TARGETS, "name")]
)
def test_a_registered_name_stands_on_its_class(registry: dict[str, Any], key: str) -> None:
    for name, entry in registry.items():
        assert getattr(entry, key) == name
        assert inspect.getdoc(entry)


# Imports go down only.

LEVELS = {
    **dict.fromkeys(("data_classes", "symbols"), -1),
    **dict.fromkeys(("_lazy", "_version", "escape", "interrupts", "notation", "plugins", "words", "gallery"), 0),
    **dict.fromkeys(("findings", "laws", "tolerances"), 1),
    **dict.fromkeys(("_machine", "expressions", "presentation"), 2),
    "drawing": 2.5,
    "elements": 3,
    "reductions": 3.5,
    "model": 4,
    **dict.fromkeys(("formulas", "groups"), 4.5),
    "structure": 5,
    "graph": 6,
    "kernels": 7,
    **dict.fromkeys(("blocks", "compilation"), 8),
    "results": 9,
    **dict.fromkeys(("cam", "enclosures"), 10),
    "measures": 11,
    "studies": 12,
    "report": 13,
    "exports": 14,
    "app": 15,
    "cli": 16,
    "__main__": 17,
}
# The side floors know of nothing but what is named here, and of the ground.
SIDES = {
    **{
        side: set[str]()
        for side in ("_lazy", "_version", "escape", "interrupts", "notation", "plugins", "records", "words", "gallery")
    },
    "notation": {"symbols"},
    "findings": {"escape", "words"},
    "laws": {"notation"},
    "tolerances": {"notation"},
    "presentation": {"_version", "escape", "findings", "words"},
    "drawing": {"escape", "findings", "presentation"},
}


def imports_late(node: ast.AST) -> bool:
    """Whether a node calls ``import_module``."""
    match node:
        case ast.Call(func=ast.Name(id=name) | ast.Attribute(attr=name)):
            return name == "import_module"
    return False


@cache
def imports() -> list[tuple[str, str, str]]:
    """(file, its package, a package that it imports), those inside functions and for type checkers too."""
    found = []
    for path in FILES.values():
        parts = path.relative_to(SOURCE).parts
        if parts == ("__init__.py",):
            continue
        here = parts[0].removesuffix(".py")
        place = ["linkwright", *parts[:-1]]
        for node in ast.walk(tree(path)):
            targets: list[str] = []
            if isinstance(node, ast.Import):
                targets = [alias.name for alias in node.names]
            elif isinstance(node, ast.ImportFrom):
                base = place[: len(place) - node.level + 1] if node.level else []
                module = ".".join([*base, *([node.module] if node.module else [])])
                targets = [f"{module}.{alias.name}" for alias in node.names] if module == "linkwright" else [module]
            elif imports_late(node):
                texts = [n.value for n in ast.walk(node) if isinstance(n, ast.Constant) and isinstance(n.value, str)]
                targets = [text for text in texts if text.startswith("linkwright.")]
            for target in targets:
                words = target.split(".")
                if words[0] == "linkwright" and len(words) > 1:
                    found.append(("/".join(parts), here, words[1]))
    return found


def packages() -> set[str]:
    return {p.name.removesuffix(".py") for p in SOURCE.iterdir() if p.suffix == ".py" or (p / "__init__.py").exists()}


def test_every_package_has_its_floor() -> None:
    assert packages() - {"__init__"} <= LEVELS.keys()


def test_imports_go_down_only() -> None:
    up = {
        f"{file} imports {target}"
        for file, here, target in imports()
        if target in LEVELS and target != here and LEVELS[target] >= LEVELS[here]
    }
    assert not up


def test_the_side_floors_know_of_nothing_else() -> None:
    seen: dict[str, set[str]] = {side: set() for side in SIDES}
    for _, here, target in imports():
        if here in SIDES and target != here and LEVELS.get(target, -1) >= 0:
            seen[here].add(target)
    assert all(seen[side] <= known for side, known in SIDES.items()), seen


# No circles.


def run_time_nodes(node: ast.AST) -> Iterator[ast.AST]:
    """What is executed, in functions too; what stands under ``if TYPE_CHECKING`` isn't."""
    for child in ast.iter_child_nodes(node):
        if isinstance(child, ast.If) and ast.unparse(child.test).endswith("TYPE_CHECKING"):
            for other in child.orelse:
                yield from (other, *run_time_nodes(other))
        else:
            yield from (child, *run_time_nodes(child))


def run_time_imports(source: Path) -> dict[str, set[str]]:
    """The modules of a package, each with those of the package that it imports at load or within a function."""
    files = {}
    for path in source.rglob("*.py"):
        parts = [source.name, *path.relative_to(source).with_suffix("").parts]
        files[".".join(parts[:-1] if parts[-1] == "__init__" else parts)] = path
    graph: dict[str, set[str]] = {}
    for module, path in files.items():
        package = module.split(".") if path.name == "__init__.py" else module.split(".")[:-1]
        targets: set[str] = set()
        for node in run_time_nodes(tree(path)):
            if isinstance(node, ast.Import):
                targets |= {alias.name for alias in node.names}
            elif isinstance(node, ast.ImportFrom):
                above = package[: len(package) - node.level + 1] if node.level else []
                base = ".".join([*above, *([node.module] if node.module else [])])
                named = {f"{base}.{alias.name}" for alias in node.names}
                targets |= named if named <= files.keys() else {base, *named}
            elif imports_late(node):
                texts = [n.value for n in ast.walk(node) if isinstance(n, ast.Constant) and isinstance(n.value, str)]
                targets |= {*texts}
        graph[module] = (targets & files.keys()) - {module}
    return graph


def circle(graph: dict[str, set[str]]) -> list[str]:
    """Modules that import one another in a circle, the first one again at its end; nothing where there are none."""
    try:
        TopologicalSorter(graph).prepare()
    except CycleError as error:
        return [*error.args[1]]
    return []


def test_no_module_imports_itself_through_others() -> None:
    """Imports of functions count: what is done late only hides a circle. Those for type checkers don't."""
    assert circle(run_time_imports(SOURCE)) == []


@pytest.mark.parametrize(
    ("text", "found"),
    [
        ("from made.a import x", True),
        ("import made.a", True),
        ("from made import a", True),
        ("from . import a", True),
        ("from .a import x", True),
        ("def f():\n    from made.a import x", True),
        ("class C:\n    def f(self):\n        import_module('made.a')", True),
        ("if TYPE_CHECKING:\n    pass\nelse:\n    from made.a import x", True),
        ("if TYPE_CHECKING:\n    from made.a import x", False),
        ("if typing.TYPE_CHECKING:\n    from made.a import x", False),
        ("def f():\n    if TYPE_CHECKING:\n        from made.a import x", False),
        ("from made import other", False),
    ],
)
def test_which_imports_make_a_circle(tmp_path: Path, text: str, found: bool) -> None:
    made = tmp_path / "made"
    made.mkdir()
    for name, content in (("__init__", ""), ("a", "from made.b import y"), ("b", text)):
        (made / f"{name}.py").write_text(content, "utf-8")
    modules = circle(run_time_imports(made))
    assert {*modules} == ({"made.a", "made.b"} if found else set())


# What else modules keep to.

SPEAKERS = {"words", "findings"}
ENDS = {"print", "exit", "sys.exit", "os._exit", "eval", "exec"}
ENDS_ALLOWED = {"data_classes.py": {"exec"}}
"""Data classes are compiled from the names of their fields."""


@cache
def called(path: Path) -> set[str]:
    """The functions that a module calls, as it names them."""
    return {ast.unparse(node.func) for node in ast.walk(tree(path)) if isinstance(node, ast.Call)}


def test_nothing_below_the_report_makes_words() -> None:
    """Results hold keys and data; who reports them says them."""
    places = {file: file.split("/")[0].removesuffix(".py") for file in FILES}
    low = {file for file, at in places.items() if LEVELS.get(at, 99) < LEVELS["report"] and at not in SPEAKERS}
    nobody_breaks({file: called(FILES[file]) & {"say"} for file in low})


def test_nothing_below_the_command_line_prints_or_leaves() -> None:
    low = {file for file in FILES if file.split("/")[0] not in ("cli", "__main__.py")}
    nobody_breaks({file: (called(FILES[file]) & ENDS) - ENDS_ALLOWED.get(file, set()) for file in low})


def test_every_module_says_what_it_is() -> None:
    nobody_breaks({file: [] if ast.get_docstring(tree(path)) else ["no docstring"] for file, path in FILES.items()})


def test_every_module_can_be_imported() -> None:
    for file in {*FILES} - {"__init__.py"}:
        importlib.import_module("linkwright." + file.removesuffix(".py").removesuffix("/__init__").replace("/", "."))


# Kinds of elements are asked, not told apart by name.


NAMES = {kind.name for kind in KINDS.values()} | {*FORCES, *FOLLOWERS}
LETTERS = {kind.letter for kind in KINDS.values()}
SECTIONS_OF_KINDS = {*SECTIONS, *FOLLOWING} - {"joints"}
"""Sections that stand for what their elements are; among the joints there is more than one kind."""
LEGITIMATE = {
    "tolerances/iso286.py": "letters of ISO 286",
    "model/parts.py": "the keys of an entry of pins and slides",
    "studies/cam/study.py": "the study called cam",
}
"""Files outside ``elements`` in which such comparisons are none of kinds, or may stand; each with the reason."""


def asks_a_kind(node: ast.Compare) -> bool:
    """Whether a comparison tells kinds apart: by a letter, a name, or the section in which an element stands."""
    sides = [node.left, *node.comparators]
    parts = [part for side in sides for part in ast.walk(side)]
    asked = {part.attr for part in parts if isinstance(part, ast.Attribute)}
    told = {part.value for part in parts if isinstance(part, ast.Constant)}
    ends = [side for side, op in zip(node.comparators, node.ops, strict=True) if isinstance(op, ast.In | ast.NotIn)]
    within = {side.attr for side in ends if isinstance(side, ast.Attribute)}
    return bool(
        asked & {"letter", "letters"}
        or told & NAMES
        or (told & LETTERS and asked & {"kind", "name"})
        or (told & SECTIONS_OF_KINDS and asked & {"section", "path"})
        or within & SECTIONS_OF_KINDS
    )


def comparisons(text: str) -> list[ast.Compare]:
    """Those of a module that tell kinds apart."""
    return [node for node in ast.walk(ast.parse(text)) if isinstance(node, ast.Compare) and asks_a_kind(node)]


def test_nobody_compares_letters_or_names_of_kinds() -> None:
    """Letters and names of kinds stand in signatures and files; nothing outside their own files depends on them."""
    found: dict[str, list[str]] = {}
    for file, path in FILES.items():
        if not file.startswith("elements/") and (asked := comparisons(path.read_text("utf-8"))):
            found[file] = [f"{node.lineno} {ast.unparse(node)}" for node in asked]
    assert found.keys() == LEGITIMATE.keys(), {file: found.get(file) for file in found.keys() ^ LEGITIMATE.keys()}


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("c.kind.letter == d.letter", True),
        ("joint.kind.name == 'pin_in_slot'", True),
        ("entry.kind == 'revolute'", True),
        ("kind in ('spring', 'damper')", True),
        ("one.kind.name != 'counterweight'", True),
        ("follower.kind == 'cam'", True),
        ("c.kind == 'P'", True),
        ("name in mechanism.cams", True),
        ("name not in compiled.mechanism.springs", True),
        ("one.section == 'loads'", True),
        ("name in mechanism.joints", False),
        ("signal.kind == 'link'", False),
        ("'R' in values", False),
        ("one.section == section", False),
        ("cams[name].closed == 'groove'", False),
    ],
)
def test_which_comparisons_tell_kinds_apart(text: str, told: bool) -> None:
    assert bool(comparisons(text)) == told
