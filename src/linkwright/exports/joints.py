"""Which joints a format can hold: what it writes of pins and slides says nothing of kinds beyond them."""

from __future__ import annotations

from collections.abc import Iterator

from linkwright.exports.followed_laws import ridden
from linkwright.findings import Finding
from linkwright.kernels import Compiled


def unfollowed(compiled: Compiled, target: str) -> Iterator[Finding]:
    """A finding for each follower whose formula isn't made of one law, for formats that write the pieces of laws."""
    for name, follower in compiled.mechanism.followers.items():
        if ridden(compiled, name) is None:
            data = {"name": target, "joint": name, "kind": follower.title}
            yield Finding("export.joint", compiled.mechanism.path_of(name), data)


def unjointed(compiled: Compiled, target: str) -> Iterator[Finding]:
    """A finding for each drive that acts without a joint of its links, for formats whose drives act in joints."""
    for name in compiled.mechanism.drives:
        if compiled.structure.topology.acts_apart(name):
            yield Finding("export.drive", ("drives", name), {"name": target, "drive": name})


def unwritten(compiled: Compiled, target: str) -> Iterator[Finding]:
    """A finding for each joint by which no link can be placed, for formats that are trees of joints."""
    for c in compiled.structure.topology.but_pins:
        if not c.kind.places:
            data = {"name": target, "joint": c.joint, "kind": c.kind.title}
            yield Finding("export.joint", ("joints", c.joint), data)
