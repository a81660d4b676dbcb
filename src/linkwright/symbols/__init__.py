"""The expression graph: scalars that remember how they were made. See docs/theory.md, "Symbols"."""

from linkwright.symbols import simplification as _simplification  # noqa: F401  (it enters its rules)
from linkwright.symbols.collection import without_collection
from linkwright.symbols.derivatives import derivatives_along, jacobian
from linkwright.symbols.graph import depend_on, ordered, substituted
from linkwright.symbols.instructions import INPUT, OUTPUT, ExpressionStage, Instruction
from linkwright.symbols.operations import OPERATIONS, Operation
from linkwright.symbols.orthogonal import OrthogonalFactors
from linkwright.symbols.symbol import CONSTANT, Symbol, as_symbol, choice, symbols_of

__all__ = [
    "CONSTANT",
    "INPUT",
    "OPERATIONS",
    "OUTPUT",
    "ExpressionStage",
    "Instruction",
    "Operation",
    "OrthogonalFactors",
    "Symbol",
    "as_symbol",
    "choice",
    "depend_on",
    "derivatives_along",
    "jacobian",
    "ordered",
    "substituted",
    "symbols_of",
    "without_collection",
]
