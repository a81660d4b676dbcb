"""Words of the export to Process Simulate."""

PROCESS_SIMULATE: dict[str, str] = {
    "functions.head": "# {title}: joint functions for Process Simulate, dialect {dialect}",
    "functions.units": (
        "# Radians and mm. A function is the text of its line, and belongs to the joint named above it."
    ),
    "functions.proof": "# Held against the solver over the whole range: off by {error} at most, with {decimals} decimals.",
    "functions.master": (
        "# {master} is the master in place of the joint that {drive} moves: over this range it goes one way only."
    ),
    "functions.mirror": "# Two mirrored hinges that move in step: {master} drives, and {follower} on the second one follows it.",
    "functions.compared": "# Functions of cams hold comparisons, >= and <: 1 where they hold, and 0 elsewhere.",
    "functions.fitted": "# Polynomials stand for joints that have no closed form; the errors say how close they come.",
    "functions.driving": (
        "{name}: the driving joint, {kind} of {child} on {parent} (joint {joint}), {way}; limits {limits}"
    ),
    "functions.joint": (
        "{name}: {kind} of {child} on {parent} (joint {joint}), {way}; limits {limits}; off by {error} at most"
    ),
    "functions.helper": "{name}: a helping joint D of a link without geometry, any axis; limits {limits}",
    "functions.T+": "positive counter-clockwise",
    "functions.T-": "positive clockwise",
    "functions.D+": "positive along the line",
    "functions.D-": "positive against the line",
    "functions.snippet": "Fill the joints in by name; the tool takes each text without quotes.",
    "functions.done": (
        "{count} joint functions in the dialect {dialect}: off by {error} (rad or mm) at most with {decimals} decimals; "
        "the longest has {longest} characters."
    ),
}
