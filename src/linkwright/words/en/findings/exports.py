"""Problems of exports."""

PROBLEMS: dict[str, tuple[str, str]] = {
    "export.which": (
        "The target of the export isn't given.",
        "Add --to and one of these: {known}.",
    ),
    "export.unknown": (
        "There is no export target called '{name}'.",
        "{near}",
    ),
    "export.missing": (
        "The file has no options for the export to {name}. Its exports: {has}.",
        "Add them to the file, for example 'exports: {{{name}: {example}}}'.",
    ),
    "export.options": (
        "The option {key} of the export to {export} is invalid: {reason}.",
        "Correct it; docs/file-format.md lists the options of each target.",
    ),
    "export.choice": (
        "The option {key} of the export to {study} can't be {given}.",
        "{near}",
    ),
    "export.handle": (
        "The handle {name} is a point of the frame, so it doesn't move.",
        "Name a point of the panel, where a hand opens it.",
    ),
    "export.outline": (
        "These points don't form an outline: {reason}.",
        "List at least three points of the panel, in order around it, each once.",
    ),
    "export.setting": (
        "'{given}' doesn't have the form KEY=VALUE.",
        "Write an option and its value as in a model file: --set decimals=12.",
    ),
    "export.no-mass": (
        "MuJoCo needs a mass for every moving body: {links} got {mass}, with a radius of gyration of {radius}.",
        "Give these links masses in the model, or set another tiny_mass.",
    ),
    "export.no-inertia": (
        "MuJoCo needs a moment of inertia for every moving body: {links} got that of a radius of gyration of {radius}.",
        "Give these links one in the model where it matters.",
    ),
    "export.no-duration": (
        "The duration of the motion isn't given.",
        "Give duration under exports.{export}, or a cycle under studies.",
    ),
    "export.too-many-pieces": (
        "The law of {drive} has more than {limit} pieces in this time, so it isn't written as text.",
        "Use its values in motion.csv, or give a shorter duration.",
    ),
    "export.no-formula": (
        "The law of {drive} has no formula, so it isn't written as text.",
        "Use its values in motion.csv.",
    ),
    "joint.winds": (
        "This kind of joint, {kind}, needs the continuous angle of a link, of which only the direction is known.",
        "Set winds = True in the class of the kind, so that angles are followed over whole turns.",
    ),
    "joint.weld-pin": (
        "{link} and {on} don't share one pin, at which they could be welded.",
        "Give both links one point of the same name, at the section whose forces you need, and no other joint between "
        "them: weld: [{link}, {on}] then keeps their angle.",
    ),
    "joint.weld-drive": (
        "{link} can't be welded onto {on}: every drive has an output, or there is none.",
        "Give one drive a law of its own. In a structure without a drive, put the points of both links on one link.",
    ),
    "joint.coupling-joint": (
        "{link} isn't connected to {on} by exactly one joint, in which it could follow.",
        "Connect the two links by one pin, or by one prismatic joint, and write the link that follows first: "
        "coupling: [{link}, {on}].",
    ),
    "joint.coupling-motor": (
        "'{text}' doesn't name the value of exactly one drive, which the link is to follow.",
        "{near} Write an expression of one drive's value and of parameters, e.g. follows: 2*motor.angle + 30 deg.",
    ),
    "joint.coupling-name": (
        "'{name}' can't be used in the expression of a coupling.",
        "Write it in one drive's value, parameters and functions, e.g. follows: 2*motor.angle + 30 deg; a motion law over "
        "an angle belongs to a cam or to the drive itself.",
    ),
    "joint.follower-output": (
        "{motor} can't be followed: its law is defined at its output {output}.",
        "Name another drive as the motor, or give {motor} a law of its own.",
    ),
    "joint.follower-law": (
        "The law {law} must have the {argument} of the motor as its argument and the {value} of the follower as its "
        "value; it has {given}.",
        "Write over: {over} and of: {of} in the law, or name another one.",
    ),
    "export.unproven": (
        "Verification failed: the export of {name} deviates from the model by {error} {unit}, so it isn't written.",
        "Check for a law or pose that is nearly singular; otherwise please report this as a bug of linkwright.",
    ),
    "export.drive": (
        "The export to {name} can't contain the drive {drive}: what it prescribes isn't the value of a joint.",
        "Export the model with drives at joints: compute their motion here, and use it as their law.",
    ),
    "export.left-out": (
        "The MuJoCo file doesn't contain {names}.",
        "Add them by hand if the simulation needs them.",
    ),
    "export.followers": (
        "MuJoCo has no joint in which a link follows a drive: each follower ({names}) has an actuator of its own, which "
        "moves it by its law. The forces on a follower don't load the actuator of its drive.",
        "Use the followers' controls in positions.csv; take their forces and the drives' torques from linkwright.",
    ),
}
