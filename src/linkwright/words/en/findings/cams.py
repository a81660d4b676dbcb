"""Problems of cams in a model file."""

PROBLEMS: dict[str, tuple[str, str]] = {
    "cam.contact": (
        "The contact between the follower and the cam isn't defined clearly; given: {given}.",
        "Give roller with at (its centre), knife with a point of the follower, or face with a line of it.",
    ),
    "cam.second": (
        "A contact with a second disc is given, but the cam has closed: {closed}.",
        "Write closed: conjugate, or remove second.",
    ),
    "cam.second-twice": (
        "The second disc is defined by more than one of base, at and face: {given}.",
        "Give only one: the position of the follower's second contact, or the disc's base circle.",
    ),
    "cam.second-other": (
        "Both discs of a conjugate pair need the same kind of contact; the first has {first}, the second {given}.",
        "Give the second the same kind: a roller with at, an edge with at only, or a face.",
    ),
    "cam.same-link": (
        "Cam, follower and carrier must be three links: {cam}, {follower}, {on}.",
        "Name the link that carries the cam, the link that follows it, and the link on which both are guided.",
    ),
    "cam.no-shaft": (
        "The cam's link {cam} isn't pinned to {on}.",
        "Give both links a point of the same name on the camshaft's axis, or name another link under on.",
    ),
    "cam.no-motor": (
        "No drive with a law of its own turns {cam} on {on}.",
        "Add a drive that turns {cam} on {on}, without output; the cam's law is evaluated at its angle.",
    ),
    "cam.no-guide": (
        "The follower {follower} is neither pinned to {on} nor guided on it by a slide.",
        "Give both links a point of the same name, or add a prismatic joint between them.",
    ),
    "cam.law": (
        "The law {law} doesn't fit the follower ({given}).",
        "Use a law with over: angle, of: {of} and beyond: repeat.",
    ),
    "cam.period": (
        "The period of the law {law} is {period} {unit}; a cam needs a full turn, or a full turn divided by a whole "
        "number.",
        "Make the segments add up to a full turn, for example with a dwell.",
    ),
    "cam.side": (
        "The side on which the follower lies isn't clear: {given}.",
        "Write for example 'side: {meant}'.",
    ),
    "cam.askew": (
        "The face is {angle} {unit} from being perpendicular to the slide.",
        "Correct the angle of the face; only a face perpendicular to the slide is supported.",
    ),
    "cam.offset": (
        "The follower {follower} passes the shaft at an offset of {offset} {unit}; base circle and roller reach only "
        "{limit} {unit}.",
        "Use a larger base circle, or a smaller offset of the follower.",
    ),
    "cam.second-side": (
        "The second contact of {follower} must stay on the other side of the line from shaft to pivot over the whole "
        "lift: its arm or face is at {low} to {high} {unit} to this line; {least} to {most} {unit} is allowed.",
        "Move the second point or face, or change the second base circle.",
    ),
    "cam.second-height": (
        "The second contact of {follower} must stay beyond the shaft; at the maximum lift it is {height} {unit} from "
        "it on the side of the first contact.",
        "Move the second point or face farther away from the first.",
    ),
    "cam.second-base": (
        "The second contact of {follower} leaves a base circle of only {base} {unit} for its disc.",
        "Move the second contact farther from the shaft, or use a smaller second roller.",
    ),
    "joint.locks": (
        "The link moved by {joint} ({kind}) locks at t = {time} s ({drive} = {value} {unit}): {why}.",
        "Use a smaller lift or spread it over a longer range, so that the pressure angle stays below 90 deg.",
    ),
    "cam.lifts-off": (
        "The follower of the cam {joint} lifts off: keeping contact would need a pulling force of {force} {of} at t "
        "= {time} s ({drive} = {value} {unit}).",
        "Add a spring or use a stronger one, reduce the speed, or write closed: groove (conjugate, yoke) if the "
        "follower is form-closed.",
    ),
    "cam.locks": (
        "The follower of the cam {joint} locks at t = {time} s ({drive} = {value} {unit}): {why}.",
        "Use a smaller lift or spread it over a larger cam angle; or change the pivot, arm or base circle, so that "
        "the pressure angle stays below 90 deg.",
    ),
    "cam.loose": (
        "The yoke of the cam {cam} has a clearance of up to {play}; forces are computed without clearance.",
        "Use a law whose lifts half a turn apart have a constant sum, or a second disc: closed: conjugate.",
    ),
    "cam.reach": (
        "The arm of {follower} is {by} {unit} too long or too short for the base circle: with arm {arm} {unit} and "
        "centre distance {distance} {unit}, the roller centre can be {low} {unit} to {high} {unit} from the shaft; "
        "base circle and roller need {pitch} {unit}.",
        "Change the base circle, the arm or the centre distance until the required distance is within this range.",
    ),
    "cam.face": (
        "The face of {follower} can't touch the base circle: its radius {base} {unit} minus the face's offset {face} "
        "{unit} must be within the centre distance {distance} {unit}.",
        "Change the base circle, the offset of the face or the centre distance.",
    ),
    "cam.no-distance": (
        "The follower {follower} is pinned at the cam's shaft.",
        "Move the two pins apart.",
    ),
    "cam.no-arm": (
        "The point {point} is on the follower's own pivot.",
        "Name a point of the follower away from its pivot.",
    ),
    "study.cams": (
        "The study {study} moves each drive independently, but the followers ({names}) move with their drives.",
        "Remove the study, or replace each follower with a drive.",
    ),
    "study.paths": (
        "The study limits moves each drive alone, but {drives} follow a path ({names}) together.",
        "Remove the study from this file. In a copy, give these drives laws of their own instead of the path.",
    ),
    "study.follower": (
        "{name} is a follower: it moves with the drive {motor}, not independently.",
        "Name {motor} as the drive; its followers move with it.",
    ),
    "motion.cylinder-length": (
        "The cylinder {name} would have to be {by} {length_unit} {end} than possible: {length} {length_unit} between "
        "its pins at {time} s ({drive} {value} {unit}); the limit is {limit} {length_unit}.",
        "Limit the drive, move one of the cylinder's points, or use a cylinder with another stroke.",
    ),
    "drive.law": (
        "The motion of the drive isn't defined clearly.",
        "Give either speed and start (with an acceleration, if need be), or position as an expression in t.",
    ),
    "drive.start": (
        "Speed and start must be given together.",
        "Give both: speed (constant), and start (the value at t = 0). If a sketch defines the drive's value, start "
        "can be omitted.",
    ),
    "drive.acceleration": (
        "An acceleration alone doesn't define the motion.",
        "Add speed and start: the speed and the value at t = 0.",
    ),
    "drive.twice": (
        "The motion of {a} relative to {b} is already prescribed by {other}.",
        "Keep one of the two drives.",
    ),
    "drive.output": (
        "'{name}' can't be the output of a drive: it is neither a prismatic joint nor a link or path of this model.",
        "{near} An output is a prismatic joint, a link whose angle relative to the frame follows the law, or a path "
        "of two drives (paths).",
    ),
    "path.shape": (
        "A path has one shape: a line, an arc, or x and y; found {given}.",
        "Give one of them, e.g. 'line: [[0, 0], [100 mm, 0]]', 'arc: {{centre: [50, 80], radius: 20 mm}}', or both "
        "coordinates as expressions in t: 'x: 50 mm*cos(90 deg*t/(1 s)), y: 80 mm'.",
    ),
    "path.law": (
        "The coordinates x and y are the whole motion along the path, so {given} can't be given in addition.",
        "Remove it; or give line or arc, whose distance from the start the law prescribes.",
    ),
    "path.no-length": (
        "The line of the path starts and ends at the same position.",
        "Give two different positions: the second one determines the direction.",
    ),
    "path.drives": (
        "Exactly two drives must move the point along the path {name}; the drives with 'output: {name}': {count} {drives}.",
        "Give two drives this output, and no law of their own, e.g. "
        "'left: {{turns: crank1, on: frame, output: {name}}}'.",
    ),
    "path.two-laws": (
        "The drive {drive} follows from the path {path}, so it can't have a law of its own.",
        "Remove its speed, start, acceleration or position; or remove its output.",
    ),
    "drive.output-own": (
        "{link} and {on} are the drive's own links; '{name}' can't be its output.",
        "Remove output: the law then applies to the drive itself.",
    ),
    "drive.signal": (
        "The law of a drive can't depend on '{name}', which results from the motion.",
        "Write the law with t, parameters and tables. A link that is to follow a drive is a joint, e.g. "
        "'gearbox: {{coupling: [drum, frame], follows: 2*motor.angle + 30 deg}}' under joints.",
    ),
    "drive.linear-table": (
        "The table {table} uses linear interpolation, so the drive's speed would jump at each point.",
        "Write between: cubic or between: quintic in the table.",
    ),
    "drive.not-finite": (
        "The {what} of the drive {drive} has no finite value below 1e40 at t = {time:.6g} s.",
        "Check its position for a division by zero, a root of a negative number, or a root at zero.",
    ),
    "joint.not-finite": (
        "The {what} of {name}, which follows {motor}, has no finite value below 1e40 at t = {time:.6g} s.",
        "Check its expression for a division by zero, a root of a negative number, or a root at zero.",
    ),
    "drive.outside-table": (
        "The drive {drive} evaluates a table at {at:.6g}, outside its range {low:.6g} to {high:.6g} (in SI units: s, "
        "m, rad).",
        "Extend the table, or give it a period.",
    ),
    "load.empty": (
        "The load has neither a force nor a torque.",
        "Give one of them.",
    ),
    "load.at": (
        "The point where the force acts is missing.",
        "Add at: a point of the link, or [x, y] in its own coordinates.",
    ),
    "load.direction": (
        "A force is two numbers [Fx, Fy], or one number along a slide.",
        "Write force: [Fx, Fy] without along, or one number with along: JOINT.",
    ),
    "load.in": (
        "A force along a slide has the direction of the slide; 'in' has no meaning here.",
        "Remove 'in'.",
    ),
    "joint.slides-tilted": (
        "The slide {joint} doesn't close the loop of the slides {loop}: the directions of its two lines differ by "
        "{angle} {unit} from those required by the others.",
        "Correct the angles in line, so that the directions around the loop add up.",
    ),
    "load.against-itself": (
        "The load acts on {name} against {name} itself: the two forces cancel.",
        "Name another link under against, or remove it if the load comes from outside the mechanism.",
    ),
    "load.signal": (
        "The load depends on '{name}', which itself results from the forces.",
        "Make it depend only on time, motion, tables and parameters.",
    ),
    "load.outside-table": (
        "At t = {time} s ({drive} = {value} {unit}) the table {table} is evaluated at {at} {of}, outside its range "
        "{low} to {high} {of}.",
        "Extend the table, give it a period, or limit the load to a window.",
    ),
    "load.table-at-rest": (
        "At standstill the table {table} is evaluated at {at} {of}, outside its range {low} to {high} {of}: the efforts "
        "that start the motion are unknown.",
        "Extend the table to standstill.",
    ),
    "load.not-finite": (
        "The load or spring has no finite value at t = {time} s ({drive} = {value} {unit}).",
        "Check for a division by zero or a root of a negative number; a gas spring may be compressed beyond its gas "
        "column.",
    ),
}
