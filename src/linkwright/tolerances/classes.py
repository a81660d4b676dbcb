"""Classes of tolerances by name: a text such as ``ISO 2768-m``, ``h7`` or ``IT8`` gives limits for a size.

A standard is a class under ``@register`` that reads its own texts.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from typing import Any, ClassVar, Self

from linkwright.notation.registry import Registry

Limits = tuple[float, float]
"""The lower and the upper limit deviation, in m or rad."""


class NoTolerance(ValueError):
    """A class has no tolerance for what is asked; ``reason`` says why: ``size`` (``data``: ``low`` and ``high`` of the
    sizes that it has, in m), or ``angle``."""

    def __init__(self, reason: str, **data: Any) -> None:
        super().__init__(reason)
        self.reason, self.data = reason, data


class ToleranceClass(ABC):
    """A class of a standard; ``text`` is its name as it stands in a drawing."""

    standard: ClassVar[str]
    examples: ClassVar[tuple[str, ...]]
    text: str

    @classmethod
    @abstractmethod
    def read(cls, text: str) -> Self | None:
        """The class of that name, ``None`` where it isn't one of this standard."""

    @abstractmethod
    def limits(self, size: float) -> Limits:
        """The limit deviations (m) of a nominal size (m). Raises :class:`NoTolerance`."""

    def angular(self, side: float) -> Limits:
        """The limit deviations (rad) of an angle whose shorter side is ``side`` (m). Raises :class:`NoTolerance`."""
        raise NoTolerance("angle")


STANDARDS: Registry[type[ToleranceClass]] = Registry()


def register(cls: type[ToleranceClass]) -> type[ToleranceClass]:
    """Register a standard under its name; a second one of the same name is an error."""
    STANDARDS[cls.standard] = cls
    return cls


def tolerance_class(text: str) -> ToleranceClass | None:
    """The class that a text names, ``None`` where it names none."""
    return next((found for cls in STANDARDS.values() if (found := cls.read(text)) is not None), None)


def examples() -> list[str]:
    """A few names of classes, for messages."""
    return [text for cls in STANDARDS.values() for text in cls.examples]
