"""The words of the exports: sentences for the terminal, comments in the files."""

TEXTS: dict[str, str] = {
    "mjcf.told": "{bodies} bodies, {loops} loops closed by connect constraints; maximum error of loops and links at {poses} poses: {error} m.",
    "mjcf.comment": "Written by linkwright. m, kg, s, rad; plane x-y, axis z. Bodies are links in their own frames, in the pose at t = 0. A hinge's position is the child's angle minus the parent's, a slide's its travel, an actuator's control the drive's value. Loops are closed by connect constraints, which are soft in MuJoCo: under load they open slightly, and the results differ from those of rigid links by that amount. solref and solimp set their stiffness. Driven joints have an armature, so that loads hardly affect the motion of the drives.",
    "motors.told": "{drive}: {count} pieces, maximum error {error} {unit}.",
    "motors.title": "{name}: motion laws of motors, written by linkwright",
    "motors.time": "Duration {stop} s; t in s.",
    "motors.dialect.creo": "sin, cos and tan take degrees, asin and acos return degrees. In Creo Mechanism: a servo motor for position with a user-defined function; each line is one row: expression and domain.",
    "motors.dialect.radians": "sin, cos and tan take radians, asin and acos return radians.",
    "motors.head": "{drive}: {what}, in {unit}; maximum error {error} {unit}",
    "motors.turns": "angle of {link} relative to {on}",
    "motors.slides": "travel of {link} on {on}",
    "motors.path": "{axis} of point {point} of {link} in the axes of {on}; {drives} follow from both coordinates",
    "motors.point": "place of a point of {link} along a line of {on}",
    "motors.output": "motion of {link} relative to {on}, the output of {drive}",
}
