"""The ground that the model's parts stand on: immutable values that keep what was written."""

from __future__ import annotations

import math
import numbers
import re
from collections.abc import Iterable, Iterator, Mapping
from typing import Any, ClassVar, NoReturn, Self

from pydantic import (
    BaseModel,
    ConfigDict,
    GetCoreSchemaHandler,
    GetJsonSchemaHandler,
    ModelWrapValidatorHandler,
    ValidationError,
    model_validator,
)
from pydantic_core import CoreSchema, InitErrorDetails, PydanticCustomError, core_schema

from linkwright.expressions.full_width import TO_ASCII
from linkwright.expressions.schema_texts import description
from linkwright.findings import Term

NO_TEXT = re.compile(r"[\x00-\x08\x0b\x0c\x0e-\x1f\x7f-\x84\x86-\x9f\ud800-\udfff\ufffe\uffff]")
"""What can't stand in a text file: control characters, halves of surrogates."""
NAME = re.compile(r"[^\W\d]\w*")
MAX_NAME = 60
MAX_TEXT = 2000
MAX_INT = 10**15
"""Whole numbers from here on are kept as floats, in files and in Python alike."""
RESERVED = frozenset({"t", "pi", "start", "end"})

Fault = tuple[str, dict[str, Any]]
"""The code of a finding and the data of its sentence."""
FaultWithin = tuple[str, dict[str, Any], *tuple[str, ...]]
"""The same of something within the part: then the path to it."""


def fault(code: str, **data: Any) -> PydanticCustomError:
    """A validation error that becomes the finding ``code``."""
    return PydanticCustomError("finding", "{code}", {"code": code, **data})


def unexpected(wanted: str, given: Any, hint: Term | None = None) -> PydanticCustomError:
    """A validation error: something else is wanted here (a phrase of the catalogue), what is given, and a ``hint`` or
    else an example."""
    return fault("file.expected", wanted=Term(wanted), given=describe(given), hint=hint or Term(f"{wanted}-as"))


def describe(raw: Any) -> Any:
    """What kind of value was given, in plain words."""
    if raw is None:
        return Term("nothing")
    if isinstance(raw, bool):
        return "true" if raw else "false"
    if isinstance(raw, Mapping):
        return Term("given-mapping")
    if isinstance(raw, list | tuple):
        return Term("given-list", count=len(raw))
    text = str(raw)
    text = text if len(text) <= 58 else text[:55] + "..."
    return text if isinstance(raw, int | float) else Term("quoted", text=text)


def free_text(raw: Any, limit: int = 10 * MAX_TEXT) -> str:
    """A text of bounded length, without control characters."""
    if not isinstance(raw, str):
        raise unexpected("text", raw)
    if len(raw) > limit:
        raise fault("file.long", limit=limit)
    if NO_TEXT.search(raw):
        raise fault("file.character")
    return raw


def short_text(raw: Any) -> str:
    """A text as long as an expression may be."""
    return free_text(raw, MAX_TEXT)


def check_name(name: Any) -> str:
    """A plain identifier (any script), not one of the reserved words."""
    if not isinstance(name, str):
        raise unexpected("name", name)
    if name in RESERVED:
        raise fault("file.reserved-name", name=name)
    if len(name) > MAX_NAME or not NAME.fullmatch(name):
        raise fault("file.bad-name", name=name[:MAX_NAME], hint=_nearest_name(name))
    return name


def _nearest_name(name: str) -> Term:
    """How a name may be written that isn't one."""
    plain = re.sub(r"[\W_]+", "_", name.replace("'", "1").replace('"', "2")).strip("_")
    if "." in name or len(plain) > MAX_NAME or not NAME.fullmatch(plain):
        return Term("name-form", limit=MAX_NAME)
    return Term("write-name", text=plain)


class FrozenDict(dict[str, Any]):
    """A mapping that can't be changed."""

    def _refuse(self, *_: Any, **__: Any) -> NoReturn:
        raise TypeError("a mechanism is immutable; build a new one")

    __setitem__ = __delitem__ = __ior__ = clear = pop = popitem = setdefault = update = _refuse

    def __hash__(self) -> int:  # type: ignore[override]
        return hash(frozenset(self.items()))

    def __reduce__(self) -> tuple[Any, ...]:
        return (FrozenDict, (dict(self),))


def frozen(raw: Any) -> Any:
    """Plain data (as YAML holds it) made immutable, through and through."""
    if isinstance(raw, Mapping):
        for key in raw:
            if not isinstance(key, str):
                raise unexpected("name", key)
        return FrozenDict({key: frozen(value) for key, value in raw.items()})
    if isinstance(raw, list | tuple):
        return tuple(frozen(value) for value in raw)
    if raw is None or isinstance(raw, bool):
        return raw
    return free_text(raw) if isinstance(raw, str) else plain_number(raw, "plain")


def plain_number(raw: Any, wanted: str) -> int | float:
    """A finite number as Python's int or float, from NumPy's too."""
    if isinstance(raw, bool) or not isinstance(raw, numbers.Real):
        raise unexpected(wanted, raw)
    try:
        value = int(raw) if isinstance(raw, numbers.Integral) else float(raw)
        value = value if abs(value) < MAX_INT else float(value)
    except OverflowError:
        value = math.inf
    if not math.isfinite(value):
        raise fault("file.not-finite", given=str(value))
    return value


