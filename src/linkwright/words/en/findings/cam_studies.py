"""Texts of the problems of the cam study and of NC code."""

PROBLEMS: dict[str, tuple[str, str]] = {
    "cam.which": (
        "The file has {count} cams, and the study doesn't say which one it is for: {names}.",
        "Name one under cam.",
    ),
    "cam.none": (
        "The file has no cams.",
        "Add one and its motion law, for example 'cams: {{seal: {{cam: disc, follower: lever, on: frame, base: 40 mm, law: "
        "lift, roller: 15 mm, at: R}}}}' and 'laws: {{lift: {{over: angle, of: angle, beyond: repeat, segments: [...]}}}}'; "
        "see docs/how-to/cams.md.",
    ),
    "cam.together": (
        "These keys must be given together: {keys}.",
        "Give all of them, or none.",
    ),
    "cam.not-positive": (
        "{key} is {text}; it must be {least}.",
        "Correct the value.",
    ),
    "cam.keyway": (
        "The keyway is wider than the bore.",
        "Give a narrower keyway or a larger bore; bore and hub are given as radii.",
    ),
    "cam.hub": (
        "The hub leaves no wall around the bore and keyway.",
        "Give a larger hub or a smaller bore; both are given as radii.",
    ),
    "cam.groove-blank": (
        "Only a groove is milled into a plate with a radius of its own; this cam has closed: {closed}.",
        "With closed: groove, give radius (of the plate) and groove (its depth); otherwise remove both.",
    ),
    "cam.groove-deep": (
        "The groove is at least as deep as the plate is thick.",
        "Give a thicker plate, or a shallower groove.",
    ),
    "cam.plate": (
        "The groove's outer flank reaches {most} {unit} from the centre, beyond the edge of the plate.",
        "Give a radius larger than that.",
    ),
    "cam.blank": (
        "Hub, bore or keyway reach {reach} {unit} from the centre, but the minimum radius of the {profile} is "
        "{least} {unit}.",
        "Make them smaller (they are given as radii), or make the base circle larger.",
    ),
    "cam.no-base": (
        "No base circle from {low} {unit} to {high} {unit} satisfies the limits.",
        "Widen the range, or relax the limits.",
    ),
    "cam.passes": (
        "This depth needs {count} passes; the limit is {most}.",
        "Give a larger step, or mill a thinner cam.",
    ),
    "cam.undercut": (
        "The {disc} is undercut: at the cam angle {theta} the {name} is {value} {unit}, but it must exceed {limit} "
        "{unit}. No profile can produce this motion of the follower.",
        "Use a larger base circle (minimum: {base}), or spread the lift over a larger cam angle{roller}.",
    ),
    "cam.rough": (
        "At the cam angle {theta} the follower's {rate} jumps.",
        "Use a law that is continuous there, or relax the limit continuity.",
    ),
    "cam.hollow": (
        "The {profile} is concave at the cam angle {theta} with a radius of {value} {unit}, smaller than the "
        "cutter's {limit} {unit}.",
        "Use a smaller cutter, or a larger base circle (minimum: {base}).",
    ),
    "cam.limit": (
        "The {name} is {value} {unit} at the cam angle {theta}; the limit is {limit} {unit}.",
        "Change the base circle, arm, offset or law, or the limit; size: finds the minimum base circle that "
        "satisfies it.",
    ),
    "cam.required": (
        "{name} is {value} {unit}; required: {wanted}.",
        "Change the cam, or the requirement.",
    ),
    "cam.sharp": (
        "At the cam angle {theta} the contour can't be approximated within {tolerance}: its curvature is too high.",
        "Use a larger base circle or a smoother law, or a wider tolerance.",
    ),
    "cam.knife": (
        "A knife edge has no radius, so its contact pressure is undefined.",
        "Give the follower a roller, or remove width.",
    ),
    "cam.no-roller": (
        "This follower has no roller, so there is no roller speed.",
        "Give the follower a roller.",
    ),
    "cam.no-speed": (
        "The cam's speed isn't known: the motor {motor} has no constant speed.",
        "Give speed under forces, or in the drive.",
    ),
    "cam.poisson": (
        "Poisson's ratio is {text}; an isotropic material has at most 0.5.",
        "Give a value from 0 to 0.5, e.g. 0.3 for steel.",
    ),
    "cam.no-figure": (
        "{name} isn't a result of this study.",
        "Add forces, with width for the Hertz pressure, and with spring if the follower is form-closed. Only a "
        "roller has a speed; only a flat face has face_near and face_far, and it has no pitch curve and no concave "
        "radius. Results of a second disc need closed: conjugate; a span and a clearance need closed: yoke.",
    ),
    "cam.load-name": (
        "'{name}' is a parameter, but in a cam's load it is also the cam's {name}.",
        "Rename the parameter.",
    ),
    "cam.load-signal": (
        "'{name}' isn't allowed in a cam's load.",
        "Use angle (the cam angle), lift (the follower's lift), parameters, tables and laws.",
    ),
    "cam.load-outside": (
        "At the cam angle {theta} the load evaluates the table {table} at {at} {of}, outside its range {low} to "
        "{high} {of}.",
        "Extend the table, or give it a period.",
    ),
    "cam.load-not-finite": (
        "The load has no finite value at the cam angle {theta}.",
        "Check for a division by zero or a root of a negative number.",
    ),
    "cam.spring": (
        "The follower lifts off: at {speed} the contact force falls to {force} at the cam angle {theta}; it must be "
        "at least {least}.",
        "Give the spring a preload of {preload} at the lift 0{rate}.",
    ),
    "cam.hertz": (
        "The Hertz pressure is {value} at the cam angle {theta}; the limit is {limit}.",
        "Increase the contact width to {width}, or use a larger base circle, a larger roller or a weaker spring.",
    ),
    "cam.torque": (
        "The torque on the shaft is {value} at the cam angle {theta}; the limit is {limit}.",
        "Use a weaker spring or a lighter follower, or spread the lift over a larger cam angle.",
    ),
    "cam.shock": (
        "The follower's velocity jumps, so the force would be infinite there.",
        "Use a law with continuous velocity.",
    ),
    "cam.locked": (
        "The follower locks: the pressure angle reaches 90 deg.",
        "Use a larger base circle, or guide the follower differently.",
    ),
    "cam.groove": (
        "Only a roller can run in a groove.",
        "Give the follower a roller.",
    ),
    "cam.yoke": (
        "Only a translating follower can have a yoke.",
        "Close an oscillating follower with a groove or a second disc.",
    ),
    "cam.play": (
        "The yoke has a clearance of up to {play}: the width across the disc is {yoke_span_min} at the cam angle "
        "{at_min} and {yoke_span_max} at {at_max}.",
        "Use a law whose lifts half a turn apart have a constant sum, such as a return half a turn after the rise "
        "with the same law; or a second disc, closed: conjugate.",
    ),
    "nc.no-post": (
        "NC code is requested, but no control is given.",
        "Name one of {known} under post, or remove nc.",
    ),
    "nc.undercut": (
        "The cam is undercut at {theta} deg: the pitch curve's radius is {radius} mm, the roller's {roller} mm.",
        "Use a larger base circle, or a smaller roller.",
    ),
    "nc.concave": (
        "The profile is concave at {theta} deg with a radius of {radius} mm, smaller than the cutter's {cutter} mm.",
        "Use a smaller cutter, or a larger base circle.",
    ),
    "nc.small-cutter": (
        "The cutter's radius of {cutter} mm is too small; with this number of decimals, the minimum is {smallest} mm.",
        "Check the unit of the cutter's radius, or give more decimals.",
    ),
    "nc.wide-cutter": (
        "A cutter with a radius of {cutter} mm doesn't fit into the groove of a roller of {roller} mm.",
        "Use a cutter no larger than the roller.",
    ),
    "nc.undercut-outer": (
        "The groove's outer flank is undercut at {theta} deg: the pitch curve is concave with a radius of {radius} "
        "mm, the roller's is {roller} mm.",
        "Use a larger base circle, or a smaller roller.",
    ),
    "nc.allowance": (
        "The passes beside the groove's centre line leave {allowance} mm for the finishing passes, more than the "
        "cutter's radius, {cutter} mm.",
        "Give a smaller allowance.",
    ),
    "nc.groove-lead": (
        "With cutter compensation, the radius of the leads must exceed the cutter's, {cutter} mm; such leads don't "
        "fit into the groove for a roller of {roller} mm.",
        "Use a smaller cutter (somewhat less than two thirds of the roller's radius, with an even smaller "
        "allowance), or remove compensation.",
    ),
    "nc.no-compensation": (
        "The control {post} has no cutter compensation.",
        "Remove compensation: the path of the cutter's centre is programmed then.",
    ),
    "nc.short-lead": (
        "With cutter compensation the lead's radius, {lead} mm, must exceed the cutter's, {cutter} mm.",
        "Give a larger lead.",
    ),
    "nc.decimals": (
        "The control {post} accepts at most {most} decimals.",
        "Give fewer decimals.",
    ),
    "nc.fine": (
        "The tolerance of the lift allows a path error of {allowed} mm, but rounding alone causes {rounding} mm.",
        "Give more decimals, or a wider tolerance.",
    ),
    "nc.no-dwell": (
        "The cutter enters at {theta} deg, while the follower moves: the mark that it leaves would disturb the motion.",
        "Set start within a dwell; on a cam without a dwell, the mark can't be avoided.",
    ),
    "nc.sharp": (
        "At the cam angle {theta} deg the cutter's path can't be followed within the tolerance.",
        "Give more decimals or a wider tolerance; at points of high curvature, a larger base circle.",
    ),
    "nc.off": (
        "Read back, the file for {post} produces a lift that deviates by {share} of the tolerance, and gouges the "
        "profile by {gouge} mm. It isn't written.",
        "Give more decimals or more steps; if the error remains, please report it as a bug.",
    ),
    "nc.depth": (
        "Read back, the file for {post} mills {depth} mm deep, but {wanted} mm are required. It isn't written.",
        "Check the depths in it; if the error remains, please report it as a bug.",
    ),
    "nc.island": (
        "Read back, the file for {post} leaves excess material in the groove, near X{x} Y{y}.",
        "Check the passes beside the pitch curve; if the error remains, please report it as a bug.",
    ),
    "nc.stray": (
        "Read back, the file for {post} gouges the cam near X{x} Y{y}, away from its path.",
        "Check where its passes begin; if the error remains, please report it as a bug.",
    ),
    "nc.long-line": (
        "A line of the file for {post} has {length} characters; the control accepts {most}. It isn't written.",
        "Give fewer decimals or a shorter name.",
    ),
    "nc.nothing-left": (
        "Read back, the file for {post} removes the whole cam, or doesn't go around it.",
        "Check the lead and the cutter against the base circle.",
    ),
    "nc.tight": (
        "Line {line} of the file for {post}: the compensated arc is smaller than the cutter.",
        "Use a smaller cutter, or remove compensation.",
    ),
    "nc.after-end": (
        "Line {line} of the file for {post} follows the end of the program: {text}.",
        "Remove what follows M2 or M30.",
    ),
    "nc.unreadable": (
        "Line {line} of the file for {post} can't be read: {text}.",
        "Write words of one letter and one number each.",
    ),
    "nc.no-end": (
        "The file for {post} has no end of program.",
        "End it with M2 or M30.",
    ),
    "nc.unknown": (
        "Line {line} of the file for {post} has an unknown word: {word}.",
        "Remove it; a program with unknown words can't be verified.",
    ),
    "nc.twice": (
        "Line {line} of the file for {post} has the letter {word} twice.",
        "Remove one.",
    ),
    "nc.no-motion": (
        "Line {line} of the file for {post} has coordinates before any of G0 to G3.",
        "Write one of G0 to G3 first.",
    ),
    "nc.no-unit": (
        "Line {line} of the file for {post} moves before a unit is set.",
        "Set G21 (mm) or G20 (inches) first.",
    ),
    "nc.no-feed": (
        "Line {line} of the file for {post} cuts without a feed rate.",
        "Set F first.",
    ),
    "nc.no-spindle": (
        "Line {line} of the file for {post} cuts while the spindle is stopped.",
        "Start it with M3 first.",
    ),
    "nc.no-centre": (
        "Line {line} of the file for {post} has an arc without I and J.",
        "Give the centre; arcs given by their radius aren't exact enough.",
    ),
    "nc.centre-on-line": (
        "Line {line} of the file for {post} has a centre in a straight motion.",
        "Remove I, J and R, or make it an arc.",
    ),
    "nc.radius": (
        "Line {line} of the file for {post}: the arc starts {start} mm from its centre and ends {end} mm from it.",
        "Correct the end point or the centre; a control would stop here.",
    ),
}
TERMS = {
    "or-roller": ", or a smaller roller",
    "or-rate": ", or keep the present preload and give it a rate of {rate}",
    "no-rate": "; with the present preload, no rate is sufficient",
    "a-length": "a length of the follower",
    "no-base": "none up to twenty times as large",
    "normal-square": "the pressure angle reaches 90 deg, so no force along the common normal can move the follower",
    "face-fast": "its face turns as fast as the cam, so the contact runs off along it",
    "cam-positive": "more than 0",
    "cam-zero": "0 or more",
    "jump-acceleration": "acceleration",
    "jump-jerk": "jerk",
    "cam-first": "cam",
    "cam-second": "second disc",
    "cam-flank": "outer flank of the groove",
    "cam-profile": "profile",
    "of-second": "{what} of the second disc",
    "base-between": "{base}, with {between} between both contacts",
    "check-pressure_rise": "pressure angle on the rise",
    "check-pressure_return": "pressure angle on the return",
    "check-pitch_radius": "radius of the pitch curve",
    "check-profile_radius": "convex radius of the profile",
    "check-hollow_radius": "concave radius of the profile",
    "check-groove_radius": "concave radius of the pitch curve",
}
