"""A small valid mechanism for every registered kind of element, as text of a model file.

All have a link ``crank``, pinned to the frame at A, which a drive turns through any angle, and a parameter with a
tolerance, most often its length r: the columns (:mod:`combinations.columns`) drive, vary, copy and export every
mechanism in the same way. A kind that is registered and has no mechanism here fails
``test_every_kind_has_a_mechanism`` by name.
"""

from __future__ import annotations

import copy
from dataclasses import dataclass
from functools import cached_property
from typing import Any

from ruamel.yaml import YAML

from combinations.trunks import CAM, FOUR_BAR, HEAD, SLIDER_CRANK, TAPPET, TWO_WHEELS

Data = dict[str, Any]


@dataclass(frozen=True)
class Mechanism:
    """A row of the matrix: the kinds that it is there for, its sections as text (what is ``added`` joins those of the
    text), the signal of its output with the link or slide that an ``output`` of a drive names, the motor's angle at the
    start (deg), the radius of the crank (mm), and
    whether a constant is that of the drawn pose (``drawn``); ``circling`` are elements whose travel is
    counter-clockwise along an arc, so that it has the other sign in a mirror; ``varied`` is the
    parameter that studies vary."""

    kinds: tuple[str, ...]
    text: str
    added: str = ""
    signal: str = "rocker.angle"
    start: int = 60
    radius: float = 30.0
    drawn: bool = False
    circling: tuple[str, ...] = ()
    varied: str = "r"

    @cached_property
    def _data(self) -> Data:
        data: Data = {"linkwright": 1, **_read(HEAD), **_read(self.text)}
        for section, entries in _read(self.added).items():
            data[section] = _joined(data.get(section, {}), entries)
        return data

    @property
    def data(self) -> Data:
        """Its sections, without the motor, for changes."""
        return copy.deepcopy(self._data)

    @property
    def nominal(self) -> float:
        """The value of the varied parameter (mm)."""
        return float(self._data["parameters"][self.varied]["value"])

    @property
    def output(self) -> str:
        """The link or slide that is its output."""
        return self.signal.partition(".")[0]


def add_to_frame(data: Data, point: str, place: list[float]) -> None:
    """Add a point of the frame, or of the sketch where there is one."""
    points = data["links"]["frame"]["points"]
    if isinstance(points, list):
        points.append(point)
        data["sketch"][point] = place
    else:
        points[point] = place


def _read(text: str) -> Data:
    data: Data = YAML(typ="safe").load(text) or {}
    return data


def _joined(before: Any, more: Any) -> Any:
    """Mappings one within the other."""
    if not (isinstance(before, dict) and isinstance(more, dict)):
        return more
    return {**before, **{key: _joined(before.get(key), value) for key, value in more.items()}}


