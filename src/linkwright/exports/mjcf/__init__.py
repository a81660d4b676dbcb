"""MuJoCo's XML (MJCF): bodies along a tree of joints, loops closed by soft constraints."""

from linkwright.exports.mjcf.target import Mjcf

__all__ = ["Mjcf"]
