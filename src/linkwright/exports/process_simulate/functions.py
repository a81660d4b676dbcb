"""The joint functions of a mechanism: made, written with as many decimals as they want, and proven on their text."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import field, replace
from functools import partial

import numpy as np

from linkwright.data_classes import dataclass
from linkwright.exports.process_simulate import evaluator
from linkwright.exports.process_simulate.angles import linkage
from linkwright.exports.process_simulate.dialects import DIALECTS, Dialect
from linkwright.exports.process_simulate.fitting import fit
from linkwright.exports.process_simulate.followers import followers
from linkwright.exports.process_simulate.joints import ToolJoint, driving, joints_of, named
from linkwright.exports.process_simulate.linkage import MM, Linkage, Refused, shared_pin
from linkwright.exports.process_simulate.masters import mastered
from linkwright.exports.process_simulate.mirror import Mirror
from linkwright.exports.process_simulate.motion import ToolMotion
from linkwright.exports.process_simulate.printer import text
from linkwright.exports.process_simulate.reach import drive_reach
from linkwright.exports.process_simulate.splitting import least, split
from linkwright.exports.process_simulate.trees import Array, Tree, evaluate, multiply, number
from linkwright.exports.process_simulate.trees import joint as joint_value
from linkwright.findings import Finding, Joined
from linkwright.graph.geometry import Geometry
from linkwright.kernels import Compiled
from linkwright.kernels.laws import values_at
from linkwright.structure import HigherGroup

DESIGNED, PROVEN = 720, 2000
"""Steps over the range when functions are made, and when they are proven."""
CLOSE = 1e-8
"""How close a text must come to the solver (rad or mm)."""
DIGITS = 1e-11
"""The same of slides over the mechanism's size, where that is more."""
FINEST = 15
"""The most decimals."""
OFFERED = 1e-6
"""The error (rad or mm) of the polynomials that are offered for a group without a closed form."""
TIGHTER = 6
"""How often polynomials are made tighter until what is made of them comes as close as is wanted."""
MOST = 64
"""The most joints that the tool's functions know."""
PATH = ("exports", "process-simulate")


@dataclass(frozen=True)
class JointFunction:
    """A joint as the tool has it: ``joint`` its name in the model, ``name`` in the tool.

    ``kind`` is ``T`` (turns, rad) or ``D`` (slides, mm); its value is the turn or slide of the link ``child`` against
    ``parent`` since the zero pose, times ``sign``. ``text`` is empty for the driving joint, ``error`` the largest
    difference from the solver over the range, ``limits`` the least and largest value. A helper has no links.
    ``mirrored`` is a joint of the second of two hinges that mirror each other.
    """

    joint: str
    name: str
    kind: str
    text: str
    limits: tuple[float, float]
    error: float
    parent: str
    child: str
    sign: float = 1.0
    mirrored: bool = False

    @property
    def helper(self) -> bool:
        """Whether it is no joint of the mechanism but stands for a part of a long function."""
        return not self.child


@dataclass(frozen=True)
class JointFunctions:
    """The functions in the order in which they ask for one another. ``range`` is that of the drive, ``zero`` its value
    at the zero pose (rad or m); ``fitted`` whether polynomials stand for what has no closed form; ``follower`` the
    joint of the second of two hinges that follows the driving one of the first."""

    driving: JointFunction
    functions: tuple[JointFunction, ...]
    dialect: str
    decimals: int
    range: tuple[float, float]
    max_error: float
    zero: float
    motion: ToolMotion
    fitted: bool = False
    warnings: tuple[Finding, ...] = ()
    follower: str | None = None


@dataclass(frozen=True)
class Wish:
    """What is asked for.

    ``master`` is the driving joint, else the one that the drive moves. ``zero`` and ``window`` are values of the drive
    (rad or m); in place of a window, ``stops`` are those of the driving joint since the zero pose, as the tool counts
    it (rad or m). ``longest`` is the length of a text, ``approximate``
    the error (rad or mm) of polynomials for groups without a closed form.
    """

    drive: str
    dialect: str = "seed"
    zero: float | None = None
    window: tuple[float, float] | None = None
    stops: tuple[float, float] | None = None
    decimals: int = 9
    names: Mapping[str, str] = field(default_factory=dict)
    flipped: tuple[str, ...] = ()
    left_out: tuple[str, ...] = ()
    longest: int | None = None
    approximate: float | None = None
    master: str | None = None
    mirror: Mirror | None = None


