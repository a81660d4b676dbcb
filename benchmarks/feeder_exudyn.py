"""The paper feeder as a model of Exudyn, integrated in time, as lean as Exudyn allows.

Slider and guide are mass points, their slides constraints of coordinates, and the crank's speed is a constraint at
velocity level: 1.6 times as fast as rigid bodies with prismatic joints and a drive that calls Python. Other solver
settings (full Newton, index 3, other linear solvers, no adaptive steps) came out no faster at the same error.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from contest import Array, Way, timed

PERIOD = 1.5
SPEED = -4 * math.pi / 3
PINS = {"A": "frame, crank", "B": "crank, coupler", "C": "coupler, rocker", "D": "frame, rocker", "E": "rocker, slider"}
MASSES = {"crank": 0.6, "coupler": 1.5, "rocker": 2.0, "slider": 1.0, "guide": 3.0}
LONG = {"crank": 0.155, "coupler": 0.395, "rocker": 0.5}
POINTS = {
    "frame": {"A": 0.0, "D": 0.3},
    "crank": {"A": 0.0, "B": 0.155},
    "coupler": {"B": 0.0, "C": 0.395},
    "rocker": {"D": 0.0, "C": 0.3, "E": 0.5},
    "slider": {"E": 0.0},
}
"""Where the pins are along each link (m)."""
SENSED = [
    *(("rocker", "C", "Position"), ("rocker", "E", "Position"), ("rocker", "E", "Velocity")),
    *(("rocker", "E", "Acceleration"), ("coupler", "B", "AngularVelocity"), ("rocker", "D", "AngularVelocity")),
    *(("coupler", "B", "AngularAcceleration"), ("rocker", "D", "AngularAcceleration")),
]
"""What is measured of links: link, point, variable."""


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


class Model:
    """The mechanism in Exudyn: ``items`` are the numbers of its joints and drive, ``sensors`` of what is stored."""

    def __init__(self) -> None:
        import exudyn as exu
        from exudyn import utilities as eu

        self.container = exu.SystemContainer()
        self.mbs: Any = self.container.AddSystem()
        self.bodies: dict[str, Any] = {"frame": self.mbs.AddObject(eu.ObjectGround())}
        self.nodes: dict[str, Any] = {"frame": self.mbs.AddNode(eu.NodePointGround())}
        self.sensors: dict[str, Any] = {}
        (origins, angles), (velocities, turns) = start(), rates()
        for link, mass in MASSES.items():
            arm = LONG.get(link, 0.0) / 2 * np.exp(1j * angles[link])
            at, v = origins[link] + arm, velocities[link] + 1j * turns[link] * arm
            self.body(link, mass, [at.real, at.imag, angles[link]], [v.real, v.imag, turns[link]])
        self.items = {pin: self.pin(pin, *links.split(", ")) for pin, links in PINS.items()}
        self.items["rail"] = self.coordinates(("frame", 0), ("guide", 1))
        self.items["slide"] = self.coordinates(("guide", 0), ("slider", 0))
        self.items["motor"] = self.coordinates(("frame", 0), ("crank", 2), velocityLevel=True, offset=SPEED)

    def body(self, link: str, mass: float, at: list[float], v: list[float]) -> None:
        """A link with its weight; those that don't turn are points."""
        from exudyn import utilities as eu

        if link in LONG:
            node = self.mbs.AddNode(eu.NodeRigidBody2D(referenceCoordinates=at, initialVelocities=v))
            inertia = mass * LONG[link] ** 2 / 12
            body = self.mbs.AddObject(eu.ObjectRigidBody2D(mass=mass, inertia=inertia, nodeNumber=node))
        else:
            node = self.mbs.AddNode(eu.NodePoint2D(referenceCoordinates=at[:2], initialVelocities=v[:2]))
            body = self.mbs.AddObject(eu.ObjectMassPoint2D(mass=mass, nodeNumber=node))
        self.nodes[link], self.bodies[link] = node, body
        centre = self.mbs.AddMarker(eu.MarkerBodyPosition(bodyNumber=body, localPosition=[0, 0, 0]))
        self.mbs.AddLoad(eu.LoadForceVector(markerNumber=centre, loadVector=[0, -mass * 9.80665, 0]))

    def place(self, link: str, point: str) -> list[float]:
        """A point in a body's own axes, which start at the centre of mass."""
        return [POINTS[link][point] - LONG.get(link, 0.0) / 2, 0, 0]

    def pin(self, point: str, *links: str) -> Any:
        from exudyn import utilities as eu

        places = [{"bodyNumber": self.bodies[link], "localPosition": self.place(link, point)} for link in links]
        markers = [self.mbs.AddMarker(eu.MarkerBodyPosition(**place)) for place in places]
        return self.mbs.AddObject(eu.ObjectJointRevolute2D(markerNumbers=markers))

    def coordinates(self, *ends: tuple[str, int], **law: Any) -> Any:
        """Two coordinates that go together."""
        from exudyn import utilities as eu

        given = [{"nodeNumber": self.nodes[link], "coordinate": number} for link, number in ends]
        markers = [self.mbs.AddMarker(eu.MarkerNodeCoordinate(**end)) for end in given]
        return self.mbs.AddObject(eu.ObjectConnectorCoordinate(markerNumbers=markers, **law))

    def sense(self, name: str) -> None:
        """Store the force of a joint or of the drive at every step."""
        import exudyn as exu
        from exudyn import utilities as eu

        kept = {"outputVariableType": exu.OutputVariableType.Force, "storeInternal": True, "writeToFile": False}
        self.sensors[name] = self.mbs.AddSensor(eu.SensorObject(objectNumber=self.items[name], **kept))

    def sense_link(self, link: str, point: str, variable: str) -> None:
        """Store a variable of a link's point at every step."""
        import exudyn as exu
        from exudyn import utilities as eu

        kept = {"outputVariableType": getattr(exu.OutputVariableType, variable), "storeInternal": True}
        at = {"bodyNumber": self.bodies[link], "localPosition": self.place(link, point)}
        number = self.mbs.AddSensor(eu.SensorBody(**at, **kept, writeToFile=False))
        self.sensors[f"{point} of {link}: {variable}"] = number

    def run(self, end: float, steps: int) -> float:
        """Integrate from 0 to ``end`` (s); the seconds that it took."""
        import exudyn as exu

        self.mbs.Assemble()
        settings = exu.SimulationSettings()
        integration = settings.timeIntegration
        integration.numberOfSteps, integration.endTime, integration.verboseMode = steps, end, 0
        integration.generalizedAlpha.useIndex2Constraints = True
        integration.generalizedAlpha.useNewmark = True
        integration.generalizedAlpha.computeInitialAccelerations = True
        settings.solution.file.write = False
        settings.solution.sensors.writePeriod = end / steps
        return timed(lambda: self.mbs.SolveDynamic(settings))

    def stored(self, name: str) -> Array:
        """A sensor's time and components, a row a step, without the start."""
        return np.asarray(self.mbs.GetSensorStoredData(self.sensors[name]))[1:]


def integrated(steps: int) -> Way:
    """A turn in ``steps`` steps, all outputs stored at every one."""

    def run() -> tuple[float, Array]:
        model = Model()
        for sensed in SENSED:
            model.sense_link(*sensed)
        forces = ("A", "C", "slide", "motor")
        for name in forces:
            model.sense(name)
        seconds = model.run(PERIOD, steps)
        pick = np.arange(1, 61) * steps // 60 - 1
        links = {key: model.stored(key)[pick, 1:].T for key in list(model.sensors)[: len(SENSED)]}
        a, c, slide, motor = (model.stored(name)[pick, 1:].T for name in forces)
        motion = [row for name, rows in links.items() for row in (rows[2:] if "Angular" in name else rows[:2])]
        # Exudyn states the force on a joint's first marker, of the second link on the first.
        return seconds, np.array([*motion, *-a[:2], *-c[:2], -slide[0], -motor[0]])

    return Way("Exudyn", f"Newmark, {steps} steps a turn", steps, run, steps)
