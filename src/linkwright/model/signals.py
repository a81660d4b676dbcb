"""The signals of a mechanism: their names, and the dimension of each."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property

from linkwright.data_classes import dataclass
from linkwright.elements.force import Acting
from linkwright.elements.mover import TRAVEL as SLIDE
from linkwright.elements.mover import TURN as LINK
from linkwright.elements.points import links_of_points
from linkwright.expressions import units as u
from linkwright.expressions.dimensions import DimensionError
from linkwright.expressions.language import Call, Name, signal_text
from linkwright.expressions.units import Dimension
from linkwright.expressions.unknown import near
from linkwright.findings import Joined, Term
from linkwright.model.mechanism import FRAME, Mechanism
from linkwright.model.pins import pins
from linkwright.model.slides import in_loops

_PLANE = ("x", "y")
_RATES = (("", u.LENGTH), ("v", u.SPEED), ("a", u.ACCELERATION), ("j", u.JERK))

POINT = {f"{rate}{axis}": dimension for rate, dimension in _RATES for axis in _PLANE}
FORCE = {"x": u.FORCE, "y": u.FORCE}
SLIDE_FORCE = {**FORCE, "normal": u.FORCE, "moment": u.TORQUE, "arm": u.LENGTH}
SHAKING = {"x": u.FORCE, "y": u.FORCE, "moment": u.TORQUE}
ENERGY = {"kinetic": u.ENERGY, "potential": u.ENERGY}
TOTALS = {"stored": u.ENERGY, "supplied": u.POWER, "dissipated": u.POWER}
"""Sums over the mechanism, only by name: all energy stored; the power of all drives; what loads, dampers and friction
take and don't store."""
POWER = {"supplied": u.POWER, "dissipated": u.POWER}
BREAKAWAY = {"breakaway_forward": 1, "breakaway_backward": -1}
"""The efforts at which a drive starts the motion from rest, towards larger and smaller values."""
POLE = dict.fromkeys(("x", "y", "u", "v"), u.LENGTH)


@dataclass(frozen=True)
class Signal:
    """One signal: what kind of element it belongs to, the element's names, the attribute, its dimension; whether it is
    one of a follower's contact."""

    kind: str
    owners: tuple[str, ...]
    attribute: str
    dimension: Dimension
    of_contact: bool = False

    @property
    def kinematic(self) -> bool:
        """Whether it follows from the motion alone, without any force."""
        of_forces = self.kind in ("force", "shaking", "energy", "power") or self.of_contact
        return not of_forces and not self.dimension.mass

    @property
    def text(self) -> str:
        """The canonical name, as expressions spell it."""
        if self.kind in ("force", "com", "pole", "power"):
            return f"{self.kind}({', '.join(self.owners)}).{self.attribute}"
        return f"{self.owners[0]}.{self.attribute}"


@dataclass(frozen=True)
class Contact:
    """Where one link acts on another: ``on`` is a link, or the pin where three or more links meet."""

    joint: str
    link: str
    on: str
    sliding: bool


