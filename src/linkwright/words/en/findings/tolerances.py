"""Problems of tolerances."""

PROBLEMS: dict[str, tuple[str, str]] = {
    "tolerance.unknown-class": (
        "'{given}' is neither a tolerance class nor a parameter of this file.",
        "Write a number, [lower, upper], or a class such as {known}.",
    ),
    "tolerance.class-or-parameter": (
        "{name} is both a tolerance class and a parameter of this file.",
        "Rename the parameter; or write ({name}) if the parameter is meant.",
    ),
    "tolerance.distribution": (
        "'{given}' isn't a distribution of a tolerance.",
        "Write one of: {known}.",
    ),
    "tolerance.cp-and-sigma": (
        "Both cp and sigma are given, but each of them defines the width of the distribution.",
        "Keep one of them.",
    ),
    "tolerance.no-sigma": (
        "The width of a {name} distribution follows from the limits; cp and sigma don't apply.",
        "Remove them, or write distribution: normal or truncated.",
    ),
    "tolerance.cp": (
        "The capability cp = {cp} isn't positive.",
        "Give a positive number; 1 means that the limits are six standard deviations apart.",
    ),
    "tolerance.limits": (
        "The limits {given} don't define a tolerance: the lower limit must be below the upper one.",
        "Give a positive number for plus and minus, or [lower, upper]; for a fixed deviation, change the value itself.",
    ),
    "tolerance.too-large": (
        "The tolerance reaches {limit} {unit}; it must be smaller than the dimension itself ({nominal} {unit}).",
        "Correct the tolerance or its unit. Give a coordinate that may be zero as zero.",
    ),
    "tolerance.derived": (
        "{name} is computed from other parameters ({text}), so it can't have a tolerance of its own.",
        "Give the tolerance to these parameters, or add a parameter for the error to the expression, such as "
        "{name}_error: 0.",
    ),
    "tolerance.size": (
        "{given} has no tolerance for {asked} {unit}: it covers {low} to {high} {unit}.",
        "Use another class, or give the limits.",
    ),
    "tolerance.side": (
        "{given} defines the tolerance of an angle by the length of its shorter side, which is missing.",
        "Give it beside the limits, for example side: 60 mm; or give the limits as numbers.",
    ),
    "tolerance.class-dimension": (
        "{given} has tolerances of lengths only (a general class of angles too), and {name} isn't one.",
        "Give the limits as a number or [lower, upper].",
    ),
    "tolerance.missing": (
        "{name} is listed as a deviation but has no tolerance, and there is no general tolerance for it.",
        "Give it a tolerance under parameters; or write general: ISO 2768-m, which covers lengths, and angles with a "
        "side.",
    ),
    "tolerance.named-twice": (
        "{name} is listed twice.",
        "List each parameter once.",
    ),
    "tolerance.none": (
        "No tolerances are defined, and there is no change of temperature.",
        "Define dimensions under parameters and give them a tolerance, for example AB: {{value: 155, tolerance: "
        "0.05}}; or write general: ISO 2768-m.",
    ),
    "tolerance.skipped": (
        "{general} has no tolerance for the size of {names}, so these are treated as exact.",
        "If they deviate, give them tolerances of their own.",
    ),
    "tolerance.no-derivative": (
        "{text} has no derivative at the nominal dimensions, so deviations can't be propagated through it.",
        "Write it in a different form, or give this parameter's value as a number.",
    ),
    "tolerance.no-contributor": (
        "No deviation is called {name}.",
        "{near} Use a parameter with a tolerance, or a change of temperature.",
    ),
    "tolerance.correlation-twice": (
        "{name} is listed twice in one correlation.",
        "List each deviation once; its correlation with itself is always 1.",
    ),
    "tolerance.correlation-pair": (
        "The correlation of {names} is already given in an entry before this one.",
        "Give each pair once.",
    ),
    "tolerance.correlation-shape": (
        "The correlation matrix of {count} names needs {count} rows of {count} numbers.",
        "Give all of them, including the diagonal; or one number for all pairs.",
    ),
    "tolerance.correlation-range": (
        "The correlation coefficient {value} lies outside -1 to 1.",
        "Give a value within this range.",
    ),
    "tolerance.correlation-diagonal": (
        "The diagonal of the correlation matrix must be 1.",
        "Write 1 there: the correlation of a deviation with itself is always 1.",
    ),
    "tolerance.correlation-symmetry": (
        "The correlation matrix isn't symmetric.",
        "Give the same coefficient for a pair in both of its positions.",
    ),
    "tolerance.correlation-indefinite": (
        "These correlations aren't possible: the correlation matrix has the eigenvalue {least}, and none may be "
        "negative.",
        "Correct the coefficients: two deviations that are each closely correlated with a third are also correlated "
        "with each other. Pairs that aren't given count as 0.",
    ),
    "tolerance.material-or-expansion": (
        "A change of temperature needs exactly one of the material and its expansion coefficient.",
        "Write material: steel; or expansion: 11.5, in 1e-6/K.",
    ),
    "tolerance.material": (
        "The expansion coefficient of '{given}' isn't known.",
        "{near} Otherwise write expansion: with the coefficient in 1e-6/K.",
    ),
    "tolerance.thermal-name": (
        "A parameter has the same name as this change of temperature.",
        "Rename one of the two.",
    ),
    "tolerance.no-length": (
        "Nothing expands: the file has no parameter that is a length and isn't computed from others.",
        "Define lengths under parameters.",
    ),
    "tolerance.not-a-length": (
        "{name} isn't a length, so it doesn't expand.",
        "Name lengths only.",
    ),
}
