"""The paper feeder integrated in time by Exudyn, the crank's rotation prescribed, against the kinetostatics.

Exudyn's error, measured against the Newton-Euler equations, falls with the square of the step (Newmark, index 2):
0.013 N at 500 steps over 0.6 s, 0.005 N at 1000, 0.001 N at 2000, of forces up to 525 N; torque 0.0007 N m of 62.
The test takes 1000 steps and allows some twice that.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from helpers.compiled import compiled_from
from helpers.examples import feeder

exu = pytest.importorskip("exudyn")

Array = NDArray[np.float64]
END, STEPS = 0.6, 1000
FORCE, TORQUE = 0.012, 0.002
SPEED = -4 * math.pi / 3
PINS = {"A": "frame, crank", "B": "crank, coupler", "C": "coupler, rocker", "D": "frame, rocker", "E": "rocker, slider"}
MASSES = {"crank": 0.6, "coupler": 1.5, "rocker": 2.0, "slider": 1.0, "guide": 3.0}
LONG = {"crank": 0.155, "coupler": 0.395, "rocker": 0.5}
POINTS = {
    "frame": {"A": (0.0, 0.0), "D": (0.3, 0.0), "H": (0.0, 0.58)},
    "crank": {"A": (0.0, 0.0), "B": (0.155, 0.0)},
    "coupler": {"B": (0.0, 0.0), "C": (0.395, 0.0)},
    "rocker": {"D": (0.0, 0.0), "C": (0.3, 0.0), "E": (0.5, 0.0)},
    "slider": {"E": (0.0, 0.0)},
    "guide": {"G": (0.0, 0.0)},
}


def start() -> tuple[dict[str, complex], dict[str, float]]:
    """Origins (as complex numbers) and angles of the links at the start, by intersecting two circles."""
    crank = math.atan2(61.78, 142.16)
    b, d = 0.155 * np.exp(1j * crank), 0.3
    reach = abs(d - b)
    along = (0.395**2 - 0.3**2 + reach**2) / (2 * reach)
    c = b + (d - b) / reach * (along + 1j * math.sqrt(0.395**2 - along**2))
    rocker = float(np.angle(c - d))
    e = d + 0.5 * np.exp(1j * rocker)
    origins = {"crank": 0j, "coupler": b, "rocker": d + 0j, "slider": e, "guide": e.real + 0.58j}
    angles = {"crank": crank, "coupler": float(np.angle(c - b)), "rocker": rocker, "slider": 0.0, "guide": 0.0}
    return origins, angles


def rates() -> tuple[dict[str, complex], dict[str, float]]:
    """Velocities of the origins and rates of turn at the start, from the loop's velocity equation."""
    origins, angles = start()
    b = origins["coupler"]
    c = b + 0.395 * np.exp(1j * angles["coupler"])
    vb = 1j * SPEED * b
    # vb + i w2 (c - b) = i w3 (c - d): two real equations.
    u, w = 1j * (c - b), -1j * (c - 0.3)
    w2, w3 = np.linalg.solve([[u.real, w.real], [u.imag, w.imag]], [-vb.real, -vb.imag])
    ve = 1j * w3 * 0.5 * np.exp(1j * angles["rocker"])
    velocities = {"crank": 0j, "coupler": vb, "rocker": 0j, "slider": ve, "guide": ve.real + 0j}
    return velocities, {"crank": SPEED, "coupler": float(w2), "rocker": float(w3), "slider": 0.0, "guide": 0.0}