def make(compiled: Compiled, wish: Wish) -> JointFunctions:
    """The joint functions. Raises :class:`Refused` where there are none."""
    joints = named(joints_of(compiled.structure), wish.names, wish.flipped, wish.left_out)
    motion, warnings = _motion(compiled, wish, joints)
    make_side = partial(_make_functions, compiled, wish)
    made = make_side(joints, motion) if wish.mirror is None else _both(wish.mirror, make_side, joints, motion)
    return replace(made, warnings=tuple(warnings))


def _both(
    mirror: Mirror,
    make_side: Callable[[list[ToolJoint], ToolMotion], JointFunctions],
    joints: list[ToolJoint],
    motion: ToolMotion,
) -> JointFunctions:
    """The functions of two hinges: those of each in its own joints; the second one's driving joint follows the first
    one's."""
    sides = [mirror.side(joints, second) for second in (False, True)]
    drivers = [next(j for j in side if j.joint == motion.joint.joint) for side in sides]
    way = drivers[0].sign * drivers[1].sign
    motions = [replace(motion, joint=drivers[0]), replace(motion, joint=drivers[1], sign=way * motion.sign)]
    first, second = map(make_side, sides, motions)
    (driver, follower), names = drivers, {drivers[0].joint: drivers[0].name}
    tree = multiply(number(way), joint_value(driver.kind, driver.joint))
    linked = replace(second.driving, text=text(tree, DIALECTS[first.dialect], names, first.decimals))
    functions = (*first.functions, *(replace(f, mirrored=True) for f in (linked, *second.functions)))
    _limited(len(functions) + 1)
    motions[0].told += [follower, *motions[1].told]
    return replace(
        first,
        functions=functions,
        decimals=max(first.decimals, second.decimals),
        max_error=max(first.max_error, second.max_error),
        follower=follower.name,
    )


def _limited(count: int) -> None:
    """Raise :class:`Refused` for more joints than the tool's functions know."""
    if count > MOST:
        raise Refused(Finding("functions.too-many", PATH, {"count": count, "limit": MOST}))


def _make_functions(compiled: Compiled, wish: Wish, joints: list[ToolJoint], motion: ToolMotion) -> JointFunctions:
    if wish.approximate is None:
        links, fits = _links(compiled, wish, joints, motion, OFFERED)
        if not fits:
            return _TextSearch(compiled, wish, links, motion, fitted=False).shortest_functions()
        found = _TextSearch(compiled, replace(wish, longest=None), links, motion, fitted=True).shortest_functions()
        raise Refused(_no_closed_form(fits, found.max_error, wish.drive))
    for tighter in range(TIGHTER):  # joints that follow as sums of others add up their errors
        links, fits = _links(compiled, wish, joints, motion, wish.approximate / 8**tighter)
        found = _TextSearch(compiled, wish, links, motion, bool(fits)).shortest_functions()
        if not fits or found.max_error <= wish.approximate:
            return found
    raise Refused(_no_closed_form(fits, found.max_error, wish.drive))


def _motion(compiled: Compiled, wish: Wish, joints: list[ToolJoint]) -> tuple[ToolMotion, list[Finding]]:
    """The motion over the range, with the tool's driving joint, and warnings on it."""
    of, moved, on = driving(compiled.structure, wish.drive)
    joint = next((j for j in joints if j.of == of and {j.parent, j.child} == {moved, on}), None)
    master = joint if wish.master is None else next(j for j in joints if j.joint == wish.master)
    if master is None:
        raise Refused(shared_pin(wish.drive, of))
    sign, window, stops = master.sign * (1.0 if master.child == moved else -1.0), wish.window, None
    if wish.stops is not None and master == joint:
        zero = float(values_at(compiled.laws, 0.0)[wish.drive]) if wish.zero is None else wish.zero
        ends = sorted(zero + sign * stop for stop in wish.stops)
        window, stops = (ends[0], ends[1]), (master.name, sign)
    found = drive_reach(compiled, wish.drive, wish.zero, window, stops)
    if isinstance(found, Finding):
        raise Refused(found)
    if master == joint:
        return ToolMotion(compiled, wish.drive, found, master, sign), []
    unit = MM if master.kind == "D" else 1.0
    own = None if wish.stops is None else (unit * wish.stops[0], unit * wish.stops[1])
    return mastered(compiled, wish.drive, joints, master, found, window is not None, own)


