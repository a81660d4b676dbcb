"""Words of the export to Process Simulate."""

TEXTS: dict[str, str] = {
    "functions.head": "# {title}: joint functions for Process Simulate, dialect {dialect}",
    "functions.units": "# Units: rad and mm. Each function is one line of text and belongs to the joint named above it.",
    "functions.proof": "# Checked against the solver over the whole range: maximum deviation {error} with {decimals} decimals.",
    "functions.master": "# {master} is the master instead of the joint moved by {drive}: over this range its motion doesn't reverse.",
    "functions.mirror": "# Two mirrored hinges that move together: {master} drives, and {follower} on the second one follows it.",
    "functions.compared": "# Functions of cams contain comparisons, >= and <: 1 where true, 0 elsewhere.",
    "functions.fitted": "# Polynomials approximate joints without a closed form; their errors are listed.",
    "functions.driving": "{name}: driving joint, {kind} of {child} on {parent} (joint {joint}), {way}; limits {limits}",
    "functions.joint": "{name}: {kind} of {child} on {parent} (joint {joint}), {way}; limits {limits}; maximum deviation {error}",
    "functions.helper": "{name}: auxiliary joint D of a link without geometry, any axis; limits {limits}",
    "functions.T+": "positive counter-clockwise",
    "functions.T-": "positive clockwise",
    "functions.D+": "positive along the line",
    "functions.D-": "positive against the line",
    "functions.snippet": "Assign the joints by name; the tool takes each text without quotes.",
    "functions.done": "{count} joint functions in dialect {dialect}: maximum deviation {error} (rad or mm) with {decimals} decimals; the longest has {longest} characters.",
}
