"""What a kind of force element is: the contract for all that acts on links, as springs, loads and counterweights do.

A *kind* is one registered object. It says what a file may state, what it needs of each pose (tables, whole turns of an
angle, the time), where it jumps, and what it does to its links, from jets of numbers, arrays or symbols. Whether it
stores energy, weighs something, is drawn: all that is asked here, and nobody asks a kind for its name.
"""

from __future__ import annotations

from abc import ABC
from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import Any, ClassVar, Generic, Literal, NamedTuple, Protocol, TypeVar

import numpy as np
from numpy.typing import NDArray

from linkwright.elements.entries import NOUNS, ForceEntry, make_known
from linkwright.elements.joint import Applied, LinkPoses, Restated
from linkwright.elements.kind_modules import of_contract
from linkwright.elements.mover import MoverReports
from linkwright.elements.touch import ReportedTouch, Touch
from linkwright.expressions.dimensions import Wanted
from linkwright.expressions.fields import Expression, Position, Two
from linkwright.expressions.language import Node
from linkwright.expressions.typed_fields import Path, Scope
from linkwright.expressions.units import Dimension
from linkwright.findings import Finding, Term
from linkwright.notation import Scalar, Wrench
from linkwright.notation.registry import Registry

Array = NDArray[np.float64]
E = TypeVar("E", bound=ForceEntry)
Reactions = Callable[[str, str], Wrench]
"""The wrench of a link on a joint, by joint and link."""
Seats = Sequence[tuple[Scalar, ...]]
"""The forces with which the seats of a joint press, each a number or the two parts of a vector (N)."""


class Resistance(NamedTuple):
    """An effort that follows from reactions: ``factor`` times the sum of the sizes of forces, and a ``rest``."""

    factor: Scalar
    rest: Scalar


class Use(NamedTuple):
    """An expression that an entry stands for without a field that holds it: the key where it is told, what it is."""

    key: str
    expression: Expression
    wanted: Wanted
    scope: Scope


class AskedTable(NamedTuple):
    """A table, or its integral, asked at an argument (bound to SI), such as ``Name("spring.length")``."""

    table: str
    argument: Node
    integral: bool = False


class Break(NamedTuple):
    """What changes its sign (bound to SI) where an element isn't smooth: its force jumps there, or has a kink."""

    node: Node
    jumps: bool


class Weight(NamedTuple):
    """A mass that a link carries: where its centre lies on the link, and its inertia about that; none unless given."""

    link: str
    mass: Expression
    at: str | Position
    inertia: Expression | None


class SignalLimits(NamedTuple):
    """The smallest and the greatest value (length) of a signal ``NAME.attribute`` that a part allows."""

    attribute: str
    edges: Two


class Between(NamedTuple):
    """What is drawn of an element: from a point of one link to a point of another, as a coil, or as barrel and rod."""

    links: Sequence[str]
    points: Sequence[str]
    look: Literal["coil", "strut"]


class SignalChart(NamedTuple):
    """A chart of one signal of all elements that have it: its text ``plot.title``, among which others it stands."""

    title: str
    group: Literal["motion", "force"]
    attribute: str


class Misfit(NamedTuple):
    """How far a reported force (N), or where it isn't a force a torque (N m), is from the one recomputed."""

    value: Array
    force: bool


class ForceContext(LinkPoses, Protocol):
    """What a kind asks for at a pose."""

    def value(self, expression: Expression, dimension: Dimension) -> Scalar:
        """An expression of the entry, in parameters, the time, tables and signals."""

    def lookup(self, table: str, argument: Node, integral: bool = False) -> Scalar:
        """The answer of a table among the kind's ``needed_tables``."""

    def signal(self, text: str) -> Scalar:
        """Another signal of the mechanism, among those on which the kind ``depends``."""

    def reaction(self, joint: str, link: str) -> Wrench:
        """The wrench of a link on a joint."""

    def touch(self, joint: str) -> Touch:
        """Where the links of a contact touch."""

    def effort(self, name: str) -> Scalar:
        """The effort of an element that ``resists``, solved together with the reactions."""

    def inside(self, window: str) -> Scalar:
        """Whether the pose lies in the window in which the element acts."""

    def turns(self, name: str) -> Scalar:
        """The whole turns of the kind's ``counted_angle``, to be added to the angle between the axes of its links."""


class ForceReports(MoverReports, Protocol):
    """What a run reports; its ``rows`` are the signals that the kind wants ``reported``, too."""

    def line(self, joint: str, link: str) -> tuple[Array, Array]:
        """Point and direction of a prismatic joint's line on one of its links."""

    def reaction(self, contact: Any) -> tuple[Array, Array | float]:
        """The reported force (N) of a contact's link on the other side, and its moment (N m)."""

    def touch(self, joint: str) -> ReportedTouch:
        """Where the links of a contact touch, and the force there."""

    def omega(self, link: str) -> Array:
        """A link's angular velocity (rad/s)."""

    def velocity(self, link: str, place: Array) -> Array:
        """The velocity of a link where it is at a place (m/s)."""

    def value(self, expression: Expression, dimension: Dimension) -> Array:
        """An expression in parameters, the time, tables and reported signals."""

    def table(self, name: str, argument: Array) -> Array:
        """What a table says of arguments; NaN outside of it."""

    def table_area(self, name: str, argument: Array) -> Array:
        """The integral of a table from its first point to arguments, by quadrature."""

    def inside(self, window: str) -> Array:
        """Whether a window holds."""


