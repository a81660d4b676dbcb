"""linkwright: planar mechanisms from one readable file."""

__version__ = "0.1.0"
