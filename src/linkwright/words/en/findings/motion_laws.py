"""Problems of motion laws."""

PROBLEMS: dict[str, tuple[str, str]] = {
    "law.unknown": (
        "There is no motion law called '{name}'.",
        "{near} Otherwise give fractions, powers or a formula instead of law.",
    ),
    "law.segment": (
        "The kind of the segment isn't clear; found: {given}.",
        "Give exactly one of {known}.",
    ),
    "law.keys": (
        "{given} isn't allowed in a segment of this kind ({head}).",
        "Remove it, or put it into a segment of its own.",
    ),
    "law.no-over": (
        "The length of the segment along the axis is missing.",
        "Add over, for example over: 90 deg.",
    ),
    "law.way": (
        "The shape of the segment must be defined exactly once; found: {given}.",
        "Give exactly one of {known}; match, from, to, via and spline can be combined.",
    ),
    "law.argument-taken": (
        "In a formula, {name} runs from 0 to 1 over the segment, but a parameter is also called {name}.",
        "Rename the parameter.",
    ),
    "law.formula": (
        "'{name}' isn't allowed in the formula of a motion law.",
        "Use u, which runs from 0 to 1 over the segment, parameters and functions.",
    ),
    "law.place": (
        "The motion law '{name}' is called outside the position of a drive.",
        "Call it in the position of a drive or in the load of a cam study; in measures and loads of the model, use "
        "the drive's value.",
    ),
    "law.over": (
        "The segment's length along the axis isn't positive, or is out of range.",
        "Give it a length between 1e-12 and 1e12 s or rad.",
    ),
    "law.via": (
        "The points in via must be in increasing order and apart from each other, between the segment's start and end.",
        "Sort them; their positions are measured from the segment's start.",
    ),
    "law.conditions": (
        "One polynomial would have to satisfy {count} conditions; the limit is {limit}.",
        "Remove points, add spline: quintic, or split the segment.",
    ),
    "law.end-rates": (
        "A spline of degree {degree} needs {wanted} derivatives at each end.",
        "Give this number in from and to, or use match: velocity with spline: cubic, match: acceleration with "
        "spline: quintic.",
    ),
    "law.not-normal": (
        "The formula is {start} at u = 0 and {end} at u = 1; it must be 0 and 1.",
        "Subtract its value at u = 0, then divide it by its rise.",
    ),
    "law.not-smooth": (
        "The formula, or one of its first two derivatives, has no finite value somewhere between u = 0 and u = 1.",
        "Check it for a division by zero, or a root at zero.",
    ),
    "law.powers": (
        "A power is given twice.",
        "Give each power once.",
    ),
    "law.fractions": (
        "The {count} fractions add up to {sum}; a law needs four [b, c, d, z], or seven, each 0 or at least 1e-6, "
        "with the sum 1 and some acceleration on both sides.",
        "Correct them: [0.25, 0, 0.75, 0] is the modified sine.",
    ),
    "law.skew": (
        "The law can't have its maximum velocity at {share} of the segment.",
        "Give a skew from 0.001 to 0.999, and only with a symmetric law.",
    ),
    "law.control": (
        "The B-spline has {given} control values; its degree needs at least {wanted}.",
        "Add control values, or use a lower degree.",
    ),
    "law.period": (
        "The segments add up to {sum} {unit}; the period is {period} {unit}.",
        "Correct their lengths, add a dwell, or give the period.",
    ),
    "law.not-closed": (
        "The law starts at {start} {unit} and ends at {end} {unit}, so it can't be repeated.",
        "Make the segments return to the start, or write beyond: advance (continues from there) or beyond: hold "
        "(stays there).",
    ),
    "law.values": (
        "With these values {law} isn't valid: its segments have no length, don't fit the period, don't return to the "
        "start, or its value or velocity jumps.",
        "Change the numbers that belong together, or run the file with these values for the place.",
    ),
    "law.open-end": (
        "At its {side} the segment takes its derivatives from segment {other}, where they aren't given either.",
        "Give them in one of the two, with from or to.",
    ),
    "law.end-acceleration": (
        "The law {law} ends with a non-zero acceleration, and the adjacent segment doesn't continue with the same one.",
        "Add its mirror image directly after it, a fall with the same law, height and length; or use a law that ends "
        "with zero acceleration.",
    ),
    "drive.law-jumps": (
        "The {what} of the motion law {law} jumps at {at} by {jump}; no drive can follow this.",
        "Use another law there, or blends that match the velocity: {{rise: ..., over: ..., match: acceleration}}.",
    ),
}
