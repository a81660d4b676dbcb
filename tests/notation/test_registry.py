"""Registries: a name is set once; what a table names is imported when it is first asked for, whole or not at all."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Mapping
from importlib import import_module, invalidate_caches
from pathlib import Path
from pkgutil import walk_packages

import pytest

import linkwright
from linkwright.elements import FORCES, KINDS
from linkwright.elements.entries import ENTRIES
from linkwright.elements.follower import FOLLOWERS
from linkwright.exports import TARGETS
from linkwright.kernels import KERNELS
from linkwright.notation.registry import Registry
from linkwright.reductions import ENTRIES as MEASURES
from linkwright.reductions import REDUCTIONS
from linkwright.studies import STUDIES

TABLES: Mapping[str, Registry[object]] = {
    "joints": KINDS,
    "followers": FOLLOWERS,
    "forces": FORCES,
    "reductions": REDUCTIONS,
    "measures": MEASURES,
    "studies": STUDIES,
    "targets": TARGETS,
    "kernels": KERNELS,
    **{f"entries of {section}": entries for section, entries in ENTRIES.items()},
}  # type: ignore[assignment]

LATE: Registry[object] = Registry({"first": "late_kinds", "second": "late_kinds"})
"""What a module registers that a test writes."""
MODULE = """
from notation.test_registry import LATE

class First: ...
LATE["first"] = First()
if {interrupted}:
    raise KeyboardInterrupt
class Second: ...
LATE["second"] = Second()
"""


@pytest.fixture
def late(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The file of that module."""
    monkeypatch.syspath_prepend(tmp_path)
    for kept in (LATE._things, LATE._origins):
        kept.clear()
    sys.modules.pop("late_kinds", None)
    return tmp_path / "late_kinds.py"


def write(late: Path, interrupted: bool) -> None:
    late.write_text(MODULE.format(interrupted=interrupted), "utf-8")
    late.touch()
    invalidate_caches()


def test_names_are_known_before_anything_is_imported(late: Path) -> None:
    write(late, False)
    assert [*LATE] == ["first", "second"] and "second" in LATE and len(LATE) == 2 and "third" not in LATE
    assert "late_kinds" not in sys.modules
    assert type(LATE["second"]).__module__ == "late_kinds"
    assert [type(thing).__name__ for thing in LATE.values()] == ["First", "Second"]
    with pytest.raises(KeyError):
        LATE["third"]


def test_a_listed_name_is_taken_before_its_module_is_imported(late: Path) -> None:
    write(late, False)
    with pytest.raises(ValueError, match="first is registered twice"):
        LATE["first"] = object()
    assert type(LATE["first"]).__name__ == "First"


def test_a_name_is_set_once(late: Path) -> None:
    write(late, False)
    for name in LATE:
        for thing in (LATE[name], type(LATE[name])(), object()):
            with pytest.raises(ValueError, match=name):
                LATE[name] = thing
    LATE["own"] = late
    with pytest.raises(ValueError, match="own"):
        LATE["own"] = late
    del LATE["own"]
    LATE["own"] = late


def test_an_interrupted_import_is_made_up_for(late: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Ctrl-C within a module that has registered some things and others not: they all come when it is asked again."""
    monkeypatch.setattr(sys, "dont_write_bytecode", True)
    write(late, True)
    with pytest.raises(KeyboardInterrupt):
        LATE["second"]
    write(late, False)
    assert type(LATE["second"]).__module__ == "late_kinds"
    assert type(LATE["first"]) is sys.modules["late_kinds"].First
    with pytest.raises(ValueError, match="first"):
        LATE["first"] = type(LATE["first"])()


@pytest.mark.parametrize("which", ["geneva.follower", "belt", "spring", "cam_contact.follower", "coupling"])
def test_a_kind_is_registered_whole_after_an_interrupt(which: str) -> None:
    """Wherever the import of a kind is broken off; in a process of its own."""
    script = f"""
import sys
import linkwright.model.mechanism
from linkwright.elements.kind_modules import KIND_MODULES
from linkwright.elements import FORCES, KINDS
from linkwright.elements.entries import ENTRIES
from linkwright.elements.follower import FOLLOWERS
from linkwright.notation.registry import Registry

elements = "linkwright.elements."
module = elements + "{which}"
of = {{"joint": KINDS, "follower": FOLLOWERS, "force": FORCES}}
name, listed = next((name, one) for name, one in KIND_MODULES.items() if module.startswith(elements + one.module))
whole, left = Registry.__setitem__, 0
def broken(self, name, thing):
    global left
    whole(self, name, thing)
    left -= 1
    if left == 0:
        raise KeyboardInterrupt
Registry.__setitem__ = broken
for after in range(1, 2 + (listed.section is not None)):
    for forgotten in (module, elements + listed.module):
        sys.modules.pop(forgotten, None)
    for registry in (FORCES, KINDS, FOLLOWERS, *ENTRIES.values()):
        if name in registry._things:
            del registry[name]
    left = after
    try:
        of[listed.contract][name]
    except KeyboardInterrupt:
        assert module not in sys.modules
    else:
        raise AssertionError
    __import__(module)
kind = of[listed.contract][name]
assert (kind if isinstance(kind, type) else type(kind)) in vars(sys.modules[module]).values()
if listed.section is not None:
    entry = ENTRIES[listed.section][name]
    assert entry is (getattr(kind, "stated", None) or kind.entry), entry
"""
    done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr


def test_tables_name_all_that_this_package_registers() -> None:
    """In the modules that register it; imported when a name is asked for, and not before."""
    script = """
import sys
from notation.test_registry import TABLES

for registry in TABLES.values():
    assert len([*registry]) == len(registry) and repr(registry)
    assert not [name for name in registry if name in registry and "nothing" in registry]
listed = {module for registry in TABLES.values() for module in registry.modules.values()}
known = {"pin", "slide", "spring", "load", "friction", "counterweight", "prescribed"}  # of every file, by their entries
early = listed & {*sys.modules} - {f"linkwright.elements.{name}" for name in known}
assert not early, early
for registry in TABLES.values():
    for name, module in registry.modules.items():
        assert registry[name] is not None and module in sys.modules
"""
    folder = Path(__file__).parents[1]
    done = subprocess.run([sys.executable, "-c", script], cwd=folder, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    for found in walk_packages(linkwright.__path__, "linkwright."):
        if not found.name.endswith("__main__"):
            import_module(found.name)
    for registry in TABLES.values():
        ours = {name for name, thing in registry.items() if thing.__module__.startswith("linkwright.")}
        assert ours == {*registry.modules}
