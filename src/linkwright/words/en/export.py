"""The words of the exports: sentences for the terminal, comments in the files."""

EXPORT: dict[str, str] = {
    "mjcf.told": "{bodies} bodies, {loops} loops closed by connect; in {poses} poses, loops and links are off by {error} m at most.",
    "mjcf.comment": (
        "Written by linkwright. m, kg, s, rad; plane x-y, axis z. Bodies are links in their own frames, in the pose at t = 0. "
        "A hinge's position is the child's angle less the parent's, a slide's its travel, an actuator's control the drive's value. "
        "Loops are closed by connect, which is soft in MuJoCo: a simulation opens them a little under load, and its "
        "results differ from those of rigid links by that much. solref and solimp say how stiff they are. "
        "Driven joints have an armature, so that the drives move the links as if nothing held them back."
    ),
    "motors.told": "{drive}: {count} pieces, off its law by {error} {unit} at most.",
    "motors.title": "{name}: laws of motors, written by linkwright",
    "motors.time": "Over {stop} s; t in s.",
    "motors.dialect.creo": (
        "sin, cos and tan take degrees, asin and acos give them. In Creo Mechanism: a servo motor for position, its function "
        "user defined, one row a line: expression and domain."
    ),
    "motors.dialect.radians": "sin, cos and tan take radians, asin and acos give them.",
    "motors.head": "{drive}: {what}, in {unit}; off by {error} {unit} at most",
    "motors.turns": "angle of {link} less that of {on}",
    "motors.slides": "travel of {link} on {on}",
    "motors.output": "motion of {link} against {on}, the output of {drive}",
}
