"""Texts for inputs that look like a mistake: gravity, starts, lengths, masses, speeds, modes; and for travel."""

PROBLEMS: dict[str, tuple[str, str]] = {
    "gravity.no-direction": (
        "Gravity has no direction: both numbers are zero.",
        "Write a direction, for example 'gravity: earth along [0, -1]'; remove gravity if there is none.",
    ),
    "gravity.size": (
        "Gravity is read as {given} = {si}, which is {times} times the earth's (9.80665 m/s²).",
        "If the earth's gravity is meant, write 'gravity: {earth}'.",
    ),
    "sketch.other-start": (
        "The drive {name} starts at {start}, but the sketch shows it at {drawn}: a difference of {off}.",
        "Remove 'start' to start as drawn. If this pose is intended, write 'start: {apart}'.",
    ),
    "sketch.other-position": (
        "The drive {name} starts at {start}, but the sketch shows it at {drawn}: a difference of {off}.",
        "Write the law from the drawn pose, 'position: sketch + ...'. If this pose is intended, begin it with "
        "'{apart}'.",
    ),
    "plausible.lengths": (
        "Lengths differ by a factor of {ratio}: {short} measures {low}, {long} {high}.",
        "Check the units of both. If the lengths are right, no change is needed.",
    ),
    "plausible.masses": (
        "Masses differ by a factor of {ratio}: {light} has {low}, {heavy} {high}.",
        "Check the units of both. If the masses are right, no change is needed.",
    ),
    "plausible.speed": (
        "The drive {name} turns at {speed} = {rpm} rpm: one turn takes {period}.",
        "Check the speed and its unit: a number alone is in {unit} here. For example, write 'speed: {example}'.",
    ),
    "plausible.unloaded": (
        "No link has a mass and nothing acts on the mechanism: all forces and torques are zero, those measured by {names} too.",
        "Give links a mass and its distribution (mass, shape), or add loads, springs or friction. If only the motion is of "
        "interest, no change is needed.",
    ),
    "plausible.mirrored": (
        "The rule '{rule}' selects the assembly mode of {links} that is mirrored relative to the sketch (point "
        "{point}).",
        "If the sketch is right, remove the rule or write '{other}'; if the rule is right, correct the sketch.",
    ),
    "plausible.coincident": (
        "The points {first} and {second} coincide during the whole run, but aren't joined.",
        "If this isn't intended, choose the other assembly mode; 'linkwright modes FILE' lists the modes. Or give a "
        "pin that is shared by both links the same name on both.",
    ),
    "plausible.antiparallelogram": (
        "The four-bar {links} has equal opposite sides ({lengths}), but runs as an antiparallelogram (crossed).",
        "If a parallelogram is intended, choose the other assembly mode{rule}.",
    ),
    "joint.travel": (
        "'travel' applies only to a prismatic joint; this is a pin.",
        "Remove travel.",
    ),
    "motion.travel": (
        "The slide {name} leaves its travel ({low} to {high} {length_unit}) at t = {leaves} s ({drive} = "
        "{leaves_value} {unit}); the largest excess is at t = {time} s ({drive} = {value} {unit}): {travel} "
        "{length_unit}, {by} {length_unit} {end} the limit.",
        "Limit the drive, change the dimensions, or give the slide a larger travel.",
    ),
}

TERMS: dict[str, str] = {
    "gravity": "earth, 'earth along [x, y]', or [gx, gy] such as [0, -9.81 m/s^2]",
    "below": "below",
    "above": "above",
    "or-rule": ": write '{rule}'",
}
