"""Problems of required paths and shapes in a workspace."""

PROBLEMS: dict[str, tuple[str, str]] = {
    "workspace.path-source": (
        "A required path needs exactly one source; given: {given}.",
        "Write points, or file, or drawing, or x and y as formulas in u.",
    ),
    "workspace.path-pace": (
        "A required path is followed either at constant motor speed, or in a given time.",
        "Write speed, for example speed: 30 rpm, or duration, for example duration: 2 s; not both.",
    ),
    "workspace.path-key": (
        "{key} is allowed only together with {of}.",
        "Remove it, or add what it belongs to.",
    ),
    "workspace.path-still": (
        "The motor has no speed, so it can't follow a path.",
        "Give it a speed, for example 30 rpm; a negative speed reverses the direction.",
    ),
    "workspace.path-none": (
        "The required path {name} can't be followed in any of {count} regions. The best one is the mode {mode} "
        "(values: {values}); its obstacles are listed separately.",
        "See these; the summary lists all attempts, with the sections of the path that can't be followed.",
    ),
    "workspace.section-drives": (
        "Paths and shapes in the workspace need two drives; this mechanism has {count}.",
        "Remove the section, or give the mechanism another drive.",
    ),
    "workspace.not-positive": (
        "{key}: {text} isn't positive.",
        "Give a positive value.",
    ),
    "workspace.fit-kind": (
        "A shape is exactly one of circle, rectangle and largest; given: {given}.",
        "Write for example circle: 10 mm, rectangle: [20 mm, 10 mm] or largest: circle.",
    ),
    "workspace.fit-none": (
        "{name} doesn't fit into any region. In the best one (mode {mode}; values: {values}) {share} % of its area "
        "lies outside, up to {by} away; scaled to {scale} of its size, it fits there.",
        "Make it smaller, move it, or change the mechanism; largest: circle shows the largest circle that fits.",
    ),
    "workspace.path-short": (
        "The required path has {given} distinct points; its curve needs at least {wanted}.",
        "Add points, or use straight segments (between: linear).",
    ),
    "workspace.path-unit": (
        "The column '{column}' of the required path isn't a length.",
        "Write its unit in brackets, as in 'x [mm]'.",
    ),
    "workspace.path-drawing": (
        "The drawing {file} contains {count} curves; the required path must be a single one.",
        "Join them into one polyline, or name the layer that contains only the path.",
    ),
    "drawing.unreadable": (
        "The drawing {file} can't be read as DXF: {reason}.",
        "Save it again as DXF from the program that created it.",
    ),
    "drawing.code": (
        "The drawing {file} has '{given}' ({place}) where a group code is expected.",
        "Save it again as DXF from the program that created it.",
    ),
    "drawing.number": (
        "The drawing {file} has '{given}' in a group {code} ({place}), where a finite number below 1e40 is expected.",
        "Correct the number, or draw the curve again; save the drawing again as DXF.",
    ),
    "drawing.entity": (
        "The {kind} with the handle {handle} in the drawing {file} can't be used as a path: {reason}.",
        "Draw it again, preferably as one polyline near the origin.",
    ),
    "workspace.path-name": (
        "'{name}' isn't allowed in the formula of a required path.",
        "Write x and y with u, which runs from 0 to 1, parameters and functions.",
    ),
    "workspace.path-value": (
        "The formula of the required path has no value at u = {u:.6g}.",
        "Check for a division by zero or a root of a negative number.",
    ),
    "workspace.path-rests": (
        "The formula of the required path stops at u = {u:.6g}, where the motor can't stop.",
        "Write x and y so that the point keeps moving as u increases, or give the path in time.",
    ),
    "workspace.path-corner": (
        "The required path has {count} corners, the first at u = {u:.6g}: the speed of the drives jumps there.",
        "Round the corners, or use a smooth curve through the points (between: cubic).",
    ),
    "workspace.path-outside": (
        "{point} can't reach the required path from u = {start} to {stop}: it runs up to {by} outside the region.",
        "Move the path, make it smaller, or choose another assembly mode; the largest circle and rectangle show what "
        "fits.",
    ),
    "workspace.path-singular": (
        "The required path can't be followed from u = {start} to {stop}: it meets a type-1 singular position, where "
        "{point} can't move in one direction (the determinant of d(x, y)/d(drives) is zero).",
        "Keep the path away from the singular curves, which the plots show, or start it elsewhere.",
    ),
    "workspace.path-modes": (
        "The required path can't be followed from u = {start} to {stop}: two assembly modes meet at a type-2 "
        "singular position (the determinant of a closure is zero).",
        "Keep the path away from the boundary of this assembly mode, or choose another one.",
    ),
    "workspace.path-limit": (
        "The required path can't be followed from u = {start} to {stop}: {drive} is at the limit of its range.",
        "Widen the range of {drive}, or move the path.",
    ),
    "workspace.path-turns": (
        "The required path can't be followed at constant speed from u = {start} to {stop}: {drive} would have to "
        "reverse.",
        "End the path there, or give it in time, so that both drives follow it.",
    ),
    "workspace.path-dead": (
        "The required path passes {count} type-1 singular positions, the first at {time:.6g} s: there {point} can "
        "move in one direction only, and the drive errors are proportional to the square root of the path errors.",
        "Make sure that the drives follow their laws accurately; on a path away from the singular curves, if there "
        "is one, {point} is guided better.",
    ),
    "workspace.servo-reverses": (
        "Along the required path {servo} reverses {count} times, the first time at {time:.6g} s, but never_reverse "
        "is set.",
        "Choose another path, another speed of the motor, or another start; or allow reversing.",
    ),
}
