"""The paper feeder as a model of MuJoCo, in two ways.

Integrated in time: MuJoCo has no joint that closes a loop, its ``connect`` is a constraint that gives way, made as
stiff as the step allows. The crank is kept at its speed by a flywheel (``armature``) far heavier than all links, whose
angular deceleration gives the torque. Reactions are those of its force sensors, so the tree of bodies is cut where none
is asked for: at B and between rocker and slider. The loop over steps is MuJoCo's own (``rollout``).

State set: poses, rates and accelerations are linkwright's; MuJoCo computes points from them, and by inverse dynamics of
the open tree the torque (the power of all its joint forces over the crank's speed). It has no reactions then.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np
from contest import Array, Way, timed
from feeder_exudyn import LONG, MASSES, PERIOD, SPEED, rates, start

from linkwright.kernels import Compiled

FLYWHEEL = 1e8
"""Inertia of the crank's flywheel (kg m^2): the speed changes by some 1e-7 of itself."""
MODEL = """
<mujoco>
  <compiler angle="radian"/>
  <option timestep="{step!r}" gravity="0 -9.80665 0" integrator="{integrator}" jacobian="dense" tolerance="1e-10">
    <flag contact="disable" equality="{closed}"/>
  </option>
  <worldbody>
    <body name="crank">
      <joint axis="0 0 1" armature="{flywheel}"/> {crank} <site name="A"/> <site name="B" pos="0.155 0 0"/>
    </body>
    <body name="rocker" pos="0.3 0 0">
      <joint axis="0 0 1"/> {rocker} <site name="Er" pos="0.5 0 0"/>
      <body name="coupler" pos="0.3 0 0">
        <joint axis="0 0 1"/> {coupler} <site name="C"/> <site name="Bc" pos="-0.395 0 0"/>
      </body>
    </body>
    <body name="guide" pos="0 0.58 0">
      <joint type="slide" axis="1 0 0"/> {guide}
      <body name="slider" pos="0 -0.58 0"> <joint type="slide" axis="0 1 0"/> {slider} <site name="E"/> </body>
    </body>
  </worldbody>
  <equality>
    <connect site1="B" site2="Bc" solref="{hold!r} 1" solimp="0.9999 0.9999 0.001"/>
    <connect site1="E" site2="Er" solref="{hold!r} 1" solimp="0.9999 0.9999 0.001"/>
  </equality>
  <sensor>
    <framepos objtype="site" objname="C"/> <framepos objtype="site" objname="E"/>
    <framelinvel objtype="site" objname="E"/> <framelinacc objtype="site" objname="E"/>
    <frameangvel objtype="xbody" objname="coupler"/> <frameangvel objtype="xbody" objname="rocker"/>
    <frameangacc objtype="xbody" objname="coupler"/> <frameangacc objtype="xbody" objname="rocker"/>
    <force site="A"/> <force site="C"/> <force site="E"/>
    <framexaxis objtype="site" objname="A"/> <framexaxis objtype="site" objname="C"/>
    <frameangacc objtype="xbody" objname="crank"/>
  </sensor>
</mujoco>
"""
STATE = ["crank.angle", "rocker.angle", "coupler.angle", "E.x", "E.y"]
"""The coordinates of the tree, the coupler's against the rocker once it is made so."""
RATES = ["crank.omega", "rocker.omega", "coupler.omega", "E.vx", "E.vy"]
SECOND = ["crank.alpha", "rocker.alpha", "coupler.alpha", "E.ax", "E.ay"]


def inertial(link: str) -> str:
    """The inertia of a link as MuJoCo wants it: a thin rod, or a point (whose turning plays no part)."""
    if link not in LONG:
        return f'<inertial pos="0 0 0" mass="{MASSES[link]}" diaginertia="1e-6 1e-6 1e-6"/>'
    along = -LONG[link] / 2 if link == "coupler" else LONG[link] / 2  # the coupler hangs on C
    turning = MASSES[link] * LONG[link] ** 2 / 12
    return f'<inertial pos="{along} 0 0" mass="{MASSES[link]}" diaginertia="1e-9 {turning!r} {turning!r}"/>'


