"""How a cam's entry is read: what turns it, what guides its follower, on which side that lies."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from linkwright.elements.cam_contact.entry import Cam
from linkwright.expressions.fields import AssemblyRule
from linkwright.expressions.typed_fields import Path
from linkwright.expressions.unknown import unknown_point
from linkwright.findings import Finding, Joined


def read(m: Any, name: str, pins: Mapping[str, Any]) -> dict[str, Any] | list[Finding]:
    """What a cam's follower is made of, or what is wrong."""
    return _EntryReader(m, name, pins).read()


class _EntryReader:
    def __init__(self, m: Any, name: str, pins: Mapping[str, Any]) -> None:
        self.m, self.pins = m, pins
        self.cam: Cam = m.cams[name]
        self.path: Path = ("cams", name)
        self.findings: list[Finding] = []

    def note(self, code: str, *key: str | int, **data: Any) -> None:
        self.findings.append(Finding(code, (*self.path, *key), data))

    def read(self) -> dict[str, Any] | list[Finding]:
        cam, m = self.cam, self.m
        if len({cam.cam, cam.follower, cam.on}) < 3:
            self.note("cam.same-link", cam=cam.cam, follower=cam.follower, on=cam.on)
            return self.findings
        self.touching()
        shaft, motor = self.pin(cam.cam), self.motor()
        pivot, slide = self.pin(cam.follower), self.slide()
        if shaft is None:
            self.note("cam.no-shaft", cam=cam.cam, on=cam.on)
        elif motor is None:
            self.note("cam.no-motor", cam=cam.cam, on=cam.on)
        if pivot is None and slide is None:
            self.note("cam.no-guide", follower=cam.follower, on=cam.on)
        if pivot is not None and cam.closed == "yoke":
            self.note("cam.yoke", "closed")
        self.lawful("angle" if pivot is not None else "length")
        side = self.side(shaft, pivot, slide) if shaft is not None else 1
        if self.findings or shaft is None or motor is None:
            return self.findings
        data: dict[str, Any] = {"entry": cam, "link": cam.follower, "on": cam.on, "motor": motor, "side": side}
        data |= {"motor_sign": 1 if m.drives[motor].link == cam.cam else -1, "turning": pivot is not None}
        data |= {"shaft": (shaft.point(cam.cam), shaft.point(cam.on))}
        if pivot is not None:
            return data | {"pivot": (pivot.point(cam.follower), pivot.point(cam.on))}
        return data | {"joint": slide}

    def touching(self) -> None:
        """The follower's points at which it touches."""
        key = next(key for key in ("at", "knife", "face") if getattr(self.cam, key) is not None)
        places: dict[Path, str] = {(key,): self.cam.touches}
        if (second := self.cam.second) is not None and (other := second.touches) is not None:
            places["second", "at" if second.at else "face"] = other
        points = self.m.links[self.cam.follower].points
        for path, name in places.items():
            if name not in points:
                self.findings.append(unknown_point((*self.path, *path), self.cam.follower, name, points))

    def pin(self, link: str) -> Any:
        """The pin that a link shares with the one that carries both."""
        return next((pin for pin in self.pins.values() if {link, self.cam.on} <= {*pin.links}), None)

    def slide(self) -> str | None:
        wanted = {self.cam.follower, self.cam.on}
        return next((name for name, joint in self.m.prismatic_joints() if {*joint.links} == wanted), None)

    def motor(self) -> str | None:
        """The drive that turns the cam; one whose law is an output's can't be asked for the cam's angle."""
        wanted = {self.cam.cam, self.cam.on}
        turning = ((n, d) for n, d in self.m.drives.items() if d.turns and d.output is None)
        return next((name for name, drive in turning if {drive.link, drive.on} == wanted), None)

    def lawful(self, value: str) -> None:
        """The law's kind."""
        law = self.m.laws.get(self.cam.law)
        if law is not None and (law.over, law.of, law.beyond) != ("angle", value, "repeat"):
            given = {"over": law.over, "of": law.of, "beyond": law.beyond}
            self.note("cam.law", "law", law=self.cam.law, of=value, given=Joined(f"{k}: {v}" for k, v in given.items()))

    def side(self, shaft: Any, pivot: Any, slide: str | None) -> int:
        """+1 or -1, as followers have it."""
        rule, words = self.cam.side, {}
        if pivot is not None:
            words = {"left": 1, "right": -1}
            meant = f"left of {shaft.name}-{pivot.name}"
        else:
            words = {"ahead": 1, "behind": -1}
            meant = f"ahead of {shaft.name} along {slide}"
            if rule is None:
                return 1
        if rule is None or rule.word not in words or not (signs := self.order(rule, shaft, pivot, slide)):
            if pivot is not None or slide is not None:
                self.note("cam.side", "side", given=rule.text if rule else "-", meant=meant)
            return 1
        return words[rule.word] * signs

    def order(self, rule: AssemblyRule, shaft: Any, pivot: Any, slide: str | None) -> int:
        """+1 where a rule names shaft and pivot in this order (or shaft and slide), -1 in the other; 0 if neither."""

        def is_at(name: str, pin: Any) -> bool:
            return name == pin.name or name in {point for _, point in pin.members}

        if pivot is None:
            return int(is_at(rule.reference[0], shaft) and rule.along == slide)
        first, second = rule.reference
        return int(is_at(first, shaft) and is_at(second, pivot)) - int(is_at(first, pivot) and is_at(second, shaft))
