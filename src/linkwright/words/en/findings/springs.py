"""Problems of springs."""

PROBLEMS: dict[str, tuple[str, str]] = {
    "spring.ends": (
        "The two ends of the spring aren't defined clearly.",
        "Give from and to (two points), or turns and on (two links) for a torsional spring.",
    ),
    "spring.law": (
        "A spring needs exactly one law, with or without damping; given: {given}.",
        "Give one of stiffness, force (torsional: torque), gas, or damping only.",
    ),
    "spring.stray": (
        "These keys aren't allowed in a spring of this kind: {keys}.",
        "Remove them; docs/file-format.md shows which keys belong together.",
    ),
    "spring.free": (
        "The spring's free length is missing.",
        "Add free: the length (torsional: the angle) at which the spring exerts its preload, or no force.",
    ),
    "spring.gas": (
        "The force at the maximum length alone doesn't define a gas spring: the rise of the force is missing.",
        "Add progression (force at the minimum length divided by force at the maximum length) and length: [minimum, "
        "maximum].",
    ),
    "spring.progression": (
        "The progression of a gas spring must be above 1: its force increases when it is compressed.",
        "Give the force at the minimum length divided by the force at the maximum length, usually 1.2 to 1.5.",
    ),
    "spring.same-link": (
        "Both ends are on the link {name}, so the spring has no effect.",
        "Choose a point or link elsewhere; if several links share a point, give the links under in: [LINK, LINK].",
    ),
    "spring.no-direction": (
        "At t = {time} s ({drive} = {value} {unit}) the two ends of the spring coincide, so its force has no "
        "direction.",
        "Move one of its points.",
    ),
    "spring.outside-length": (
        "At t = {time} s ({drive} = {value} {unit}) the spring is {length} {of} long; {low} to {high} {of} is allowed.",
        "Use a part with another stroke, or move its points. The spring's law is extrapolated beyond these limits.",
    ),
}
