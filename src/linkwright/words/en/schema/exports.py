"""Descriptions in the JSON Schema of the options of export targets."""

TEXTS: dict[str, str] = {
    # MuJoCo.
    "schema.MjcfOptions": "Settings for MuJoCo that the mechanism doesn't contain.",
    "schema.MjcfOptions.tiny_mass": "mass of links that have none; default: 1 g",
    "schema.MjcfOptions.timestep": "time step of MuJoCo; default: 1 ms",
    "schema.MjcfOptions.duration": "duration of the motion; default: that of the cycle",
    "schema.MjcfOptions.samples": "equal steps of the motion in the table of positions",
    # Motors of CAD systems.
    "schema.MotorOptions": "Dialect, duration and steps of the texts.",
    "schema.MotorOptions.dialect": "creo: sin and cos of degrees; or radians",
    "schema.MotorOptions.duration": "duration of the motion; default: that of the cycle",
    "schema.MotorOptions.samples": "equal steps of the table of values",
    # Process Simulate.
    "schema.ProcessSimulateOptions": "Dialect, range, and the joints' names in the tool.",
    "schema.ProcessSimulateOptions.dialect": "seed (acos, sqrt, sin, cos) or wizard (acos, sin, atan2)",
    "schema.ProcessSimulateOptions.names": "names of joints in the tool; default: those of the model",
    "schema.ProcessSimulateOptions.master": "joint that is the argument of all functions, by its name in the model or in the tool; default: the one that the drive moves",
    "schema.ProcessSimulateOptions.mirror": "write the functions of two mirrored hinges that move in step, in one file",
    "schema.ProcessSimulateOptions.zero": "value of the drive in the pose in which all joints are 0; default: that at the start",
    "schema.ProcessSimulateOptions.range": "[low, high] of the drive's value; default: all that it reaches from its start, short of dead centres",
    "schema.ProcessSimulateOptions.stops": "[low, high] of the driving joint relative to the zero pose, as the tool counts it, instead of range",
    "schema.ProcessSimulateOptions.flipped": "joints that count in the opposite direction in the tool: reversed axes, parent and child exchanged",
    "schema.ProcessSimulateOptions.left_out": "joints that the tool doesn't have",
    "schema.ProcessSimulateOptions.decimals": "minimum number of decimals; more are used if the accuracy requires it",
    "schema.ProcessSimulateOptions.longest": "maximum length of a text; longer ones are split by means of auxiliary joints",
    "schema.ProcessSimulateOptions.approximate": "permissible error (rad or mm) of polynomials, for groups without a closed form",
    "schema.ProcessSimulateOptions.sheet": "what the data sheet shows besides the functions",
    "schema.Mirror": "Names and counting directions of the joints of the two hinges in the tool.",
    "schema.Mirror.suffixes": "suffixes of the joints' names on the first and second side; default: _l and _r",
    "schema.Mirror.prefixes": "prefixes of the joints' names on the first and second side",
    "schema.Mirror.signs": "mirrored: the axes of the second side are mirror images of the first side's, so that its rotations count in the opposite direction and its translations in the same one; same: both sides count in the same direction",
    "schema.Facts": "What the data sheet shows besides the joint functions.",
    "schema.Facts.panel": "link whose opening angle is given; default: the one with handle or outline, else the coupler",
    "schema.Facts.handle": "point where the hand acts, along the point's path",
    "schema.Facts.outline": "points of the panel in order along its outline; the area that they sweep is drawn",
    "schema.Facts.samples": "equal steps of the driving range",
}