def model(integrator: str, step: float, hold: float, closed: bool = True) -> Any:
    """The model; ``hold`` is the time constant of the loops' closing (s), two steps at least."""
    import mujoco

    text = MODEL.format(
        integrator=integrator, step=step, hold=hold, closed="enable" if closed else "disable",
        flywheel=FLYWHEEL if closed else 0, **{link: inertial(link) for link in MASSES},
    )  # fmt: skip
    return mujoco.MjModel.from_xml_string(text)


def tree(origin_of_slider: complex, crank: float, rocker: float, coupler: float) -> Array:
    """The tree's coordinates, or their rates."""
    return np.array([crank, rocker, coupler - rocker, origin_of_slider.real, origin_of_slider.imag])


def outputs(sensors: Array, torque: Array) -> Array:
    """The 18 outputs (outputs, poses) from sensor data (poses, sensors)."""
    s = sensors.T

    def world(force: Array, axis: Array) -> Array:
        return np.array([axis[0] * force[0] - axis[1] * force[1], axis[1] * force[0] + axis[0] * force[1]])

    crank, rocker = world(s[24:26], s[33:35]), -world(s[27:29], s[36:38])
    gravity = np.array([[0.0], [9.80665]])  # its accelerations are those of a frame that falls
    return np.array(
        [*s[0:2], *s[3:5], *s[6:8], *(s[9:11] - gravity), *s[[14, 17, 20, 23]], *crank, *rocker, s[30], torque]
    )


def integrated(integrator: str, steps: int, hold: float) -> Way:
    """A turn in ``steps`` steps, the loops held with a time constant of ``hold`` steps."""
    import mujoco
    from mujoco import rollout

    made = model(integrator, PERIOD / steps, hold * PERIOD / steps)
    data = mujoco.MjData(made)
    (origins, angles), (velocities, turns) = start(), rates()
    at = [tree(o["slider"], a["crank"], a["rocker"], a["coupler"]) for o, a in ((origins, angles), (velocities, turns))]
    first = np.array([[0.0, *at[0], *at[1]]])
    pick = np.arange(1, 61) * steps // 60  # a step's sensors are those at its start

    def run() -> tuple[float, Array]:
        sensors = np.empty((1, steps + 1, made.nsensordata))
        seconds = timed(lambda: rollout.rollout(made, data, first, nstep=steps + 1, sensordata=sensors))
        chosen = sensors[0, pick]
        return seconds, outputs(chosen, -FLYWHEEL * chosen[:, 41])

    return Way("MuJoCo", f"{integrator}, {steps} steps a turn", steps, run, steps)


def set_states(compiled: Compiled, poses: int, samples: Array) -> Way:
    """Poses, rates and accelerations from linkwright at the samples, each as often as makes ``poses`` of them."""
    import mujoco

    made = model("Euler", 1e-3, 2e-3, closed=False)
    data = mujoco.MjData(made)
    often = poses // samples.size
    t = np.repeat(samples, often)
    states = []
    for names in (STATE, RATES, SECOND):
        rows = compiled.evaluate(names, t)
        rows[2] -= rows[1]
        states.append(np.ascontiguousarray(rows.T))
    sensors, power = np.empty((t.size, made.nsensordata)), np.empty(t.size)

    def loop() -> None:
        for i, (q, v, a) in enumerate(zip(*states, strict=True)):
            data.qpos[:], data.qvel[:], data.qacc[:] = q, v, a
            mujoco.mj_inverse(made, data)
            sensors[i], power[i] = data.sensordata, data.qfrc_inverse @ v

    def run() -> tuple[float, Array]:
        seconds = timed(loop)
        found = outputs(sensors[::often], power[::often] / SPEED)
        found[12:17] = np.nan
        return seconds, found

    return Way("MuJoCo", "state set by linkwright, no reactions", t.size, run)


def ways(compiled: Compiled, samples: Array, steps: int) -> Iterator[Way]:
    """The cheapest step; the two that come to 0.01 N at 1800 steps a turn or six times as many; inverse dynamics."""
    yield integrated("Euler", steps, 2)
    yield integrated("Euler", 6 * steps, 2)
    yield integrated("RK4", steps, 6)
    yield set_states(compiled, steps, samples)
