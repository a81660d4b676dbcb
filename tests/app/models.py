"""Model files for the tests of what the commands do: one that is sound, and one for each kind of fault."""

from __future__ import annotations

SOUND = """\
linkwright: 1
name: Four-bar
units: {length: mm, angle: deg, mass: kg, time: s, force: N, torque: N*m}
gravity: [0, -9.80665 m/s^2]
parameters: {a: 40, b: 120, c: 80, d: 100}
links:
  frame:   {points: {O2: [0, 0], O4: [d, 0]}}
  crank:   {points: {O2: [0, 0], A: [a, 0]}, mass: 0.2, shape: rod O2-A}
  coupler: {points: {A: [0, 0], B: [b, 0], P: 70 at 30 deg}, mass: 0.5, com: [55, 10], inertia: 650}
  rocker:  {points: {O4: [0, 0], B: [c, 0]}, mass: 0.3, shape: rod O4-B}
assembly: {B: left of A-O4}
drives:
  motor: {turns: crank, on: frame, speed: 120 rpm, start: 40 deg}
measures:
  swing: {span: rocker.angle}
  torque: {extremes: motor.torque, unit: N*mm}
require:
  swing: 70 deg .. 80 deg
studies:
  cycle: {turns: 1 motor, samples: 24}
"""

UNMET = SOUND.replace("70 deg .. 80 deg", "'>= 90 deg'")
STUCK = SOUND.replace("{a: 40, b: 120, c: 80, d: 100}", "{a: 60, b: 70, c: 50, d: 100}")
CANNOT_START = STUCK.replace("start: 40 deg", "start: 170 deg")
LOOSE = SOUND.replace("P: 70 at 30 deg}", "P: 70 at 30 deg, Q: [0, 9]}").replace(
    "assembly:", "  tail:    {points: {Q: [0, 0], R: [5, 0]}}\nassembly:"
)
NO_STUDY = SOUND.split("studies:", maxsplit=1)[0]
WARNED = SOUND.replace("turns: 1 motor", "period: 0.3 s")
# Three faults of form, on lines 9, 13 and 15.
FORM = (
    SOUND.replace("inertia: 650", "inertia: heavy!")
    .replace("speed: 120 rpm", "sped: 120 rpm")
    .replace("{span: rocker.angle}", "{span: rocker.angle, max: P.x}")
)
FORM_LINES = [9, 13, 15]
# Three faults of names, on lines 13, 16 and 18.
NAMES = SOUND.replace("turns: crank, on: frame", "turns: crnk, on: frame").replace(
    "extremes: motor.torque", "extremes: motor.torqe"
).replace("  swing: 70", "  swin: 70")  # fmt: skip
NAMES_LINES = [13, 16, 18]
YAML = SOUND.replace("links:", "links: [")
UNKNOWN_STUDY = SOUND.replace("cycle:", "cylce:")

# Exit code by kind: 0 done, 1 the model can't do what is asked, 2 the file is wrong.
KINDS = {
    "sound": (SOUND, 0),
    "a warning": (WARNED, 0),
    "a requirement not met": (UNMET, 1),
    "stuck on the way": (STUCK, 1),
    "stuck at the start": (CANNOT_START, 1),
    "a loose link": (LOOSE, 1),
    "no study": (NO_STUDY, 2),
    "faults of form": (FORM, 2),
    "faults of names": (NAMES, 2),
    "no YAML": (YAML, 2),
    "an unknown study": (UNKNOWN_STUDY, 2),
    "an empty file": ("", 2),
    "a list": ("- 1\n- 2\n", 2),
    "binary": ("\x00\x01\x02", 2),
}
