"""Problems of many parameter sets of one mechanism."""

PROBLEMS: dict[str, tuple[str, str]] = {
    "varied.slides": (
        "The directions of the slides {loop} agree only for the given value of {name}: for any other value, their "
        "loop can't be assembled.",
        "Write both lines of each slide with {name}, or don't vary it.",
    ),
    "varied.passage": (
        "The motion continues through a change point (through: keep), which another value of {names} would shift.",
        "Vary only the parameters of a motion without change points.",
    ),
    "varied.table": (
        "The x values or the period of the table {table} depend on {names}, which vary.",
        "Write these numbers explicitly, or don't vary what they depend on; the table's values may vary.",
    ),
    "varied.second": (
        "{names} vary in the law {law}, which determines the position of the second contact of {name}; that position "
        "is computed once, for the nominal values.",
        "Give the position of the second contact under second, or don't vary the law.",
    ),
    "varied.locked": (
        "{where} is read from the file with the value of {name}; the report doesn't recompute it.",
        "Change {name} in the file, then run it again.",
    ),
    "varied.drawn": (
        "{name} also changes the position in which {joint} is assembled (how the teeth mesh, where the contact starts); "
        "the report doesn't recompute that.",
        "Change {name} in the file, then run it again.",
    ),
    "varied.whole": (
        "{where} is a whole number; no slider moves {name}.",
        "Change {name} in the file, then run it again.",
    ),
    "varied.values": (
        "{count} of {samples} samples have values that aren't valid in the model; in the first one, {sample}: {what}",
        "Narrow the ranges of the varied parameters, or define dependent dimensions as expressions of them.",
    ),
    "varied.drive": (
        "In {count} of {samples} samples the law of {drive} has no finite value; in the first one, {sample}, at "
        "t = {time} s.",
        "Narrow the ranges of the parameters in its position, or change the law.",
    ),
    "varied.cannot-assemble": (
        "{count} of {samples} samples can't be assembled; the first one is {sample}, at t = {time} s: there {joints} "
        "of {links} are {distance} {unit} apart, {short}.",
        "Narrow the ranges of the varied lengths, or use only the remaining samples.",
    ),
    "varied.stuck": (
        "{count} of {samples} samples can't be followed; in the first one, {sample}, the Assur group {group} can't "
        "be followed to t = {time} s: it reaches a singular position between the nominal dimensions and those of the "
        "sample.",
        "Narrow the ranges of the varied parameters, or use only the remaining samples.",
    ),
    "accuracy.position": (
        "'{text}' isn't a position.",
        "Write 'max E.x' or 'min E.x' with a signal, 'start of W' or 'end of W' with a window, or a time.",
    ),
    "accuracy.no-derivative": (
        "There is no derivative of the reduction {reduction}, so tolerances can't be carried to the measure {name}.",
        "Name other outputs of the study.",
    ),
    "accuracy.outside-run": (
        "The position '{text}' isn't between 0 and {stop} {unit}, the run of the cycle.",
        "Give a time within the run.",
    ),
    "accuracy.correlation-limit": (
        "The deviations of {names} can't have the correlation {stated}: their distributions differ, and the limit "
        "for these is {limit}.",
        "Give a smaller correlation, or the same distribution for both.",
    ),
    "accuracy.correlation-adjusted": (
        "These distributions can't have all the given correlations at the same time; the samples use the nearest "
        "ones that are possible (the correlations of their normal scores change by {change} at most).",
        "Give smaller correlations, or normal distributions.",
    ),
    "accuracy.samples-fail": (
        "{count} of {samples} random samples within the tolerances have no value of some output: {share} % (of the "
        "whole production {low} to {high} %, with 95 % confidence). The results of each output use only the samples "
        "that have it.",
        "Narrow the tolerances, or change the dimensions so that the mechanism can be assembled with all of them.",
    ),
    "accuracy.points-fail": (
        "{count} of {samples} samples within the tolerances have no value of some output: {share} %. The results of "
        "each output use only the samples that have it.",
        "Narrow the tolerances, or change the dimensions so that the mechanism can be assembled with all of them. "
        "Use the plan random or latin to get a confidence interval of this share.",
    ),
    "accuracy.law": (
        "If only {names} deviates, the motion law {law} no longer adds up to its period, closes, or stays continuous.",
        "Make other numbers of the law depend on it: {{dwell: 360 deg - w}} beside {{rise: h, over: w}}, with the "
        "same h in the fall.",
    ),
    "accuracy.table": (
        "If only {names} deviates, the table {table} no longer closes over its period.",
        "Give its first and its last value the same expression.",
    ),
    "accuracy.vertices-fail": (
        "In the search for the worst case, the mechanism can't be assembled or followed at {lost} of {looked} points "
        "within the tolerances: the worst case covers only the points where it can.",
        "Narrow the tolerances, or change the dimensions so that the mechanism can be assembled with all of them.",
    ),
}