MECHANISMS: dict[str, Mechanism] = {
    "pin": Mechanism(
        ("revolute",),
        """
parameters: {r: {value: 30, tolerance: 0.05}}
links:
  frame:   {points: {A: [0, 0], D: [100, 0]}}
  crank:   {points: {A: [0, 0], B: [r, 0]}, mass: 0.5, shape: rod A-B}
  coupler: {points: {B: [0, 0], C: [90, 0]}, mass: 0.8, com: [45, 5], inertia: 900}
  rocker:  {points: {D: [0, 0], K: [70, 0]}, mass: 0.6, shape: rod D-K}
joints: {J: {revolute: [coupler, rocker], at: [C, K]}}
assembly: {J: left of B-D}
""",
    ),
    "slide": Mechanism(("prismatic",), SLIDER_CRANK, signal="guide.s"),
    "belt": Mechanism(
        ("belt",),
        TWO_WHEELS,
        "joints: {tie: {belt: [crank, wheel], centres: [A, Q], radii: [20, 40], pretension: 300 N}}",
        signal="wheel.angle",
        drawn=True,
    ),
    "crossed belt": Mechanism(
        ("belt",),
        TWO_WHEELS,
        "joints: {tie: {belt: [crank, wheel], centres: [A, Q], teeth: [20, 30], pitch: 5 mm, crossed: true}}",
        signal="wheel.angle",
        drawn=True,
    ),
    "gears": Mechanism(
        ("gears",),
        TWO_WHEELS,
        "joints: {mesh: {gears: [crank, wheel], centres: [A, Q], teeth: [20, 40], module: 4 mm}}",
        signal="wheel.angle",
        drawn=True,
    ),
    "ring gear": Mechanism(
        ("gears",),
        TWO_WHEELS,
        "joints: {mesh: {gears: [crank, wheel], internal: wheel, centres: [A, Q], radii: [60, 180]}}",
        signal="wheel.angle",
        drawn=True,
    ),
    "rack": Mechanism(
        ("rack",),
        SLIDER_CRANK,
        """
links:
  frame:  {points: {M: [120, 33]}}
  slider: {points: {G: [20, 0]}}
  pinion: {points: {M: [0, 0], T: [0, 50]}, mass: 1, shape: rod M-T}
joints: {mesh: {rack: [pinion, slider], centre: M, pitch_line: G at 0 deg, teeth: 20, module: 2.5 mm}}
assembly: {C: [105, 8], T: [120, 83]}
""",
        signal="pinion.angle",
        drawn=True,
    ),
    "rolling": Mechanism(
        ("rolling",),
        """
parameters: {r: {value: 30, tolerance: 0.05}}
links:
  frame: {points: {A: [0, 0], G: [200, -40]}}
  crank: {points: {A: [0, 0], B: [r, 0]}, mass: 0.5, shape: rod A-B}
  rod:   {points: {B: [0, 0], C: [120, 0]}, mass: 0.8, shape: rod B-C}
  wheel: {points: {C: [0, 0], T: [0, 40]}, mass: 4, shape: disc 40 mm at C}
joints: {ground: {rolling: [wheel, frame], centre: C, radius: 40, on_line: G at 0 deg}}
assembly: {C: [130, 0], T: [130, 40]}
""",
        signal="wheel.angle",
        drawn=True,
    ),
    "rolling inside": Mechanism(
        ("rolling",),
        """
parameters: {r: {value: 30, tolerance: 0.05}}
links:
  frame: {points: {A: [0, 0], Q: [130, 0]}}
  crank: {points: {A: [0, 0], B: [r, 0]}, mass: 0.5, shape: rod A-B}
  rod:   {points: {B: [0, 0], C: [120, 0]}, mass: 0.8, shape: rod B-C}
  wheel: {points: {C: [0, 0], T: [0, 20]}, mass: 2, shape: disc 20 mm at C}
joints: {ring: {rolling: [wheel, frame], centre: C, radius: 20, on_circle: {centre: Q, radius: 100, inside: true}}}
assembly: {C: [115, -79], T: [115, -59]}
""",
        signal="wheel.angle",
        drawn=True,
    ),
    "differential": Mechanism(
        ("differential",),
        FOUR_BAR,
        """
links:
  frame: {points: {Q: [0, -100]}}
  wheel: {points: {Q: [0, 0], T: [40, 0]}, mass: 1, shape: rod Q-T}
joints: {sum: {differential: [wheel, crank, rocker], weights: [2, -1, -1]}}
assembly: {B: [15, 26], C: [93, 69], T: [40, -100]}
""",
        signal="wheel.angle",
        drawn=True,
    ),
    "straight slot": Mechanism(
        ("pin_in_slot",),
        """
parameters: {r: {value: 30, tolerance: 0.05}}
links:
  frame: {points: {A: [0, 0], Q: [-80, 0]}}
  crank: {points: {A: [0, 0], B: [r, 0]}, mass: 0.5, shape: rod A-B}
  lever: {points: {Q: [0, 0], T: [140, 0]}, mass: 1, shape: rod Q-T}
joints: {slot: {pin_in_slot: [crank, lever], pin: B, straight: Q at 0 deg}}
assembly: {T: [40, 40]}
""",
        signal="lever.angle",
    ),
    "curved slot": Mechanism(
        ("pin_in_slot",),
        """
parameters: {r: {value: 30, tolerance: 0.05}}
links:
  frame: {points: {A: [0, 0], Q: [-80, 0]}}
  crank: {points: {A: [0, 0], B: [r, 0]}, mass: 0.5, shape: rod A-B}
  lever: {points: {Q: [0, 0], T: [140, 0]}, mass: 1, shape: rod Q-T}
joints: {slot: {pin_in_slot: [crank, lever], pin: B, curve: {along: Q at 0 deg, through: [[40, 0], [80, 6], [120, 0]]}}}
assembly: {T: [40, 40]}
""",
        signal="lever.angle",
    ),
    "arc slot": Mechanism(
        ("pin_in_slot",),
        """
parameters: {r: {value: 30, tolerance: 0.05}}
links:
  frame: {points: {A: [0, 0], Q: [-80, 0]}}
  crank: {points: {A: [0, 0], B: [r, 0]}, mass: 0.5, shape: rod A-B}
  lever: {points: {Q: [0, 0], T: [140, 0], M: [80, -150]}, mass: 1, shape: rod Q-T}
joints: {slot: {pin_in_slot: [crank, lever], pin: B, arc: {centre: M, radius: 150, start: 90 deg}}}
assembly: {T: [40, 40]}
""",
        signal="lever.angle",
        circling=("slot.",),
    ),
    "bar on two slots": Mechanism(
        ("floating_angle", "floating_x", "floating_y"),
        """
parameters: {r: {value: 30, tolerance: 0.05}}
links:
  frame: {points: {A: [0, 0], U: [0, 90], V: [150, 0]}}
  crank: {points: {A: [0, 0], B: [r, 0]}, mass: 0.5, shape: rod A-B}
  rod:   {points: {B: [0, 0], P1: [170, 0]}, mass: 0.4, shape: rod B-P1}
  bar:   {points: {P1: [0, 0], P2: [160, 0]}, mass: 1, shape: rod P1-P2}
joints:
  upper: {pin_in_slot: [bar, frame], pin: P1, straight: U at 0 deg}
  lower: {pin_in_slot: [bar, frame], pin: P2, straight: V at 60 deg}
assembly: {P1: [172, 90], P2: [116, -60]}
""",
        signal="bar.angle",
    ),
    "angle of links that share no pin": Mechanism(
        ("prescribed_angle",),
        """
parameters: {r: {value: 30, tolerance: 0.05}}
links:
  frame:   {points: {A: [0, 0], D: [100, 0]}}
  crank:   {points: {A: [0, 0], B: [r, 0]}, mass: 0.5, shape: rod A-B}
  coupler: {points: {B: [0, 0], C: [40, 0]}, mass: 0.8, shape: rod B-C}
  rod:     {points: {C: [0, 0], E: [80, 0]}, mass: 0.8, shape: rod C-E}
  rocker:  {points: {D: [0, 0], E: [70, 0]}, mass: 0.6, shape: rod D-E}
drives: {tilt: {turns: coupler, on: frame, position: 20 deg}}
assembly: {E: left of C-D, C: [70, 35]}
""",
    ),
    "place along a line": Mechanism(
        ("prescribed_place",),
        """
parameters: {r: {value: 30, tolerance: 0.05}}
links:
  frame:   {points: {A: [0, 0], D: [100, 0]}}
  crank:   {points: {A: [0, 0], B: [r, 0]}, mass: 0.5, shape: rod A-B}
  coupler: {points: {B: [0, 0], C: [60, 0]}, mass: 0.8, shape: rod B-C}
  rod:     {points: {C: [0, 0], E: [80, 0]}, mass: 0.8, shape: rod C-E}
  rocker:  {points: {D: [0, 0], E: [70, 0]}, mass: 0.6, shape: rod D-E}
drives: {raise: {moves: coupler, at: C, along: A at 90 deg, on: frame, position: 15}}
assembly: {C: [70, 15], E: [120, 60]}
""",
    ),
    "cam with roller": Mechanism(
        ("cam",),
        CAM,
        """
cams:
  lifting: {cam: crank, follower: lever, on: frame, base: 40,
            roller: 12, at: C, law: lift, side: left of A-Q, sense: counter-clockwise}
""",
        signal="lever.angle",
    ),
    "cam with edge": Mechanism(
        ("cam",),
        TAPPET,
        """
cams:
  lifting: {cam: crank, follower: tappet, on: frame, base: 40,
            knife: C, law: lift, sense: counter-clockwise}
""",
        signal="guide.s",
    ),
    "groove cam": Mechanism(
        ("cam",),
        TAPPET,
        """
cams:
  lifting: {cam: crank, follower: tappet, on: frame, base: 40,
            roller: 10, at: C, law: lift, closed: groove, sense: counter-clockwise}
""",
        signal="guide.s",
    ),
    "coupling": Mechanism(
        ("coupling",),
        TWO_WHEELS,
        "joints: {tie: {coupling: [wheel, frame], follows: 0.5*motor.angle + 10 deg*sin(motor.angle)}}",
        signal="wheel.angle",
    ),
    "Geneva drive": Mechanism(
        ("geneva",),
        """
parameters: {c: {value: 100, tolerance: 0.05}, r: c*sin(45 deg)}
links:
  frame: {points: {A: [0, 0], Q: [c, 0]}}
  crank: {points: {A: [0, 0], B: [r, 0]}, mass: 1.5, shape: disc 60 mm at A}
  wheel: {points: {Q: [0, 0], T: [0, 55]}, mass: 6, shape: disc 150 mm at Q}
joints: {indexing: {geneva: [crank, wheel], centres: [A, Q], pins: [B], slots: 4, arc: 50}}
""",
        signal="wheel.angle",
        start=-40,
        radius=70.71067811865476,
        varied="c",
    ),
    "weld": Mechanism(
        ("weld",),
        FOUR_BAR,
        """
links: {bracket: {points: {E: [0, 0], T: [40, 0]}, mass: 0.3, shape: rod E-T}}
joints: {seam: {weld: [bracket, coupler], angle: 40 deg}}
""",
    ),
    "load at a point": Mechanism(
        ("load",), FOUR_BAR, "loads: {cut: {on: coupler, at: E, force: [5, -20], in: coupler}}"
    ),
    "load between links": Mechanism(
        ("load",), FOUR_BAR, "loads: {brake: {on: rocker, against: coupler, torque: -0.5*sin(crank.angle)}}"
    ),
    "spring": Mechanism(
        ("spring",),
        FOUR_BAR,
        "springs: {pull: {from: D, to: B, stiffness: 2 N/mm, free: 60, damping: 0.01 N*s/mm}}",
    ),
    "torsion spring": Mechanism(
        ("spring",), FOUR_BAR, "springs: {hold: {turns: rocker, on: frame, stiffness: 5 N*m/rad, free: 90 deg}}"
    ),
    "counterweight": Mechanism(
        ("counterweight",), FOUR_BAR, "counterweights: {cw: {on: crank, mass: 1.2, at: 40 at 180 deg, inertia: 400}}"
    ),
    "friction in a pin": Mechanism(
        ("friction",),
        FOUR_BAR,
        "friction: {bearing: {pin: C, radius: 8 mm, coefficient: 0.1, viscous: 0.001 N*m*s/rad}}",
    ),
    "friction in a slide": Mechanism(
        ("friction",),
        SLIDER_CRANK,
        "friction: {rub: {slide: guide, length: 40 mm, coefficient: 0.1, static: 0.15}}",
        "guide.s",
    ),
    "cylinder": Mechanism(
        (),
        FOUR_BAR,
        """
links: {frame: {points: {S: [40, -60]}}}
cylinders: {strut: {from: S, to: C, barrel: {mass: 0.4, com: 30}, rod: {mass: 0.3, com: 30}}}
""",
    ),
    "group solved by Newton": Mechanism(
        (),
        """
parameters: {r: {value: 30, tolerance: 0.05}}
links:
  frame:  {points: {A: [0, 0], D: [227, -83], F: [181, -108]}}
  crank:  {points: {A: [0, 0], B: [r, 0]}, mass: 0.5, shape: rod A-B}
  plate:  {points: {C: [0, 0], E: [100, 0], G: [50, -60]}, mass: 0.8, com: [50, -20], inertia: 900}
  rod:    {points: {B: [0, 0], C: [126, 0]}, mass: 0.4, shape: rod B-C}
  rocker: {points: {D: [0, 0], E: [98, 0]}, mass: 0.6, shape: rod D-E}
  strut:  {points: {F: [0, 0], G: [108, 0]}, mass: 0.3, shape: rod F-G}
assembly: {C: [133, 70], E: [216, 14], G: [141, -8]}
""",
    ),
    "cam with flat face": Mechanism(
        ("cam",),
        TAPPET,
        """
cams:
  lifting: {cam: crank, follower: tappet, on: frame, base: 60,
            face: C at 0 deg, law: lift, sense: counter-clockwise}
""",
        signal="guide.s",
    ),
    "conjugate cams": Mechanism(
        ("cam",),
        CAM,
        """
cams:
  lifting: {cam: crank, follower: lever, on: frame, base: 40,
            roller: 12, at: C, law: lift, side: left of A-Q, sense: counter-clockwise,
            closed: conjugate, second: {at: K}}
""",
        signal="lever.angle",
    ),
    "cam with yoke": Mechanism(
        ("cam",),
        TAPPET.replace("G: [4, 0]", "G: [0, 0]"),
        """
cams:
  lifting: {cam: crank, follower: tappet, on: frame, base: 60,
            face: C at 0 deg, law: lift, closed: yoke, sense: counter-clockwise}
""",
        signal="guide.s",
    ),
    "load along a slide": Mechanism(
        ("load",),
        SLIDER_CRANK,
        "loads: {press: {on: slider, at: C, along: guide, force: -50 - 3 N*s/m*guide.v}}",
        "guide.s",
    ),
    "load in a window": Mechanism(
        ("load",),
        FOUR_BAR,
        "windows: {early: {motor.angle: [70 deg, 100 deg]}}\n"
        "loads: {cut: {on: rocker, at: C, force: [0, -20], window: early}}",
    ),
    "load by a table": Mechanism(
        ("load",),
        FOUR_BAR,
        "tables: {curve: {points: [[0, 0], [120, 40], [360, 0]], period: 360, between: linear}}\n"
        "loads: {cut: {on: rocker, at: C, force: [0, -curve(motor.angle)]}}",
    ),
    "gas spring": Mechanism(
        ("spring",), FOUR_BAR, "springs: {lift: {from: D, to: B, gas: 100 N, progression: 1.3, length: [60, 140]}}"
    ),
    "spring by a table": Mechanism(
        ("spring",),
        FOUR_BAR,
        "tables: {curve: {points: [[50, 0], [80, 30], [110, 50], [150, 120]]}}\n"
        "springs: {wire: {from: D, to: B, force: curve}}",
    ),
    "friction in a contact": Mechanism(
        ("friction",),
        """
parameters: {r: {value: 30, tolerance: 0.05}}
links:
  frame: {points: {A: [0, 0], Q: [-80, 0]}}
  crank: {points: {A: [0, 0], B: [r, 0]}, mass: 0.5, shape: rod A-B}
  lever: {points: {Q: [0, 0], T: [140, 0]}, mass: 1, shape: rod Q-T}
joints: {slot: {pin_in_slot: [crank, lever], pin: B, straight: Q at 0 deg}}
friction: {rub: {contact: slot, coefficient: 0.1}}
assembly: {T: [40, 40]}
""",
        signal="lever.angle",
    ),
    "sketch": Mechanism(
        (),
        """
sketch: {A: [0, 0], B: [15, 26], C: [90, 75], D: [100, 0]}
parameters: {r: {value: 30, tolerance: 0.05}}
links:
  frame:   {points: [A, D]}
  crank:   {points: {A: [0, 0], B: [r, 0]}, mass: 0.5, shape: rod A-B}
  coupler: {points: [B, C], mass: 0.8, shape: rod B-C}
  rocker:  {points: [D, C], mass: 0.6, shape: rod D-C}
""",
    ),
}