class ForceKind(ABC, Generic[E]):
    """A kind of what acts on links; stateless. ``name`` is that of an element in its section of the file.

    ``applied``, ``dissipative_forces`` and ``misfits`` are its proof: they know the model's dimensions and what a run
    reports, and ask none of the kind's other methods.
    """

    name: ClassVar[str]
    """As files have it, where it isn't the usual one of its section; that of its term ``kind-NAME``."""
    section: ClassVar[str]
    """Where its elements stand in a file: one of :data:`~linkwright.elements.entries.NOUNS`."""
    entry: ClassVar[type[ForceEntry]]
    """What a file says of one."""
    usual: ClassVar[bool] = False
    """Whether an entry of its section is of it that has no key of another kind."""
    acts: ClassVar[bool] = True
    """Whether it has wrenches; what only weighs has none."""
    stores: ClassVar[bool] = False
    """Whether it stores energy."""
    resists: ClassVar[bool] = False
    """Whether what it does follows from reactions, which it changes in turn: then its wrenches are an effort, of
    :meth:`resistance` times the sizes of :meth:`seats`, times :meth:`unit_wrenches`."""
    order: ClassVar[int] = 1
    """The derivatives of the motion that its wrenches need."""
    orders: ClassVar[Mapping[str, int]] = {}
    """The same of its signals, where they need others."""
    charts: ClassVar[Sequence[SignalChart]] = ()
    """How its signals are shown."""
    words: ClassVar[Mapping[str, Mapping[str, str]]] = {}
    """Texts that the catalogue lacks, by language and key; ``term.kind-NAME`` is what it is called."""

    def __reduce__(self) -> tuple[Any, ...]:
        return kind, (self.name,)

    @property
    def title(self) -> Term:
        """What it is called."""
        return Term(f"kind-{self.name}")

    # What a file says.

    def signals(self, entry: E) -> Mapping[str, Dimension]:
        """The attributes of ``NAME.`` with their dimensions (SI); elements that have some, or whole turns counted
        (:meth:`counted_angle`), share no name."""
        return {}

    def effort(self, entry: E) -> str:
        """The attribute that tells what it does; empty where none does."""
        return ""

    def faults(self, mechanism: Any, path: Path, entry: E) -> Iterator[Finding]:
        """What is wrong with the names of an entry that stands at a path, besides those that no element has."""
        yield from ()

    def implied_expressions(self, mechanism: Any, entry: E) -> Iterator[Use]:
        """Expressions that no field holds, such as a table as if it were called, which tells the units of its
        columns."""
        yield from ()

    def weighs(self, entry: E) -> Weight | None:
        """The mass that it adds to a link."""
        return None

    # What it needs of each pose.

    def laws(self, entry: E) -> tuple[tuple[Expression, Dimension], ...]:
        """Its expressions that may vary over the motion; where it follows the time in its own way, ``t`` is one."""
        return ()

    def window(self, entry: E) -> str | None:
        """The window outside of which it doesn't act."""
        return None

    def depends(self, name: str, entry: E) -> tuple[str, ...]:
        """Signals of other elements on which it depends, besides those in its laws."""
        return ()

    def needed_tables(self, name: str, entry: E) -> tuple[AskedTable, ...]:
        """The tables that it asks, besides those in its laws."""
        return ()

    def counted_angle(self, entry: E) -> tuple[str, str] | None:
        """The two links of the angle of which whole turns matter to it: that of the first against the second."""
        return None

    def start_angle(
        self, entry: E, value: Callable[[Expression, Dimension], Any], middle: Callable[[str], float]
    ) -> Any:
        """Where (rad) that angle starts, within half a turn; ``value`` gives its numbers, ``middle`` that of a table's
        arguments."""
        return 0.0

    def breaks(self, name: str, entry: E, bind: Callable[[Expression, Dimension], Node]) -> Iterator[Break]:
        """Where it isn't smooth, beyond the ends of its window, what its laws tell and the points of linear tables:
        expressions in its signals and numbers, which ``bind`` gives in SI."""
        yield from ()

    # What it does.

    def wrenches(self, context: ForceContext, name: str, entry: E) -> Iterator[tuple[str, Wrench]]:
        """What it does to each of its links: (link, wrench)."""
        yield from ()

    def at_start(self, entry: E) -> E:
        """The entry as it acts where motion is about to start from rest: itself, unless it resists more there."""
        return entry

    def rubs_in(self, entry: E) -> str:
        """Of one that ``resists`` the joint whose reactions it follows."""
        raise NotImplementedError

    def moment_faults(self, path: Path, entry: E, known: bool) -> Iterator[Finding]:
        """Of one that ``resists`` what is wrong where the moment of its joint's reaction is ``known``, or where not:
        in a loop of slides."""
        yield from ()

    def resistance(self, context: ForceContext, name: str, entry: E) -> Resistance:
        """Of one that ``resists``: how its effort (N or N m) follows from the sizes of its seats' forces."""
        raise NotImplementedError

    def seats(self, context: ForceContext, name: str, entry: E, reactions: Reactions) -> Seats:
        """The forces with which its seats press, linear in the reactions."""
        raise NotImplementedError

    def unit_wrenches(self, context: ForceContext, name: str, entry: E) -> Iterator[tuple[str, Wrench]]:
        """What an effort of 1 does to its links."""
        raise NotImplementedError

    def energy(self, context: ForceContext, name: str, entry: E) -> Scalar:
        """The energy stored (J): its wrenches' power is minus the rate of it, less what is lost."""
        return 0.0

    def signal(self, context: ForceContext, name: str, entry: E, attribute: str) -> Scalar:
        """One of its signals."""
        raise NotImplementedError

    def strength(self, context: ForceContext, name: str, entry: E) -> Scalar:
        """One number that changes as it acts, and is finite where it has a value: of its first link the force and the
        moment together."""
        _, first = next(iter(self.wrenches(context, name, entry)))
        return first.force.x + first.force.y + first.moment

    # The proof.

    def reported(self, entry: E) -> tuple[str, ...]:
        """The attributes of its own that the proof wants to know."""
        return ()

    def applied(self, reports: ForceReports, name: str, entry: E) -> list[Applied]:
        """What it does to its links."""
        return []

    def dissipative_forces(self, reports: ForceReports, name: str, entry: E) -> list[Applied]:
        """The part of that whose work isn't stored; all of it unless told otherwise."""
        return self.applied(reports, name, entry)

    def restated(self, reports: ForceReports, name: str, entry: E) -> Mapping[str, Restated]:
        """Its signals by attribute once more, from reported poses, velocities and reactions alone, each by another
        formula than :meth:`signal`'s."""
        return {}

    def stored(self, reports: ForceReports, name: str, entry: E) -> Array:
        """Of one that ``stores`` the energy (J) once more, by another formula than :meth:`energy`'s."""
        return np.full(reports.count, np.nan)

    def misfits(self, reports: ForceReports, name: str, entry: E) -> list[Misfit]:
        """By what its reported signals miss what the motion makes of them."""
        return []

    # What is told of it.

    def limits(self, entry: E) -> SignalLimits | None:
        """The values of a signal beyond which the part can't go; a run beyond has a warning."""
        return None

    def distance(self, entry: E) -> str:
        """The attribute that is a distance of two points along whose line it acts: it has no direction where they
        meet. Empty where there is none."""
        return ""

    def pull(self, entry: E) -> tuple[str, int] | None:
        """The attribute that is its force along the line of two points, and the sign in which that is told: 1 where it
        pulls, -1 where it pushes."""
        return None

    def outline(self, mechanism: Any, entry: E) -> Between | None:
        """What is drawn of it."""
        return None

    def sentence(self, name: str, entry: E, effort: float, shown: Callable[[float, Dimension], str]) -> Term | None:
        """What it is, for the reader; ``effort`` is the signal of that name at the start of the motion, ``shown`` gives
        a value (SI) with its unit."""
        return None