def _links(
    compiled: Compiled, wish: Wish, joints: list[ToolJoint], motion: ToolMotion, close: float
) -> tuple[Linkage, list[tuple[HigherGroup, int]]]:
    """All functions as trees, and the higher groups with the degrees of the polynomials that come ``close`` (rad or
    mm), if that can be, to their joints."""
    poses, fits = motion.poses(DESIGNED), list[tuple[HigherGroup, int]]()

    def joint_motion(joint: ToolJoint) -> tuple[Array, float]:
        return motion.values([joint], poses)[0], motion.at_zero(joint)

    def fitted(links: Linkage, higher_group: HigherGroup) -> None:
        fits.append((higher_group, fit(links, higher_group, motion.joint, joint_motion, close)))

    geometry = Geometry(compiled.quantities, compiled.quantities.parameters)
    structure, branches = motion.solved
    links = linkage(
        structure, geometry, branches, joints,
        DIALECTS[wish.dialect], wish.drive, motion.origin, poses, fitted, followers(motion),
    )  # fmt: skip
    return links, fits


def _no_closed_form(fits: list[tuple[HigherGroup, int]], error: float, drive: str) -> Finding:
    """The finding on the first higher group, with the largest error of all functions."""
    higher_group, degree = fits[0][0], max(degree for _, degree in fits)
    data = {"links": Joined(higher_group.links), "group": higher_group.signature, "drive": drive}
    return Finding(
        "functions.no-closed-form",
        ("links", higher_group.links[0]),
        data | {"degree": degree, "error": f"{error:.2g}", "approximate": f"{max(1.1 * error, OFFERED):.2g}"},
    )


