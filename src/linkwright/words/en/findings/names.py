"""Problems of names."""

PROBLEMS: dict[str, tuple[str, str]] = {
    "name.unused-parameter": (
        "The parameter {name} isn't used: its value has no effect.",
        "{mend}",
    ),
    "name.unknown": (
        "'{name}' isn't {kind} of this mechanism.",
        "{near}",
    ),
    "name.unknown-point": (
        "The link {link} has no point called '{name}'.",
        "{near} Otherwise add the point to the link.",
    ),
    "name.unknown-element": (
        "No element of this mechanism is called '{name}'.",
        "{near}",
    ),
    "name.unknown-kernel": (
        "There is no kernel called '{name}'.",
        "{near}",
    ),
    "name.unknown-parameter": (
        "There is no parameter called '{name}'.",
        "{near} Otherwise declare it under parameters.",
    ),
    "name.taken": (
        "'{name}' is the name of both {first} and {second}, so signals such as '{name}.x' would be ambiguous.",
        "Rename one of the two.",
    ),
    "signal.no-attribute": (
        "'{attribute}' isn't a signal of {name}.",
        "{near}",
    ),
    "signal.indeterminate": (
        "The {attribute} in the slide {joint} isn't determined by statics: the slides {loop} constrain each other's "
        "direction, and a moment can circulate through all of them.",
        "Use the forces .x, .y or .normal instead, or pin one of the links to a sliding block.",
    ),
    "signal.no-joint": (
        "{a} and {b} aren't joined, so there is no force between them.",
        "Write one of these: {options}. If three links share a pin, name the pin as the second argument.",
    ),
    "signal.several-joints": (
        "{a} and {b} are connected by several joints: {joints}.",
        "Name the joint as the third argument: force({a}, {b}, JOINT).",
    ),
    "signal.several-elements": (
        "'{name}' is the name of several drives, loads, springs or friction, so its power is ambiguous.",
        "Rename all but one of them.",
    ),
    "signal.no-mass": (
        "'{name}' isn't a link with mass, so it has no centre of mass.",
        "Give the link a mass, or use one of its points.",
    ),
    "signal.same-link": (
        "'{name}' has no instant centre relative to itself.",
        "Name two different links: pole({name}, frame).x.",
    ),
    "signal.unknown": (
        "'{name}' isn't a signal.",
        "{hint}",
    ),
    "signal.element": (
        "'{name}' is {kind}, but one of its signals is expected.",
        "Write one of these: {signals}.",
    ),
}
