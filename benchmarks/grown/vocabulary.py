"""The words of model files that growers have to cover, from the registries: a newly registered kind is among them."""

from __future__ import annotations

from grown.plane import GROWERS, Data
from linkwright.elements.drive import Drive
from linkwright.elements.kind_modules import KIND_MODULES
from linkwright.groups import REGISTRY
from linkwright.laws import LAWS
from linkwright.model.mechanism import Mechanism
from linkwright.reductions import ENTRIES
from linkwright.studies import STUDIES

WITHOUT = {"name", "note", "source", "author", "revision", "units"}
"""Sections that say nothing of the mechanism."""
BESIDES = {"at", "along", "on_", "speed", "start", "acceleration", "position"}
"""What drives have besides the keys that say what is moved."""
OF_ALL = {"sketch", "plane", "reactions"}
"""What is drawn for a mechanism as a whole: how its links are written, a structure that stands."""
OF_SECTION = {"loads": "load", "springs": "spring", "counterweights": "counterweight", "cams": "cam"}
"""Sections whose entries are of one kind."""


def vocabulary() -> set[str]:
    """Kinds of elements, ``dyad.RRR``, ``law.cycloidal``, ``drive.turns``, reductions, studies, sections."""
    found = {*KIND_MODULES, *ENTRIES, *STUDIES}
    found |= {f"dyad.{''.join(signature)}" for signature in REGISTRY}
    found |= {f"law.{name}" for name in LAWS}
    found |= {f"drive.{verb}" for verb in Drive.model_fields.keys() - BESIDES}
    return found | {name for name in Mechanism.model_fields if name not in WITHOUT}


def missing() -> set[str]:
    """The words of the vocabulary that no grower covers; motion laws are drawn from their registry."""
    covered = OF_ALL | {word for grower in GROWERS.values() for word in grower.covers}
    return {word for word in vocabulary() - covered if not word.startswith("law.")}


def words_of(data: Data) -> set[str]:
    """The words of the vocabulary that a model file has; those of its structure, such as dyads, aside."""
    entries = {name: section for name, section in data.items() if isinstance(section, dict)}
    found = {*data} | {OF_SECTION[name] for name in entries if name in OF_SECTION}
    found |= {next(iter(entry)) for entry in entries.get("joints", {}).values()}
    found |= {next(iter(entry)) for entry in entries.get("measures", {}).values()}
    found |= {*entries.get("studies", {})}
    found |= {f"drive.{key}" for drive in entries.get("drives", {}).values() for key in drive}
    segments = (part for law in entries.get("laws", {}).values() for part in law["segments"])
    return found | {f"law.{part['law']}" for part in segments if "law" in part}
