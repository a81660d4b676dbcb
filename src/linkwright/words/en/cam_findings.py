"""The findings of the cam study and of NC code."""

CAM_TEXTS: dict[str, tuple[str, str]] = {
    "cam.which": (
        "Which cam the study looks at isn't clear; there are {count}: {names}.",
        "Name one under cam.",
    ),
    "cam.none": (
        "The file has no cams.",
        "Add one and its motion law, for example 'cams: {{seal: {{cam: disc, follower: lever, on: frame, base: 40 mm, law: "
        "lift, roller: 15 mm, at: R}}}}' and 'laws: {{lift: {{over: angle, of: angle, beyond: repeat, segments: [...]}}}}'; "
        "see docs/how-to/cams.md.",
    ),
    "cam.together": (
        "These belong together: {keys}.",
        "Give them all, or none of them.",
    ),
    "cam.not-positive": (
        "{key} is {text}; it must be {least}.",
        "Give such a value.",
    ),
    "cam.keyway": (
        "The keyway is wider than the bore.",
        "Give a narrower keyway or a larger bore; both bore and hub are stated by their radii.",
    ),
    "cam.hub": (
        "The hub has no wall around bore and keyway.",
        "Give a larger hub or a smaller bore; both are stated by their radii.",
    ),
    "cam.groove-blank": (
        "Only a groove is milled into a plate of its own radius; this cam is closed by {closed}.",
        "With closed: groove give radius of the plate and groove, its depth; else leave both out.",
    ),
    "cam.groove-deep": (
        "The groove is as deep as the plate is thick.",
        "Give a thicker plate, or a groove that is less deep.",
    ),
    "cam.plate": (
        "The groove's outer flank reaches {most} {unit} from the centre; the plate doesn't hold it.",
        "Give a radius larger than that.",
    ),
    "cam.blank": (
        "Hub, bore or keyway reach {reach} {unit} from the centre, and the {profile} comes as near as {least} {unit}.",
        "Make them smaller (they are stated by their radii), or the base circle larger.",
    ),
    "cam.no-base": (
        "No base circle from {low} {unit} to {high} {unit} keeps the limits.",
        "Widen the range, or loosen the limits.",
    ),
    "cam.passes": (
        "Going down so takes {count} passes; {most} are the most.",
        "Give a larger step, or mill a thinner cam.",
    ),
    "cam.undercut": (
        "The {disc} is undercut: at the cam angle {theta} the {name} is {value} {unit}, and it must exceed {limit} {unit}. "
        "There is no profile that moves the follower so.",
        "Take a larger base circle (the least that will do: {base}), or a longer way for the lift{roller}.",
    ),
    "cam.rough": (
        "At the cam angle {theta} the follower's {rate} jumps.",
        "Take a law that joins smoothly there, or loosen the limit continuity.",
    ),
    "cam.hollow": (
        "The {profile} is hollow at the cam angle {theta} with a radius of {value} {unit}; a cutter of {limit} {unit} doesn't "
        "get in.",
        "Take a smaller cutter, or a larger base circle (the least that will do: {base}).",
    ),
    "cam.limit": (
        "The {name} is {value} {unit} at the cam angle {theta}; the limit is {limit} {unit}.",
        "Change base circle, arm, offset or law, or the limit; size: looks for the smallest base circle that keeps it.",
    ),
    "cam.required": (
        "{name} is {value} {unit}; required is {wanted}.",
        "Change the cam, or the requirement.",
    ),
    "cam.sharp": (
        "At the cam angle {theta} the contour can't be followed within {tolerance}: it bends too sharply.",
        "Take a larger base circle or a smoother law, or a wider tolerance.",
    ),
    "cam.knife": (
        "An edge has no radius, and no contact pressure that could be told.",
        "Give the follower a roller, or leave width out.",
    ),
    "cam.no-roller": (
        "This follower has no roller that could turn.",
        "Give the follower a roller.",
    ),
    "cam.no-speed": (
        "The cam's speed isn't known: {motor} has none.",
        "Give speed under forces, or to the drive.",
    ),
    "cam.poisson": (
        "Poisson's ratio is {text}; no material that is the same in all directions has more than 0.5.",
        "Give a value from 0 to 0.5, e.g. 0.3 for steel.",
    ),
    "cam.no-figure": (
        "{name} isn't among this study's figures.",
        "Add forces, with width for the Hertz pressure and spring where the follower is closed by form; only a roller "
        "has a speed, only a flat face has face_near and face_far and never a pitch curve or a hollow. A second disc is "
        "that of closed: conjugate, a span and a play are those of closed: yoke.",
    ),
    "cam.load-name": (
        "'{name}' is a parameter, and in a cam's load also the cam's {name}.",
        "Give the parameter another name.",
    ),
    "cam.load-signal": (
        "'{name}' can't stand in a cam's load.",
        "Write angle for the cam angle, lift for the follower's lift; besides them parameters, tables and laws.",
    ),
    "cam.load-outside": (
        "At the cam angle {theta} the load asks the table {table} for {at} {of}, outside its range {low} to {high} {of}.",
        "Extend the table, or give it a period.",
    ),
    "cam.load-not-finite": (
        "The load has no finite value at the cam angle {theta}.",
        "Look for a division by zero, or the root of a negative number.",
    ),
    "cam.spring": (
        "The follower lifts off: at {speed} the contact force gets down to {force}, at the cam angle {theta}; it must be "
        "{least} or more.",
        "Give the spring a preload of {preload} at the lift 0{rate}.",
    ),
    "cam.hertz": (
        "The Hertz pressure is {value} at the cam angle {theta}; the limit is {limit}.",
        "Make the contact {width} wide, or take a larger base circle, a larger roller or a weaker spring.",
    ),
    "cam.torque": (
        "The torque on the shaft is {value} at the cam angle {theta}; the limit is {limit}.",
        "Take a weaker spring, a lighter follower, or a longer way for the lift.",
    ),
    "cam.shock": (
        "The follower's velocity jumps: the force there would be infinite.",
        "Take a law whose velocity joins.",
    ),
    "cam.locked": (
        "The follower locks: the common normal is square to its way.",
        "Take a larger base circle, or lead the follower otherwise.",
    ),
    "cam.groove": (
        "Only a roller runs in a groove.",
        "Give the follower a roller.",
    ),
    "cam.yoke": (
        "Only a sliding follower has a yoke.",
        "Close a swinging one by a groove or a second disc.",
    ),
    "cam.play": (
        "The yoke has a play of up to {play}: across the disc lie {yoke_span_min} at the cam angle {at_min} and "
        "{yoke_span_max} at {at_max}.",
        "Take a law whose lifts half a turn apart add up to the same everywhere, such as a return half a turn after the "
        "rise and by the same law; or a second disc, closed: conjugate.",
    ),
    "nc.no-post": (
        "NC code is asked for, and no control is named.",
        "Name one of {known} under post, or leave nc out.",
    ),
    "nc.undercut": (
        "The cam is undercut at {theta} deg: the pitch curve's radius is {radius} mm, the roller's {roller} mm.",
        "Take a larger base circle, or a smaller roller.",
    ),
    "nc.concave": (
        "The profile is hollow at {theta} deg with a radius of {radius} mm; a cutter of {cutter} mm doesn't get in.",
        "Take a smaller cutter, or a larger base circle.",
    ),
    "nc.small-cutter": (
        "The cutter's radius of {cutter} mm is too small; with these decimals the smallest is {smallest} mm.",
        "Check the unit of the cutter's radius, or give more decimals.",
    ),
    "nc.wide-cutter": (
        "A cutter with a radius of {cutter} mm doesn't fit into the groove of a roller of {roller} mm.",
        "Take a cutter no larger than the roller.",
    ),
    "nc.undercut-outer": (
        "The groove's outer flank is undercut at {theta} deg: the pitch curve is hollow with a radius of {radius} mm, the "
        "roller's is {roller} mm.",
        "Take a larger base circle, or a smaller roller.",
    ),
    "nc.allowance": (
        "The passes beside the groove's middle leave {allowance} mm to the last ones, more than the cutter's radius, "
        "{cutter} mm.",
        "Give a smaller allowance.",
    ),
    "nc.groove-lead": (
        "With cutter compensation the leads' radius must exceed the cutter's, {cutter} mm; such don't fit into the groove "
        "of a roller of {roller} mm.",
        "Take a smaller cutter (somewhat less than two thirds of the roller's radius, with an allowance still less), or leave compensation out.",
    ),
    "nc.no-compensation": (
        "The control {post} has no cutter compensation.",
        "Leave compensation out: then the path of the cutter's centre is programmed.",
    ),
    "nc.short-lead": (
        "With cutter compensation the lead's radius, {lead} mm, must exceed the cutter's, {cutter} mm.",
        "Give a larger lead.",
    ),
    "nc.decimals": (
        "The control {post} takes no more than {most} digits after the point.",
        "Give fewer decimals.",
    ),
    "nc.fine": (
        "The tolerance of the lift leaves the path {allowed} mm, and rounding alone takes {rounding} mm.",
        "Give more decimals, or a wider tolerance.",
    ),
    "nc.no-dwell": (
        "The cutter enters at {theta} deg, while the follower moves: a mark there would be felt.",
        "Give a start within a dwell; a cam without one keeps the mark.",
    ),
    "nc.sharp": (
        "At the cam angle {theta} deg the cutter's path can't be followed within the tolerance.",
        "Give more decimals or a wider tolerance; at sharp places a larger base circle.",
    ),
    "nc.off": (
        "Read back, the file for {post} makes a lift that is off by {share} of the tolerance, and cuts {gouge} mm into the "
        "profile. It isn't written.",
        "Give more decimals or more steps; a file that says something else than it should is a bug to be reported.",
    ),
    "nc.depth": (
        "Read back, the file for {post} gets {depth} mm deep; {wanted} mm are asked for. It isn't written.",
        "Check the depths in it; a file that says something else than it should is a bug to be reported.",
    ),
    "nc.island": (
        "Read back, the file for {post} leaves something standing in the groove, about X{x} Y{y}.",
        "Check the passes beside the pitch curve; a file that says something else than it should is a bug to be reported.",
    ),
    "nc.stray": (
        "Read back, the file for {post} cuts into the cam about X{x} Y{y}, away from its path.",
        "Check where its passes begin; a file that says something else than it should is a bug to be reported.",
    ),
    "nc.long-line": (
        "A line of the file for {post} has {length} letters; the control takes {most}. It isn't written.",
        "Give fewer decimals or a shorter name.",
    ),
    "nc.nothing-left": (
        "Read back, the file for {post} leaves nothing of the cam, or doesn't go around it.",
        "Check lead and cutter against the base circle.",
    ),
    "nc.tight": (
        "Line {line} of the file for {post}: the compensated arc is smaller than the cutter.",
        "Take a smaller cutter, or leave compensation out.",
    ),
    "nc.after-end": (
        "Line {line} of the file for {post} comes after its end: {text}.",
        "Remove what comes after M2 or M30.",
    ),
    "nc.unreadable": (
        "Line {line} of the file for {post} can't be read: {text}.",
        "Write words of a letter and a number each.",
    ),
    "nc.no-end": (
        "The file for {post} has no end.",
        "End it with M2 or M30.",
    ),
    "nc.unknown": (
        "Line {line} of the file for {post} has a word that isn't known: {word}.",
        "Leave it out; what isn't understood can't be proven.",
    ),
    "nc.twice": (
        "Line {line} of the file for {post} has the letter {word} twice.",
        "Leave one out.",
    ),
    "nc.no-motion": (
        "Line {line} of the file for {post} has places before any of G0 to G3.",
        "Say first how to move there.",
    ),
    "nc.no-unit": (
        "Line {line} of the file for {post} moves before a unit is set.",
        "Set G21 (mm) or G20 (inches) first.",
    ),
    "nc.no-feed": (
        "Line {line} of the file for {post} cuts without a feed.",
        "Set F first.",
    ),
    "nc.no-spindle": (
        "Line {line} of the file for {post} cuts while the spindle stands.",
        "Start it with M3 first.",
    ),
    "nc.no-centre": (
        "Line {line} of the file for {post} has an arc without I and J.",
        "Give the centre; arcs by their radius aren't exact enough.",
    ),
    "nc.centre-on-line": (
        "Line {line} of the file for {post} has a centre on a straight motion.",
        "Leave I, J and R out, or make it an arc.",
    ),
    "nc.radius": (
        "Line {line} of the file for {post}: the arc starts {start} mm from its centre and ends {end} mm from it.",
        "Mend the place or the centre; a control would stop here.",
    ),
}
CAM_TERMS = {
    "or-roller": ", or a smaller roller",
    "or-rate": ", or with the present one a rate of {rate}",
    "no-rate": "; with the present one no rate does",
    "a-length": "a length of the follower",
    "no-base": "none of up to twenty times as large",
    "normal-square": "the pressure angle reaches 90 deg, and no force along the common normal moves the follower on",
    "face-fast": "its face turns as fast as the cam, and the contact runs off along it",
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
