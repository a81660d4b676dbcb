"""Problems of tolerances from targets and dimensions from measurements."""

PROBLEMS: dict[str, tuple[str, str]] = {
    "accuracy.cost": (
        "The cost law {law} can't have these coefficients: {given}.",
        "Give finite numbers: the first of several may be 0, all others must be positive; costs in a table may be 0.",
    ),
    "accuracy.no-contributor": (
        "{name} isn't a deviation of this study: its tolerance can't be allocated, and its deviation can't be "
        "estimated.",
        "{near} Otherwise give the parameter a tolerance, or general, and list it under parameters.",
    ),
    "accuracy.no-target": (
        "'{name}' isn't a result of this study.",
        "{near} An output of a signal at a position is 'E.x at POSITION'.",
    ),
    "accuracy.target": (
        "The target half-width {text} isn't positive, or is too large.",
        "Give the allowed deviation to either side, for example 0.5.",
    ),
    "accuracy.half-widths": (
        "The half-widths of a tolerance must be positive and increasing: {low}, {high}.",
        "Give between: [minimum, maximum], in the parameter's unit.",
    ),
    "accuracy.no-grade": (
        "ISO 286 has no half-width of {grades} for {name}: its grades cover lengths up to 3150 mm.",
        "Give a table of half-widths in {unit}: table: [[half-width, cost], ...]; or grades: false.",
    ),
    "accuracy.no-grade-between": (
        "No standard grade of {name} lies between {low} and {high} {unit}.",
        "Widen between, or give grades: false.",
    ),
    "accuracy.target-unreachable": (
        "{name} can't be kept within {wanted} {unit}: the minimum tolerances that are allowed give {best} {unit}.",
        "Allow smaller half-widths (between), give more parameters a cost law, or tighten the tolerances of those "
        "without one.",
    ),
    "accuracy.targets-loose": (
        "The maximum tolerances that are allowed meet all targets, so the targets have no effect.",
        "Set narrower targets, or allow larger half-widths (between).",
    ),
    "accuracy.no-choice": (
        "No combination of standard grades or processes meets the targets, although continuous half-widths do.",
        "Allow finer ones: widen between, or add processes to the tables.",
    ),
    "accuracy.not-optimal": (
        "The tolerances of minimum cost weren't found: the optimality conditions have a residual of {off} of the cost.",
        "Narrow the half-widths (between), or scale costs and targets to common magnitudes.",
    ),
    "accuracy.measured-source": (
        "Measurements need either a file or points.",
        "Give file: measured.csv, or points: [{{t: 0.1 s, E.x: 712.3}}, ...].",
    ),
    "accuracy.no-place": (
        "No column gives the position at which the outputs were measured; the columns are: {given}.",
        "Add one of these, or name it with at: {known}.",
    ),
    "accuracy.measured-unit": (
        "The unit {unit} doesn't fit {name}.",
        "Use a unit such as {usual}.",
    ),
    "accuracy.measured-number": (
        "In row {row} of the measurements, {name} isn't a number.",
        "Write a number with a decimal point; only cells of outputs may be empty.",
    ),
    "accuracy.nothing-measured": (
        "There are no measured outputs.",
        "Add a column for each output, and a row for each position.",
    ),
    "accuracy.empty-column": (
        "The column {name} has no values.",
        "Write numbers, or remove the column.",
    ),
    "accuracy.no-pose": (
        "Row {row} was measured at {name} = {value} {unit}, which the run doesn't reach.",
        "Correct the row, or make studies.cycle cover it.",
    ),
    "accuracy.several-poses": (
        "Row {row} was measured at a value that {name} has several times, in different poses: at {times}.",
        "Give the time t of each row instead, or make studies.cycle cover one direction of motion only.",
    ),
    "accuracy.sigma": (
        "The standard deviation {sigma} of measurements isn't positive.",
        "Give a positive value in the output's unit, or remove it: it is then estimated from the residuals.",
    ),
    "accuracy.not-measured": (
        "{name} isn't measured; measured outputs: {known}.",
        "Give sigma for measured outputs only.",
    ),
    "accuracy.few-measurements": (
        "There are {count} measurements for {parameters} deviations; at least {least} are needed.",
        "Measure at more positions, list fewer deviations under parameters, give sigma, or set prior: true.",
    ),
    "accuracy.sigma-open": (
        "The measurements of {name} aren't sufficient to estimate their standard deviation as well.",
        "Give it under sigma, or measure at more positions.",
    ),
    "accuracy.measured-without-value": (
        "An output has no finite value or derivative at a measured position of the nominal motion.",
        "Remove the rows near dead centres and other singular positions.",
    ),
    "accuracy.scale-open": (
        "The size of the mechanism isn't identifiable from the measurements: {names} may all be larger or smaller in "
        "proportion.",
        "Measure a length too, or remove one of them from parameters; only their ratios are estimated.",
    ),
    "accuracy.not-identifiable": (
        "{names} aren't identifiable separately: their deviations can cancel each other in every measured output.",
        "Measure another output or at other positions, or remove one of them from parameters.",
    ),
    "accuracy.no-effect": (
        "{name} isn't identifiable: it has no effect on the measured outputs, or far too little.",
        "Measure another output or at other positions, or remove it from parameters.",
    ),
    "accuracy.poor-fit": (
        "The residuals are larger than the given sigmas explain: chi-square is {ratio} times its degrees of freedom, "
        "which happens by chance with probability {share}.",
        "Check for outliers, or for a deviation that isn't listed under parameters; or give larger sigmas.",
    ),
    "accuracy.outliers": (
        "{count} measurement(s) deviate more than random errors explain; rows {rows}.",
        "Check these rows, and remove those that are wrong.",
    ),
    "accuracy.not-settled": (
        "The estimate hasn't converged: another step would change it by {step} of the tolerances' sigmas.",
        "Measure at more positions, or list fewer deviations under parameters.",
    ),
}
