"""Problems of units and expressions."""

PROBLEMS: dict[str, tuple[str, str]] = {
    "units.wrong": (
        "'{word}' isn't a unit of {quantity}.",
        "Write the abbreviation of a plain unit, for example {usual}.",
    ),
    "units.unknown": (
        "'{word}' isn't a known unit.",
        "{hint}",
    ),
    "expression.syntax": (
        "'{text}' can't be read as an expression: {reason}.",
        "Use + - * / ^ and brackets, as in '2*AB + 5 mm'; write * between factors.",
    ),
    "expression.respelled": (
        "'{text}' can't be read as an expression: {reason}.",
        "{hint}",
    ),
    "expression.units-conflict": (
        "'{part}' has the unit {given}, but {wanted} is expected here.",
        "Correct the unit or the parameter; a parameter takes its unit from its own value or from its other uses.",
    ),
    "expression.units-mixed": (
        "'{part}' combines the units {given} and {wanted}; such values can't be added.",
        "Write units with the numbers, or correct the parameter; parameters without a unit take it from their uses.",
    ),
    "expression.hertz": (
        "'{part}' counts events per second, so it isn't clear whether revolutions or radians are meant.",
        "Write rpm, r/s or deg/s for a speed; in sin and cos write 2*pi*{part}*t.",
    ),
    "expression.arguments": (
        "The function {name} has {given} arguments, but it takes {wanted}.",
        "Give {wanted} arguments, separated by commas.",
    ),
    "expression.unknown-function": (
        "There is no function, table or motion law called '{name}'.",
        "{near} Otherwise declare it under tables or laws.",
    ),
    "expression.unit-alone": (
        "'{name}' is a unit without a number, and no parameter has this name.",
        "Write the number before it, as in '1 {name}', or declare {name} under parameters.",
    ),
    "expression.undeclared-unit": (
        "A number has no unit here, and 'units' doesn't declare the unit of {quantity} (such numbers: {count}).",
        "Declare {base} under units, or write the unit after the number.",
    ),
    "expression.odd-unit": (
        "A number without a unit would be read in {dimension} here, which is rarely intended.",
        "Write the unit after the number.",
    ),
    "expression.not-constant": (
        "'{name}' changes while the mechanism moves, but a constant is expected here.",
        "Use only numbers, parameters and functions of them.",
    ),
    "expression.ambiguous-unit": (
        "In '{part}', '{word}' is read as a unit, but a parameter has the same name.",
        "To use the parameter, write it in brackets: '*({word})'. To use the unit, rename the parameter.",
    ),
    "parameters.cycle": (
        "These parameters depend on each other in a cycle: {cycle}.",
        "Give one of them as a number.",
    ),
    "parameters.value": (
        "'{text}' has no finite value: it divides by zero, takes a root of a negative number, or is too large.",
        "Check the numbers used in it.",
    ),
    "value.not-finite": (
        "'{text}' has no finite value: it divides by zero, takes a root of a negative number, or is too large.",
        "Check the numbers and parameters used in it.",
    ),
    "value.too-small": (
        "The {what} is {value} {unit}, which is too small.",
        "Give a positive value.",
    ),
    "value.rod": (
        "The ends {points} of the rod coincide.",
        "Use two different points, or write 'point' instead of 'rod'.",
    ),
    "value.not-rising": (
        "The interval from {low} to {high} is empty.",
        "Give the lower limit first.",
    ),
}