class _TextSearch:
    """Trees to proven texts."""

    def __init__(self, compiled: Compiled, wish: Wish, links: Linkage, motion: ToolMotion, fitted: bool) -> None:
        self.compiled, self.wish, self.links, self.motion, self.fitted = compiled, wish, links, motion, fitted
        self.dialect: Dialect = DIALECTS[wish.dialect]
        self.names = {j.joint: j.name for j in links.joints}
        self.by_joint = {j.joint: j for j in links.joints}
        self.poses = motion.poses(PROVEN)
        self.told = motion.told = [self.by_joint[name] for name in links.functions]
        self.expected = motion.values(self.told, self.poses)
        far = max(CLOSE, DIGITS * MM * compiled.assembly.size())
        self.close = np.array([CLOSE if j.kind == "T" else far for j in self.told])

    def shortest_functions(self) -> JointFunctions:
        """With the fewest decimals that keep the error."""
        best: tuple[float, int, dict[str, str], Array] | None = None
        for decimals in range(self.wish.decimals, FINEST + 1):
            texts = self.texts(decimals)
            values = self.evaluated(texts)
            own = [list(texts).index(j.joint) for j in self.told]
            with np.errstate(invalid="ignore"):
                off = np.abs(values[own] - self.expected).max(axis=1, initial=0.0)
            off = np.where(np.isnan(off), np.inf, off)
            worst = float(np.max(off / self.close, initial=0.0))
            if best is None or worst < best[0]:
                best = worst, decimals, texts, values
            if worst <= 1 or self.fitted:
                break
        assert best is not None
        if best[0] > 1 and not (self.fitted and math.isfinite(best[0])):
            unit, size = self.compiled.quantities.drive_unit(self.wish.drive)
            off = np.nan_to_num(np.abs(best[3][own] - self.expected), nan=np.inf)
            row = int((off / self.close[:, None]).max(axis=0).argmax())
            at = float(self.motion.to_drive(self.poses[row : row + 1])[0])
            data = {
                "error": f"{float(off[:, row].max()):.2g}",
                "at": f"{at / size:.6g}",
                "unit": unit,
                "drive": self.wish.drive,
            }
            raise Refused(Finding("functions.error", (*PATH, "range"), data))
        return self.gathered(*best[1:])

    def texts(self, decimals: int) -> dict[str, str]:
        """The texts by joint, split where they have to be."""
        functions = self.links.functions
        names = dict(self.names)

        def tree_text(tree: Tree) -> str:
            named = names | {t.name: t.name for t in tree.every() if t.name and t.name not in names}
            return text(tree, self.dialect, named, decimals)

        if self.wish.longest is None:
            return {joint: tree_text(tree) for joint, tree in functions.items()}
        kit = (lambda tree: len(tree_text(tree)), self.start, self.helper)
        made = split(functions, self.wish.longest, *kit)
        if made is None:
            data = {"longest": self.wish.longest, "least": least(functions, self.wish.longest, *kit)}
            raise Refused(Finding("functions.length", (*PATH, "longest"), data))
        return {joint: tree_text(tree) for joint, tree in made.items()}

    def start(self, tree: Tree) -> float:
        """The value of a tree at the zero pose, where all joints are 0."""
        zeros = {t.name: np.zeros(1) for t in tree.every() if t.name}
        return float(np.broadcast_to(evaluate(tree, zeros), 1)[0])

    def helper(self, of: str, count: int) -> str:
        """The name of a helper that isn't taken."""
        name = f"{self.names.get(of, of)}_{count}"
        while name in self.names.values():
            name += "_"
        return name

    def evaluated(self, texts: Mapping[str, str]) -> Array:
        """The values that the texts give, each with those of the joints before it: (joints, poses)."""
        kinds = {self.names.get(j, j): self.by_joint[j].kind if j in self.by_joint else "D" for j in texts}
        kinds[self.motion.joint.name] = self.motion.joint.kind
        listed = [(self.names.get(joint, joint), shown) for joint, shown in texts.items()]
        return evaluator.evaluate(listed, self.dialect.name, kinds, self.motion.joint.name, self.poses)

    def gathered(self, decimals: int, texts: Mapping[str, str], values: Array) -> JointFunctions:
        low, high = self.motion.limits
        inside = (self.poses >= low) & (self.poses <= high)
        row, functions = partial(dict.get, dict(zip((j.joint for j in self.told), self.expected, strict=True))), []
        for (joint, shown), got in zip(texts.items(), values, strict=True):
            own, expected = self.by_joint.get(joint), row(joint)
            limits = _value_range(got[inside] if expected is None else expected[inside])
            error = 0.0 if expected is None else float(np.abs(got - expected).max())
            links = ("", "") if own is None else (own.parent, own.child)
            kind, sign = ("D", 1.0) if own is None else (own.kind, own.sign)
            functions.append(
                JointFunction(joint, self.names.get(joint, joint), kind, shown, limits, error, *links, sign)
            )
        _limited(len(functions) + 1)
        j = self.motion.joint
        moving = JointFunction(j.joint, j.name, j.kind, "", (low, high), 0.0, j.parent, j.child, j.sign)
        r, worst = self.motion.reach, max((f.error for f in functions), default=0.0)
        return JointFunctions(
            moving,
            tuple(functions),
            self.dialect.name,
            decimals,
            (r.low, r.high),
            worst,
            r.zero,
            self.motion,
            self.fitted,
        )


def _value_range(values: Array) -> tuple[float, float]:
    """The least and the largest value; between neighbours of the extreme one, that of the parabola through them."""

    def largest(y: Array) -> float:
        k = int(y.argmax())
        if 0 < k < y.size - 1:
            rise, bend = (y[k + 1] - y[k - 1]) / 2, y[k + 1] - 2 * y[k] + y[k - 1]
            if bend < 0:
                return float(y[k] - rise * rise / (2 * bend))
        return float(y[k])

    return -largest(-values), largest(values)
