"""Problems of assembly and motion."""

PROBLEMS: dict[str, tuple[str, str]] = {
    "assembly.slides-parallel": (
        "The slides {joints} of {link} are parallel, so its position along them is undetermined.",
        "Correct the angles in line, or drive {link}.",
    ),
    "assembly.missing": (
        "{links} have two assembly modes, and none is selected.",
        "Add to assembly: {options}. Or give the point's position in a sketch: [x, y].",
    ),
    "assembly.contradiction": (
        "These rules select both assembly modes of the same pair of links: {rules}.",
        "Keep one of them.",
    ),
    "assembly.unused": (
        "The rule for {point} doesn't apply to any pair of links with two assembly modes.",
        "Remove it, or name the pin in the middle of such a pair.",
    ),
    "assembly.wrong-pins": (
        "The rule for {point} doesn't name the outer joints of its pair of links.",
        "Write {options}.",
    ),
    "assembly.not-four-bar": (
        "'open' and 'crossed' apply only to four-bar linkages, and {point} isn't the pin of one.",
        "Write {options}.",
    ),
    "assembly.ambiguous": (
        "At the start, the rule for {point} fits both assembly modes equally well.",
        "Write {options}. Or start at another pose.",
    ),
    "assembly.cannot-close": (
        "{links} can't be assembled at the start: {joints} are {distance} {unit} apart, {short}.",
        "{lengths}; or start at another pose.",
    ),
    "assembly.degenerate": (
        "{links} have no unique pose at the start: their joints {joints} coincide, or their lines are parallel.",
        "Correct the points and lines of these links; or start at another pose.",
    ),
    "assembly.no-sketch": (
        "{links} can only be assembled simultaneously and have several assembly modes; none is selected.",
        "Run 'linkwright modes FILE': it lists the modes, each with the lines to copy. Or give the positions of the "
        "pins {pins} in a pose near the start, under assembly: '{first}: [x, y]' and so on.",
    ),
    "assembly.not-found": (
        "No assembly of {links} was found at the start near {where}.",
        "Check the lengths, and sketch the pins at their positions at the start of the motion.",
    ),
    "assembly.singular-start": (
        "At the start, {links} close near {where}, but in a singular position: two assembly modes meet there, so "
        "that neither the rates nor the forces are defined.",
        "Start at another pose. If the links are in this position all along, change a length, or replace one of their "
        "joints, so that they aren't in line with their guides.",
    ),
    "assembly.out-of-reach": (
        "The point {point} is out of reach at the start: its prescribed position is {distance} from the pin {pin}, and {links} "
        "{short}.",
        "Change the position at the start, move the pin {pin}, or change the lengths of the links.",
    ),
    "assembly.no-mode": (
        "The links have no assembly mode at this pose of the drives.",
        "Check the lengths, or use another pose: another start of the drive, or studies.modes.at.",
    ),
    "motion.stuck": (
        "At t = {time} s ({drive} = {value} {unit}) the Assur group {group} reaches a singular position, so the "
        "motion can't be followed further.",
        "Change the lengths, or keep the motion away from this position.",
    ),
    "motion.cannot-assemble": (
        "{links} can't be assembled between {drive} = {from} and {to} {unit}: {joints} are {distance} {length_unit} "
        "apart, {short}.",
        "{lengths}; or keep {drive} out of that range.",
    ),
    "motion.out-of-reach": (
        "{drive} can't follow its law from t = {time} to {until} s: the law reaches {worst} {unit}, but the links "
        "limit the motion to {from} {unit} (and to {to} {unit} at the end of that time). {joints} of {links} would be "
        "{distance} {length_unit} apart, {short}.",
        "{lengths}; or keep the law of {drive} within this limit.",
    ),
    "motion.dead-centre": (
        "At t = {time} s ({drive} = {value} {unit}) {motors} is at a dead centre relative to {drive}: it doesn't "
        "move while {drive} does, so its force or torque can't move or hold {drive} there.",
        "Keep the law of {drive} on one side of {value} {unit}, or let the drive act at another joint.",
    ),
    "motion.singular": (
        "At t = {time} s ({drive} = {value} {unit}) {group} reaches a singular position, a change point or dead "
        "centre (determinant {determinant}): the motion can continue in two ways; velocities and forces are "
        "undefined there.",
        "If the motion should continue smoothly (a parallelogram stays one), write through: keep in studies: cycle. "
        "Otherwise guide the links with a third crank or a drive, change the lengths, or keep the motion away from "
        "this position.",
    ),
    "motion.singular-throughout": (
        "{group} is in a singular position in all poses of the motion: its two assembly modes coincide everywhere, so "
        "its rates and forces are undefined.",
        "Change a length or a distance of the joints, so that the links aren't in line with their guides all the time; "
        "or replace one of the joints by a rigid connection and let another one slide.",
    ),
    "motion.redundant-joints": (
        "The motion is computed without redundant constraints of {joints}. Only the remaining constraints have this "
        "singular position: with {joints} the mechanism may move through it.",
        "End the motion before this position, or write through: keep in studies: cycle.",
    ),
    "motion.cannot-carry": (
        "At t = {time} s ({drive} = {value} {unit}) {group} is in a singular position through which the motion can't "
        "be continued: the neighbouring poses don't define its limit.",
        "Make the drives move smoothly through this position, without a stop or a jump of the acceleration, and the "
        "loads too, without the end of a window or a corner of a table there; or avoid it with other lengths or "
        "another range of the drives.",
    ),
    "motion.starts-at-change-point": (
        "The motion starts at a change point of {group} (t = {time} s, {drive} = {value} {unit}), where its two "
        "assembly modes coincide. The rule '{rules}' selects the mode in which it continues.",
        "Check in the drawing that this is the intended motion, or start at another pose.",
    ),
    "motion.unbounded-forces": (
        "At the change point of {group} at t = {time} s ({drive} = {value} {unit}) forces grow without limit, "
        "because no link can turn another there: {signals}. They have no value at that instant.",
        "Transmit the load by other means: a third crank out of line with these two, a flywheel or gears take a "
        "parallelogram through its change point.",
    ),
    "motion.near-change-point": (
        "At t = {time} s ({drive} = {value} {unit}) {group} passes close to a change point (determinant "
        "{determinant}): a small error of a length or a clearance decides in which assembly mode the motion "
        "continues.",
        "If a parallelogram or a similar mechanism is intended, make the lengths match exactly (and write through: "
        "keep); otherwise keep farther away.",
    ),
    "motion.unproven": (
        "Verification failed: relative error {figure} in {check} (limit 1e-9).",
        "Check for dimensions of very different size, a point far away, or a nearly singular position; the "
        "certificate in the report gives details. If there is none, please report the model as a bug of linkwright.",
    ),
    "motion.unknown-value": (
        "Verification failed: {signal} has no finite value at t = {time} ({drive} = {value} {unit}), so that these "
        "can't be checked: {checks}.",
        "Check the numbers from which it is computed for a wrong unit or power of ten; or keep the motion away from "
        "this position.",
    ),
    "motion.unknown-between": (
        "Verification failed: between the samples of the run a signal has no finite value, so that these can't be "
        "checked: {checks}.",
        "Take more samples, which shows where; check tables, coefficients and loads for values that are not defined.",
    ),
    "motion.small-margin": (
        "At t = {time} s ({drive} = {value} {unit}) {group} is close to a singular position (margin {margin}; 1 is "
        "best, 0 singular): forces are large there, and small errors of lengths move the links far.",
        "Keep the motion farther away from this position, or change the lengths.",
    ),
    "motion.check-fails": (
        "Verification failed: {check} is {figure} (required: {required}).",
        "Check for dimensions of very different size or a nearly singular position; the certificate in the report "
        "gives details. If there is none, please report the model as a bug of linkwright.",
    ),
    "motion.not-periodic": (
        "The motion isn't periodic: after {period}, point {element} is {distance} {unit} from its start.",
        "Correct the period, or give duration instead of period.",
    ),
}
