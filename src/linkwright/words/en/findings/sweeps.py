"""Problems of sweeps."""

PROBLEMS: dict[str, tuple[str, str]] = {
    "study.needs-cycle": (
        "The study {study} uses the motion of the file's cycle, but the file has no cycle.",
        "Add one beside it, for example cycle: {{turns: 1 motor, samples: 360}}.",
    ),
    "study.one-value": (
        "There is nothing to vary: {count} value(s).",
        "Give at least two values; parameters that don't vary aren't listed.",
    ),
    "study.sigma": (
        "The standard deviation {sigma} isn't positive.",
        "Give a positive value in the parameter's unit.",
    ),
    "study.cut-distribution": (
        "The distribution is truncated to a range that contains less than {share:g} of it.",
        "Widen the range from low to high, or move the mean.",
    ),
    "study.triangle": (
        "The low, most likely and high values of a triangular distribution must be in increasing order: {values}.",
        "Give them in this order; the most likely value may equal one of the limits.",
    ),
    "study.plan": (
        "{name} has a distribution, which the plan {plan} doesn't support.",
        "Give it steps or a list, or use another plan: latin, sobol, random.",
    ),
    "study.grid-samples": (
        "The plan {plan} computes all combinations, so its number of samples can't be set.",
        "Remove samples, or use another plan: latin, sobol, random.",
    ),
    "study.too-many-samples": (
        "There are {count} samples; the limit of the plan {plan} is {limit}.",
        "Use fewer values or samples; for distributions, the plan random allows the most.",
    ),
    "study.no-output": (
        "'{text}' is neither a measure of this file nor an expression of signals.",
        "{near} An output is a measure, a signal such as E.x, or an expression of signals.",
    ),
    "study.no-outputs": (
        "The sweep has no outputs: the file has no measures.",
        "Add measures, or list signals under outputs.",
    ),
    "study.varied-span": (
        "The length of the run depends on {name}, which isn't the same in all samples.",
        "Give the length as a constant, for example cycle: {{duration: 1.5 s}}, or don't vary that parameter.",
    ),
    "study.no-folder": (
        "More than {limit} values would have to be kept in memory.",
        "Give a folder to write them to, with --out or out=...; or set keep: reduced.",
    ),
    "study.too-many-values": (
        "The study would keep {rows} rows of {columns} values, which takes about {needed} GB of memory; at most "
        "{allowed} GB, one part in {share} of what is available, is used.",
        "Set {key} to {most} at most; or run it on a machine with more memory.",
    ),
    "study.no-value": (
        "In {count} of {samples} samples a measure or signal has no finite value, although the motion can be "
        "followed; the first one is sample {sample}.",
        "Check for a singular position, a cam that locks its follower, a division by zero or a window that isn't "
        "reached; or narrow the ranges.",
    ),
    "study.never-a-value": (
        "In every one of the {samples} samples a measure or signal has no finite value, although the motion can be "
        "followed.",
        "Check the measures at the nominal values first: for a singular position, a cam that locks its follower, a "
        "division by zero or a window that isn't reached.",
    ),
    "study.alone": (
        "The study {study} is for structures without drives, but {name} needs a motion.",
        "Move {name} to a file of its own, with a drive.",
    ),
    "reactions.drives": (
        "The mechanism is driven by {names}, but the study reactions is for structures without drives.",
        "Write studies: {{cycle: ...}} for the forces of a motion, or remove the drives.",
    ),
    "reactions.time": (
        "The time '{text}' is neither zero nor a positive number.",
        "Write a time, for example at: 0.5 s.",
    ),
    "reactions.several-poses": (
        "The links have at least {count} assembly modes, and none is selected.",
        "Give the positions of the points in sketch, or a side under assembly.",
    ),
    "reactions.not-closed": (
        "The joints of the structure can't all close: in the best pose found, the closure error is {miss} {unit}.",
        "Correct the lengths, or give the positions of the points in sketch.",
    ),
    "reactions.phased": (
        "The links can only be assembled simultaneously; then the relative position that {name} ({kind}) keeps from "
        "the drawn pose isn't known.",
        "Give the positions of the points in sketch or under assembly, so that the links can be assembled one after "
        "the other.",
    ),
    "reactions.not-finite": (
        "The loads on {links} have no finite value.",
        "Check for a table evaluated outside its range, or a division by zero; the option at sets the time of the "
        "loads.",
    ),
    "reactions.moves": (
        "The structure isn't in equilibrium: its joints allow a motion of {links}, on which the loads do work.",
        "Add a support or a bar that constrains these links, or correct the dimensions.",
    ),
    "reactions.indeterminate": (
        "The structure is statically indeterminate to degree {degree}: reactions of {joints} depend on the stiffness of "
        "its parts and have no value here.",
        "No change is needed. To get all reactions, give the stiffness of the joints (stiffness), or release supports (let "
        "one end slide) until the structure is statically determinate.",
    ),
    "reactions.shared": (
        "The structure is statically indeterminate to degree {degree}. {sharing}",
        "No change is needed.",
    ),
    "reactions.neutral": (
        "The joints allow motions ({motions}) on which the loads do no work: the structure is in equilibrium only "
        "under these loads.",
        "Add a support or a bar if it must carry other loads too.",
    ),
    "reactions.no-load": (
        "No load acts on the structure, so all its reactions are zero.",
        "Add loads, springs, or gravity with masses.",
    ),
    "reactions.unproven": (
        "Verification failed: relative closure error or equilibrium residual {residual} (limit 1e-9).",
        "Check for links that are nearly collinear: there, small errors of lengths cause large forces.",
    ),
    "reactions.measures": (
        "The study reactions evaluates no measures: {names}.",
        "Read the reactions from its table, or remove the measures.",
    ),
    "study.none": (
        "The file has no study.",
        "Add one, for example studies: {{cycle: {{period: 1.5 s, samples: 200}}}}.",
    ),
}
