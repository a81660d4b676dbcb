"""Words of the export to Process Simulate."""

PROCESS_SIMULATE: dict[str, str] = {
    "process-simulate.head": "# {title}: joint functions for Process Simulate, dialect {dialect}",
    "process-simulate.units": (
        "# Radians and mm. A function is the text of its line, and belongs to the joint named above it."
    ),
    "process-simulate.proof": "# Held against the solver over the whole range: off by {error} at most, with {decimals} decimals.",
    "process-simulate.fitted": "# Polynomials stand for joints that have no closed form; the errors say how close they come.",
    "process-simulate.driving": (
        "{name}: the driving joint, {kind} of {child} on {parent} (joint {joint}), {way}; limits {limits}"
    ),
    "process-simulate.joint": (
        "{name}: {kind} of {child} on {parent} (joint {joint}), {way}; limits {limits}; off by {error} at most"
    ),
    "process-simulate.helper": "{name}: a helping joint D of a link without geometry, any axis; limits {limits}",
    "process-simulate.T+": "positive counter-clockwise",
    "process-simulate.T-": "positive clockwise",
    "process-simulate.D+": "positive along the line",
    "process-simulate.D-": "positive against the line",
    "process-simulate.snippet": "Fill the joints in by name; the tool takes each text without quotes.",
    "process-simulate.done": (
        "{count} joint functions in the dialect {dialect}: off by {error} (rad or mm) at most with {decimals} decimals; "
        "the longest has {longest} characters."
    ),
}
