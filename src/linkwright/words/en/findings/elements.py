"""Problems of links, joints, drives and loads."""

PROBLEMS: dict[str, tuple[str, str]] = {
    "model.no-frame": (
        "No link is called 'frame', so there is no fixed link. Links: {links}.",
        "{hint}",
    ),
    "model.frame-mass": (
        "The frame has a mass; it doesn't move, so its mass has no effect.",
        "Remove the mass.",
    ),
    "model.no-moving-link": (
        "There is no link besides the frame.",
        "Add the links that move.",
    ),
    "model.no-points": (
        "The link {name} has no points, so nothing can be joined to it.",
        "Give it points, for example points: {{A: [0, 0], B: [100, 0]}}.",
    ),
    "model.no-freedom": (
        "The mechanism has no drive and can't move: its mobility by Gruebler's formula is {mobility}.",
        "For the reactions of a structure, write studies: {{reactions: {{}}}}. For a motion, remove a joint or split "
        "a link, and add a drive.",
    ),
    "model.no-drive": (
        "There is no drive, so the motion isn't defined.",
        "Add one, for example drives: {{motor: {{turns: crank, on: frame, speed: 60 rpm, start: 0 deg}}}}.",
    ),
    "mass.shape-and-com": (
        "The shape already defines the mass distribution, but {given} is given too.",
        "Keep either the shape, or com and inertia.",
    ),
    "mass.missing": (
        "{given} is given without a mass.",
        "Add the mass.",
    ),
    "mass.incomplete": (
        "The link has a mass, but its centre of mass and moment of inertia aren't both given (missing: {missing}).",
        "Add com and inertia, or a shape such as 'rod A-B'.",
    ),
    "joint.kind": (
        "The joint doesn't state whether it is prismatic or revolute.",
        "Give either prismatic with line, or revolute with at.",
    ),
    "joint.line": (
        "A prismatic joint needs one line on each of its two links, and nothing else.",
        "Write line: [H at 0 deg, G at 0 deg]: for each link, a point and the direction of the line.",
    ),
    "joint.at": (
        "A revolute joint needs one point of each of its two links, and nothing else.",
        "Write at: [P, Q]: a point of the first link and one of the second.",
    ),
    "joint.slot": (
        "A pin in a slot needs exactly one of straight, arc and curve; given: {given}.",
        "For example straight: C at 0 deg, arc: {{centre: C, radius: 40}}, or curve: {{along: C at 0 deg, through: [[0, 0], "
        "[30, 8], [60, 0]]}}.",
    ),
    "joint.slot-places": (
        "A curved slot needs 2 to {most} points; given: {count}.",
        "Write through: [[0, 0], [30, 8], [60, 0]], in order along the line.",
    ),
    "joint.slot-order": (
        "The points of the curved slot must be in increasing order along its line (point {row}).",
        "Sort them by their first coordinate, and remove duplicates.",
    ),
    "joint.lifts-off": (
        "The links of {joint} ({kind}) lift off each other: keeping contact would need a pulling force of {force} "
        "{of} at t = {time} s ({drive} = {value} {unit}).",
        "Preload them with a spring or a weight; a pin in a slot can bear on both flanks (flank: both).",
    ),
    "joint.same-link": (
        "Both links are {name}, but a joint or drive needs two different links.",
        "Name the other link.",
    ),
    "joint.pin-twice": (
        "Several points of the link {link} ({points}) would be on the same pin {pin}.",
        "Rename these points, or remove the joint that connects them.",
    ),
    "drive.kind": (
        "The drive doesn't say which link or cylinder it moves.",
        "Give one of turns, slides and moves with the name of a link, or extends with the name of a cylinder or slide.",
    ),
    "drive.on": (
        "A drive with turns, slides or moves needs on, the other link; a drive with extends doesn't have on.",
        "Give on with turns, slides and moves (often on: frame), and remove it with extends.",
    ),
    "drive.point": (
        "The keys moves, at and along belong together: a point of a link, and the line along which its position counts.",
        "Give all three, e.g. '{{moves: coupler, at: P, on: frame, along: O at 90 deg, ...}}', where O is a point of the "
        "link after on; or use turns or slides without at and along.",
    ),
    "sketch.missing-point": (
        "The link {link} takes the position of {name} from the sketch, but the sketch doesn't have this point.",
        "{near} Otherwise give the point's position under sketch, or its coordinates in the link's own axes.",
    ),
    "sketch.unused": (
        "No link uses the sketched point {name}.",
        "Add it to the points of a link, or remove it from the sketch.",
    ),
    "sketch.no-value": (
        "The value of {name} isn't defined by the sketch.",
        "Give it as a number. The sketch defines only the angle between links whose first two points are sketched, "
        "the length of a cylinder between sketched points, and the travel of a slide on the frame.",
    ),
    "sketch.mixed": (
        "Some sketched points have three coordinates ({three}), others two ({two}).",
        "Give three for all of them, in the vehicle's axes, or two for all of them, in the plane of the linkage.",
    ),
    "sketch.in-line": (
        "The sketched points are collinear (or fewer than three), so they don't define the plane of the linkage.",
        "Give the plane, such as plane: xz or plane: {{normal: [0, 1, 0.02]}}, or sketch another pose.",
    ),
    "triangle.two": (
        "A point is given by its distances from two others of its link; here are {count}.",
        "For example P: {{from: {{A: 80 mm, B: 60 mm}}, side: left of A-B}}.",
    ),
    "triangle.side": (
        "The side '{given}' names other points than the distances, which are from {first} and {second}.",
        "Write side: {text}, seen from {first} to {second}; or give the distances from the points of the side.",
    ),
    "triangle.circular": (
        "The place of {point} on the link {link} can't be found: by the distances that are given, it follows from itself.",
        "Give two points of the link by coordinates, and the others by their distances from points given before them.",
    ),
    "triangle.impossible": (
        "The point {point} of the link {link} has no place: these three sides form no triangle: {sides}. Any two must "
        "together be longer than the third; here that is {value} {unit}, and must be positive.",
        "Correct one of the two distances or the points from which they are measured. For a point on the line of the two "
        "others, give coordinates instead.",
    ),
    "sketch.coincident": (
        "The points {a} and {b} of the link {link} coincide in the plane of the linkage.",
        "Check their coordinates and the plane: the distance between the two points must not be zero.",
    ),
    "sketch.no-plane": (
        "The linkage isn't planar: {name} is {off} {unit} out of the plane with the normal ({normal}); the limit is "
        "{limit} {unit}.",
        "Check the coordinates. If the pins are at different positions along their axes, give the plane (plane: xz, "
        "or its normal); plane: {{within: LENGTH}} changes the limit.",
    ),
    "sketch.off-plane": (
        "{name} is {off} {unit} out of the best-fit plane of the pinned points, with the normal ({normal}).",
        "Check its coordinates, or give the plane; plane: {{within: LENGTH}} sets the deviation that is allowed.",
    ),
    "sketch.plane-unused": (
        "A plane is given, but no sketched point has three coordinates.",
        "Give the sketched points as [x, y, z] in the vehicle's axes, or remove the plane.",
    ),
    "sketch.plane-twice": (
        "The plane has both axes and normal.",
        "Give axes for a plane of two of the vehicle's axes, or normal for any other plane.",
    ),
    "cylinder.same-point": (
        "Both ends of the cylinder are at {point}.",
        "Name two different points, such as one on the frame and one on the moving link.",
    ),
}
