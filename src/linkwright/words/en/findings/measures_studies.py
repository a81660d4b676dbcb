"""Problems of windows, measures and studies."""

PROBLEMS: dict[str, tuple[str, str]] = {
    "window.one-signal": (
        "A window needs exactly one signal; given: {count}.",
        "Write {{SIGNAL: [low, high]}} with one signal.",
    ),
    "window.signal": (
        "'{given}' isn't a signal such as motor.angle.",
        "Write {{SIGNAL: [low, high]}}, for example {{motor.angle: [0 deg, 90 deg]}}.",
    ),
    "window.outside": (
        "The window {name} lies outside the run.",
        "Correct the window, or make the study run longer.",
    ),
    "measure.reduction": (
        "A measure needs exactly one reduction of a signal; given: {given}.",
        "Give exactly one of: {known}.",
    ),
    "measure.where": (
        "'where' is required for 'value', and allowed only there.",
        "Write value and where together: {{value: crank.angle, where: max E.x}}.",
    ),
    "measure.within": (
        "'within' is required for 'dwell', and allowed only there.",
        "Write dwell and within together: {{dwell: E.x, within: 0.5 mm}}.",
    ),
    "measure.useful": (
        "'useful' is required for 'share', and allowed only there.",
        "Write share and useful together: {{share: [bearing_A], useful: [press]}}. For an efficiency: {{efficiency: [press]}}.",
    ),
    "measure.bad-where": (
        "'{given}' doesn't define an instant.",
        "Write one of: max SIGNAL, min SIGNAL, SIGNAL = VALUE (such as motor.angle = 24 deg), start, end.",
    ),
    "measure.unit": (
        "The value is in {wanted}; it can't be shown in {unit}.",
        "Use a unit of the same kind as {wanted}, or remove the unit.",
    ),
    "measure.table": (
        "The table '{name}' can't be used in a measure.",
        "Tables are for drives, loads and springs; write the measure in signals, t and parameters.",
    ),
    "measure.nothing": (
        "The measure {name} has no value: the run doesn't enter its window.",
        "Correct the window, or make the study run longer.",
    ),
    "measure.not-finite": (
        "The measure {name} has no finite value.",
        "Check its expression for a division by zero or a root of a negative number. Other possible causes are a "
        "singular position, or an instant centre at infinity or without motion.",
    ),
    "motion.too-many-turns": (
        "'{name}' makes too many turns in this run for its angle to be tracked continuously.",
        "Make the study run for a shorter time; a run whose only drive turns at constant speed has no such limit.",
    ),
    "motion.angle-too-large": (
        "'{name}' reaches {turns} revolutions in this run; double precision resolves angles only up to {limit} "
        "revolutions.",
        "Check its speed, law or factor for a wrong unit or power of ten; otherwise make the study run for a shorter "
        "time.",
    ),
    "measure.unbounded": (
        "The measure {name} is unbounded: {signal} grows without limit towards t = {time}.",
        "Choose a window without that instant, or measure the numerator and the denominator separately.",
    ),
    "measure.diverges": (
        "The measure {name} has no value: the integral of {signal} diverges at t = {time}.",
        "Choose a window without that instant.",
    ),
    "measure.undecided": (
        "{signal} may be unbounded near t = {time}; round-off prevents a decision, so the measure {name} has no value.",
        "Choose a window without that instant, or write the expression with fewer cancelling terms.",
    ),
    "measure.two-values": (
        "The measure {name} has two values: {signal} jumps at t = {time}, where it is evaluated.",
        "Evaluate it slightly earlier or later.",
    ),
    "measure.no-instant": (
        "The measure {name} has no value: the run never reaches the instant that its 'where' defines.",
        "Correct 'where' or the window, or make the study run longer.",
    ),
    "measure.useless": (
        "The measure {name} has no value: the useful loads do no work in the run or the window, so there is no efficiency.",
        "Name the loads that do the useful work, or choose a window in which they do; a load whose work cancels over a turn "
        "needs a window for its working stroke.",
    ),
    "measure.energy-from-others": (
        "The measure {name} has no value: other loads, which aren't named as useful, supply more energy than is lost, so the "
        "energy given by the drives isn't the whole input.",
        "Name these loads as useful too, or model what drives the mechanism as a drive.",
    ),
    "measure.unsettled": (
        "The search for {name} hadn't converged on its finest grid ({width}): digits or narrow peaks may be missing.",
        "Limit the measure to a window, or make the study run for a shorter time.",
    ),
    "study.unknown": (
        "There is no study called '{name}'.",
        "{near}",
    ),
    "study.missing": (
        "The file has no study {name}. Its studies: {has}.",
        "Add it to the file, for example 'studies: {{{name}: {example}}}'.",
    ),
    "study.options": (
        "The option {key} of the study {study} is invalid: {reason}.",
        "Correct it; docs/file-format.md lists the options of each study.",
    ),
    "study.choice": (
        "The option {key} of the study {study} can't be {given}.",
        "{near}",
    ),
    "study.not-in-sweep": (
        "'{name}' isn't available in the limits study: it moves one drive through its values at unit speed, without "
        "forces.",
        "Use positions, angles, travels and their derivatives; use forces and times in the measures of a cycle.",
    ),
    "study.cylinder-length": (
        "{drive} can't use its whole range: at {value} {unit} the cylinder {name} would have to be {by} "
        "{length_unit} {end} than possible: {length} {length_unit} between its pins; the limit is {limit} "
        "{length_unit}.",
        "Consider this when you read the range; studies.limits.ranges sets a smaller one.",
    ),
    "study.wide-range": (
        "The range of {drive} is wider than {limit} {unit}.",
        "Give a smaller range.",
    ),
    "motion.more-gaps": (
        "More intervals of the motion fail; the first {count} are listed.",
        "Fix the first one: the others usually repeat it in every turn.",
    ),
    "study.long-motion": (
        "{drive} travels {travel} {unit} in the motion of the cycle, but limit positions, maxima and minima of a motion "
        "are searched only up to a travel of {limit} {unit}. Those of each drive alone are complete.",
        "Give studies.cycle fewer turns or a shorter duration.",
    ),
}