class Frozen(BaseModel):
    """Base of the model's parts: immutable, and an unknown key is a fault."""

    model_config = ConfigDict(frozen=True, extra="forbid", arbitrary_types_allowed=True, defer_build=True)

    @classmethod
    def faults(cls, given: Mapping[str, Any]) -> Iterator[Fault] | Iterator[FaultWithin]:
        """What is wrong with the keys that are given together, by the file's names; ``None`` isn't given."""
        yield from ()

    @model_validator(mode="wrap")
    @classmethod
    def _all_at_once(cls, raw: Any, handler: ModelWrapValidatorHandler[Self]) -> Self:
        """Faults of the keys together are found also where a value is wrong by itself."""
        if not isinstance(raw, Mapping):
            return handler(raw)
        given = {key: value for key, value in raw.items() if value is not None}
        details = [
            InitErrorDetails(type=fault(code, **data), loc=tuple(path), input=None)
            for code, data, *path in cls.faults(given)
        ]
        try:
            value = handler(raw)
        except ValidationError as error:
            details += [_again(line) for line in error.errors(include_url=False)]
        if details:
            raise ValidationError.from_exception_data(cls.__name__, details)
        return value


class Shortened(Frozen):
    """A part that may be written as the value of its key ``main`` alone; the text ``schema.CLASS.alone`` says so."""

    main: ClassVar[str]

    @model_validator(mode="wrap")
    @classmethod
    def _bare(cls, raw: Any, handler: ModelWrapValidatorHandler[Self]) -> Self:
        return handler(raw if isinstance(raw, Mapping | cls) else {cls.main: raw})

    @classmethod
    def __get_pydantic_json_schema__(cls, schema: CoreSchema, handler: GetJsonSchemaHandler) -> dict[str, Any]:
        whole = handler.resolve_ref_schema(handler(schema))
        short = {"type": ["number", "string"], **description(f"{cls.__name__}.alone")}
        return {"description": whole.get("description", ""), "anyOf": [short, whole]}


def _again(line: Any) -> InitErrorDetails:
    """A line of a validation error, to be raised once more together with others."""
    kind = line["type"]
    if kind == "finding":
        kind = PydanticCustomError("finding", "{code}", line["ctx"])
    return InitErrorDetails(type=kind, loc=line["loc"], input=line["input"], ctx=line.get("ctx", {}))


class Written:
    """A value that parses from what is written in the file and gives it back unchanged."""

    __slots__ = ("raw",)
    raw: Any
    json_type: ClassVar[dict[str, Any]] = {"type": "string"}
    spellings: ClassVar[Mapping[str, str]] = {}
    """Patterns of other spellings, each with the one that a file has: a text, or a list in brackets."""

    def __init__(self, raw: Any) -> None:
        if isinstance(raw, str):
            short_text(raw)
        self.set_attribute("raw", raw)
        self.read(raw)

    def read(self, raw: Any) -> None:
        """Parse and store; raises :func:`fault`."""

    def quantities(self) -> Iterable[tuple[Any, Any]]:
        """The expressions in it, each with the :class:`~linkwright.expressions.typed_fields.Quantity` that it is, or
        ``None`` where the field says that."""
        return ()

    def part_names(self) -> tuple[str, ...]:
        """What tells its expressions apart, in their order, where there are several: ``x`` and ``y``."""
        return ()

    def names(self) -> Iterable[tuple[str, Any]]:
        """The names of elements in it, each with the :class:`~linkwright.expressions.typed_fields.Ref` that it is, or
        ``None`` where the field says that."""
        return ()

    def unexpected(self, wanted: str, raw: Any) -> PydanticCustomError:
        """A fault: something else is wanted, with what is meant where it is in another spelling."""
        given = str(raw).strip() if isinstance(raw, str | int | float) and not isinstance(raw, bool) else ""
        half = given.translate(TO_ASCII).strip()
        if half != given and self._within(half) == half:
            return unexpected(wanted, raw, Term("write", text=half))
        for pattern, meant in self.spellings.items():
            if len(given) <= MAX_NAME and (match := re.fullmatch(pattern, half)):
                text = match.expand(meant)
                if text.startswith("["):
                    return unexpected(wanted, raw, Term("write-bare", text=text))
                return unexpected(wanted, raw, Term("write", text=self._within(text) or text))
        return unexpected(wanted, raw)

    def _within(self, text: str) -> str | None:
        """A text with the expressions in it as they are meant, where it can be read as such a value and isn't itself in
        another spelling."""
        for _ in range(3):
            if any(re.fullmatch(pattern, text) for pattern in self.spellings):
                return None
            try:
                type(self)(text)
            except PydanticCustomError as error:
                found = error.context or {}
                hint, part = found.get("hint"), str(found.get("text", ""))
                if found.get("code") != "expression.respelled" or not isinstance(hint, Term) or part not in text:
                    return None
                text = text.replace(part.strip(), str(hint.data["text"]).strip())
            else:
                return text
        return None

    def set_attribute(self, name: str, value: Any) -> None:
        """Set an attribute, while the value is being made."""
        object.__setattr__(self, name, value)

    def __setattr__(self, name: str, value: Any) -> None:
        raise TypeError("a mechanism is immutable; build a new one")

    __delattr__ = __setattr__  # type: ignore[assignment]

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Written) and type(self) is type(other) and self.raw == other.raw

    def __hash__(self) -> int:
        return hash((type(self), self.raw))

    def __repr__(self) -> str:
        return f"{type(self).__name__}({self.raw!r})"

    def __reduce__(self) -> tuple[Any, ...]:
        return (type(self), (self.raw,))

    @classmethod
    def __get_pydantic_core_schema__(cls, source: Any, handler: GetCoreSchemaHandler) -> CoreSchema:
        return core_schema.no_info_plain_validator_function(
            lambda raw: raw if isinstance(raw, cls) else cls(raw),
            serialization=core_schema.plain_serializer_function_ser_schema(lambda value: value.raw),
        )

    @classmethod
    def __get_pydantic_json_schema__(cls, schema: CoreSchema, handler: GetJsonSchemaHandler) -> dict[str, Any]:
        return dict(cls.json_type)