class Signals:
    """Finds the signals of a mechanism by name."""

    def __init__(self, mechanism: Mechanism) -> None:
        self.mechanism = mechanism
        self.pins, self.links_of_points = pins(mechanism), links_of_points(mechanism)
        self._found: dict[str | Call, Signal] = {}
        self.undetermined: frozenset[tuple[str, str, str]] = frozenset()

    @cached_property
    def contacts(self) -> list[Contact]:
        """Every place where a reaction acts, both ways round."""
        found = []
        for pin in self.pins.values():
            for link in pin.links:
                others = [other for other in pin.links if other != link]
                found.append(Contact(pin.name, link, others[0] if len(others) == 1 else pin.name, False))
        for name, joint in self.mechanism.joints_but_pins():
            for link in joint.links:
                others = [other for other in joint.links if other != link]
                on = others[0] if len(others) == 1 else name
                found.append(Contact(name, link, on, bool(joint.prismatic)))
        return found

    @cached_property
    def contacts_of(self) -> dict[str, list[Contact]]:
        """The contacts of each link, in their order."""
        found: dict[str, list[Contact]] = {}
        for contact in self.contacts:
            found.setdefault(contact.link, []).append(contact)
        return found

    @cached_property
    def reactions(self) -> list[Contact]:
        """The same, of two links that meet one way round alone; without those that aren't determined."""
        found: dict[tuple[str, str], Contact] = {}
        for contact in self.contacts:
            found.setdefault((contact.joint, contact.link if contact.on == contact.joint else ""), contact)
        return [one for one in found.values() if not self._open(one, "x", "y")]

    def leave_undetermined(self, components: frozenset[tuple[str, str, str]]) -> None:
        """Note components of reactions, by joint, link and attribute, that are left out of lists and refused where a
        user asks for them: of a redundant mechanism, those that its stiffness alone would tell."""
        self.undetermined = components
        for cached in ("reactions", "by_text"):
            self.__dict__.pop(cached, None)

    def _open(self, contact: Contact, *attributes: str) -> bool:
        return any((contact.joint, contact.link, attribute) in self.undetermined for attribute in attributes)

    def is_undetermined(self, signal: Signal) -> bool:
        """Whether a signal is one of a reaction that isn't determined."""
        if not self.undetermined or signal.kinematic:
            return False
        if signal.kind == "force":
            parts = ("normal", "moment") if signal.attribute == "arm" else (signal.attribute,)
            return self._open(self.contact(signal.owners), *parts)
        if signal.kind == "joint":
            return any(self._open(one, "x", "y") for one in self.contacts if one.joint == signal.owners[0])
        return False

    @cached_property
    def looped(self) -> tuple[str, ...]:
        """The slides in loops of slides alone: statics doesn't determine how they share moments."""
        return in_loops(self.mechanism)

    @property
    def energies(self) -> dict[str, Dimension]:
        """The energies that a mechanism has."""
        elastic = any(one.kind.stores for one in self.mechanism.acting())
        return {**ENERGY, "elastic": u.ENERGY} if elastic else ENERGY

    @cached_property
    def acting(self) -> dict[str, Acting]:
        """What acts on links and has signals, by name."""
        return {one.name: one for one in self.mechanism.acting() if one.kind.signals(one.entry)}

    @cached_property
    def named(self) -> tuple[str, ...]:
        """The elements that have signals of their own."""
        m = self.mechanism
        return (*m.links, *self.links_of_points, *(name for name, _ in m.joints_but_pins()), *m.movers, *self.acting)

    def breaks_away(self, mover: str) -> bool:
        """Whether a drive has efforts at which it starts the motion from rest: where something resists more at rest."""
        drive = self.mechanism.drives.get(mover)
        return drive is not None and drive.output is None and self.static

    @cached_property
    def static(self) -> bool:
        """Whether something resists more at rest than in motion."""
        return any(one.at_start.entry is not one.entry for one in self.mechanism.acting())

    def contact(self, names: Sequence[str]) -> Contact:
        """The contact that ``force(names...)`` means. Raises DimensionError naming what is wrong."""
        link, on, *rest = [*names, "", ""][: max(2, len(names))]
        own = self.contacts_of.get(link, [])
        found = [c for c in own if on in (c.on, c.joint) and (not rest or [c.joint] == rest)]
        if len(found) == 1:
            return found[0]
        if found:
            raise DimensionError("signal.several-joints", a=link, b=on, joints=Joined(c.joint for c in found))
        options = Joined(f"force({c.link}, {c.on})" for c in self.contacts if link in (c.link, c.on))
        raise DimensionError("signal.no-joint", a=link, b=on, options=options or "-")

    def attributes(self, owner: str) -> tuple[str, dict[str, Dimension]]:
        """The kind of a named element and its attributes. Raises DimensionError for an unknown name."""
        m = self.mechanism
        if owner in m.links:
            return "link", LINK
        if owner in self.links_of_points:
            return "point", POINT
        if (joint := m.joints.get(owner)) is not None and not joint.revolute and not joint.follows:
            return ("slide", SLIDE) if joint.prismatic else ("joint", dict(joint.signals))
        if (mover := m.movers.get(owner)) is not None:
            starts = dict.fromkeys(BREAKAWAY, mover.signals[mover.effort]) if self.breaks_away(owner) else {}
            return "drive", {**mover.signals, **starts}
        if (one := self.acting.get(owner)) is not None:
            return one.noun, dict(one.kind.signals(one.entry))
        if owner == "shaking":
            return "shaking", SHAKING
        if owner == "energy":
            return "energy", {**self.energies, **TOTALS}
        raise DimensionError("name.unknown-element", name=owner, near=near(owner, [*self.named, "shaking", "energy"]))

    def find(self, node: Name | Call) -> Signal:
        """The signal that an expression names. Raises DimensionError naming what is wrong."""
        if isinstance(node, Call):
            if (known := self._found.get(node)) is None:
                known = self._found[node] = self._called_signal(node)
            return known
        if (known := self._found.get(node.text)) is None:
            owner, _, attribute = node.text.partition(".")
            kind, attributes = self.attributes(owner)
            known = self._found[node.text] = self._signal(kind, (owner,), attribute, attributes)
        return known

    def element(self, node: Name | Call) -> tuple[str, tuple[str, ...], dict[str, Dimension]]:
        """Kind, names and attributes of what ``E``, ``com(crank)`` or ``force(a, b)`` names."""
        if isinstance(node, Name):
            kind, attributes = self.attributes(node.text)
            return kind, (node.text,), attributes
        names = [signal_text(arg) if isinstance(arg, Name | Call) else "?" for arg in node.args]
        if node.name == "force" and len(names) in (2, 3):
            contact = self.contact(names)
            owners: tuple[str, ...] = (contact.link, contact.on)
            if sum(c.on == contact.on for c in self.contacts_of[contact.link]) > 1:
                owners = (*owners, contact.joint)
            return "force", owners, self.of_contact(contact)
        if node.name == "com" and len(names) == 1:
            if names[0] not in self.mechanism.links or not self.mechanism.has_mass(names[0]):
                raise DimensionError("signal.no-mass", name=names[0])
            return "com", (names[0],), POINT
        if node.name == "pole" and len(names) == 2:
            return "pole", self._two_links(names), POLE
        if node.name == "power" and len(names) == 1:
            return "power", (names[0],), self._powers(names[0])
        raise DimensionError("signal.unknown", name=signal_text(node), hint=Term("signal-forms"))

    def _owned(self, name: str) -> tuple[str, tuple[str, ...]]:
        """Kind and names of the signals of a named element."""
        return self.attributes(name)[0], (name,)

    def of_contact(self, contact: Contact) -> dict[str, Dimension]:
        """What is known of a reaction: of a slide in a loop of slides the force alone."""
        joint = self.mechanism.joints.get(contact.joint)
        known = SLIDE_FORCE if contact.sliding else FORCE
        if joint is not None and joint.couple:
            known = {**FORCE, "moment": u.TORQUE}
        hidden = ("moment", "arm") if contact.joint in self.looped else ()
        return {name: dimension for name, dimension in known.items() if name not in hidden}

    @cached_property
    def powered(self) -> dict[str, list[Acting | None]]:
        """What has power, by name: drives (``None``), and what acts on links."""
        found: dict[str, list[Acting | None]] = {name: [None] for name in self.mechanism.drives}
        for one in self.mechanism.acting():
            if one.kind.acts:
                found.setdefault(one.name, []).append(one)
        return found

    def _powers(self, name: str) -> dict[str, Dimension]:
        """The attributes of ``power(name)``."""
        if name not in self.powered:
            known = near(name, [*self.powered])
            raise DimensionError("name.unknown", kind=Term("a-powered"), name=name, near=known)
        if len(self.powered[name]) > 1:
            raise DimensionError("signal.several-elements", name=name)
        return {"supplied": u.POWER} if self.powered[name][0] is None else POWER

    def _two_links(self, names: Sequence[str]) -> tuple[str, ...]:
        for name in names:
            if name not in self.mechanism.links:
                known = near(name, list(self.mechanism.links))
                raise DimensionError("name.unknown", kind=Term("a-link"), name=name, near=known)
        if names[0] == names[1]:
            raise DimensionError("signal.same-link", name=names[0])
        return tuple(names)

    def _called_signal(self, node: Call) -> Signal:
        kind, owners, attributes = self.element(node)
        hidden = kind == "force" and node.attribute in SLIDE_FORCE.keys() - attributes.keys()
        if hidden and (joint := self.contact(owners).joint) in self.looped:
            data = {"attribute": node.attribute, "joint": joint, "loop": Joined(self.looped)}
            raise DimensionError("signal.indeterminate", **data)
        return self._signal(kind, owners, node.attribute or "", attributes)

    def _signal(self, kind: str, owners: tuple[str, ...], attribute: str, attributes: dict[str, Dimension]) -> Signal:
        if attribute not in attributes:
            raise DimensionError(
                "signal.no-attribute",
                name=Joined(owners),
                attribute=attribute,
                near=near(attribute, attributes, listed=True),
            )
        followers = self.mechanism.followers
        of_contact = kind == "drive" and owners[0] in followers and attribute in followers[owners[0]].extra
        return Signal(kind, owners, attribute, attributes[attribute], of_contact)

    @cached_property
    def by_text(self) -> dict[str, Signal]:
        """Every signal by its name, as it is written out."""
        return {signal.text: signal for signal in self.all()}

    def all(self) -> list[Signal]:
        """Every signal of the mechanism that is determined, motion first, then forces; poles, one for any two links,
        only by name."""
        return [signal for signal in self.possible() if not self.is_undetermined(signal)]

    def possible(self) -> list[Signal]:
        """The same with those of reactions that statics doesn't determine."""
        m = self.mechanism
        found = [Signal("point", (p,), a, d) for p in self.links_of_points for a, d in POINT.items()]
        found += [Signal("link", (link,), a, d) for link in m.links if link != FRAME for a, d in LINK.items()]
        owners = [name for name, _ in m.joints_but_pins()]
        found += [Signal(*self._owned(name), a, d) for name in owners for a, d in self.attributes(name)[1].items()]
        found += [self.find(Name(f"{name}.{a}")) for name in m.movers for a in self.attributes(name)[1]]
        found += [Signal("com", (n,), a, d) for n in m.links if m.has_mass(n) for a, d in POINT.items()]
        seen = set()
        for c in self.contacts:
            if (c.joint, c.on) in seen and c.on != c.joint:
                continue
            seen |= {(c.joint, c.link)}
            attributes = self.of_contact(c)
            found += [
                self._called_signal(Call("force", (Name(c.link), Name(c.on), Name(c.joint)), a)) for a in attributes
            ]
        found += [Signal("shaking", ("shaking",), a, d) for a, d in SHAKING.items()]
        found += [Signal(*self._owned(name), a, d) for name in self.acting for a, d in self.attributes(name)[1].items()]
        return found + [Signal("energy", ("energy",), a, d) for a, d in self.energies.items()]