def simulate() -> dict[str, Array]:
    """Time, and the force in each pin or the crank's torque, one row a step."""
    from exudyn import utilities as eu

    container = exu.SystemContainer()
    mbs: Any = container.AddSystem()
    ground = mbs.AddObject(eu.ObjectGround())
    origins, angles = start()
    velocities, turns = rates()
    bodies, nodes, middle = {}, {}, {}
    for link, mass in MASSES.items():
        half = LONG.get(link, 0.0) / 2
        arm = half * np.exp(1j * angles[link])
        at, v = origins[link] + arm, velocities[link] + 1j * turns[link] * arm
        node = mbs.AddNode(
            eu.NodeRigidBody2D(
                referenceCoordinates=[at.real, at.imag, angles[link]],
                initialVelocities=[v.real, v.imag, turns[link]],
            )
        )
        # The slider and the guide do not turn: their inertia, which may not be nil here, plays no part.
        inertia = mass * LONG[link] ** 2 / 12 if link in LONG else 1e-6
        body = mbs.AddObject(eu.ObjectRigidBody2D(mass=mass, inertia=inertia, nodeNumber=node))
        marker = mbs.AddMarker(eu.MarkerBodyPosition(bodyNumber=body, localPosition=[0, 0, 0]))
        mbs.AddLoad(eu.LoadForceVector(markerNumber=marker, loadVector=[0, -mass * 9.80665, 0]))
        bodies[link], nodes[link], middle[link] = body, node, half

    def marker(link: str, point: str, rigid: bool = False) -> Any:
        x, y = POINTS[link][point]
        kind = eu.MarkerBodyRigid if rigid else eu.MarkerBodyPosition
        place = [x - middle.get(link, 0.0), y, 0]
        return mbs.AddMarker(kind(bodyNumber=bodies.get(link, ground), localPosition=place))

    def sensor(item: Any) -> Any:
        force = exu.OutputVariableType.Force
        return mbs.AddSensor(
            eu.SensorObject(objectNumber=item, outputVariableType=force, storeInternal=True, writeToFile=False)
        )

    sensors = {}
    for pin, links in PINS.items():
        markers = [marker(link, pin) for link in links.split(", ")]
        sensors[pin] = sensor(mbs.AddObject(eu.ObjectJointRevolute2D(markerNumbers=markers)))
    for ends, axis, normal in (
        ((("frame", "H"), ("guide", "G")), [1, 0, 0], [0, 1, 0]),
        ((("guide", "G"), ("slider", "E")), [0, 1, 0], [1, 0, 0]),
    ):
        markers = [marker(*end, rigid=True) for end in ends]
        mbs.AddObject(
            eu.ObjectJointPrismatic2D(
                markerNumbers=markers, axisMarker0=axis, normalMarker1=normal, constrainRotation=True
            )
        )
    still = mbs.AddMarker(eu.MarkerNodeCoordinate(nodeNumber=mbs.AddNode(eu.NodePointGround()), coordinate=0))
    turning = mbs.AddMarker(eu.MarkerNodeCoordinate(nodeNumber=nodes["crank"], coordinate=2))
    drive = eu.ObjectConnectorCoordinate(
        markerNumbers=[still, turning],
        offsetUserFunction=lambda mbs, t, item, offset: SPEED * t,
        offsetUserFunction_t=lambda mbs, t, item, offset: SPEED,
    )
    sensors["motor"] = sensor(mbs.AddObject(drive))
    mbs.Assemble()
    settings = exu.SimulationSettings()
    integration = settings.timeIntegration
    integration.numberOfSteps, integration.endTime, integration.verboseMode = STEPS, END, 0
    integration.generalizedAlpha.useIndex2Constraints = True
    integration.generalizedAlpha.useNewmark = True
    integration.generalizedAlpha.computeInitialAccelerations = True
    settings.solution.file.write = False
    settings.solution.sensors.writePeriod = END / STEPS
    mbs.SolveDynamic(settings)
    return {name: np.asarray(mbs.GetSensorStoredData(number))[1:] for name, number in sensors.items()}


@pytest.mark.filterwarnings("ignore::DeprecationWarning")
def test_reactions_and_torque_of_the_paper_feeder() -> None:
    found = simulate()
    compiled = compiled_from(feeder())
    t = found["A"][:, 0]
    assert t.size == STEPS
    for pin, links in PINS.items():
        expected = compiled.evaluate([f"force({links}).{axis}" for axis in "xy"], t)
        # Exudyn states the force on the joint's first marker, of the second link on the first.
        assert np.abs(found[pin][:, 1:3].T + expected).max() < FORCE, pin
    torque = compiled.evaluate(["motor.torque"], t)[0]
    assert np.abs(found["motor"][:, 1] + torque).max() < TORQUE
    assert np.abs(torque).max() > 60