class Acting(NamedTuple):
    """An element that acts on links, or weighs: where it stands in the file, its entry and its kind."""

    section: str
    name: str
    entry: ForceEntry
    kind: ForceKind[Any]

    @property
    def path(self) -> tuple[str, str]:
        """Its place in the file."""
        return self.section, self.name

    @property
    def at_start(self) -> Acting:
        """The same where motion is about to start."""
        return self._replace(entry=self.kind.at_start(self.entry))

    @property
    def noun(self) -> str:
        """What it is called after its section."""
        return NOUNS[self.section]


FORCES: Registry[ForceKind[Any]] = Registry(of_contract("force"))
"""The kinds of what acts by name."""


def register(cls: type[ForceKind[Any]]) -> type[ForceKind[Any]]:
    """Register a kind under its name; a second one of the same name is an error."""
    FORCES[cls.name] = cls()
    make_known(cls.section, cls.name, None if cls.usual else cls.entry, cls.words)
    return cls


def kind(name: str) -> ForceKind[Any]:
    """A registered kind."""
    return FORCES[name]


def acting(mechanism: Any) -> Iterator[Acting]:
    """All elements that act on links or weigh, section by section."""
    for section in NOUNS:
        for name, entry in getattr(mechanism, section).items():
            yield Acting(section, name, entry, kind(entry.kind))
