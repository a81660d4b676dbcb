"""The Geneva drive: a wheel that a pin turns on by one slot at a time, and that a locking arc holds in between."""

from linkwright.elements.geneva.follower import GenevaDrive

__all__ = ["GenevaDrive"]
