"""Texts of problems: `CODE.what` describes the cause, `CODE.mend` the suggested fix, with the data of the problem filled in.

`term.…` are phrases that are inserted into these texts. Quantities in the data have units; the few that don't are
in SI, and the text says so.
"""

from linkwright.words.en.absent import ABSENT_TEXTS
from linkwright.words.en.cam_findings import CAM_TERMS, CAM_TEXTS
from linkwright.words.en.examples import EXAMPLE_TERMS
from linkwright.words.en.plausibility import PLAUSIBILITY_TERMS, PLAUSIBILITY_TEXTS

_TEXTS: dict[str, tuple[str, str]] = {
    # The file and its text.
    "file.unreadable": (
        "The file {file} can't be read: {reason}.",
        "Check its name and your permission to read it.",
    ),
    "file.irregular": (
        "{file} is {kind}; only regular files can be read.",
        "Give the name of a regular file, or of a link to one.",
    ),
    "file.not-found": (
        "The file {file} doesn't exist.",
        "{hint}",
    ),
    "file.unwritable": (
        "Can't write to {file}: {reason}.",
        "Choose another folder with --out, or allow writing to this one.",
    ),
    "file.package-fails": (
        "The package {package} can't be loaded: {reason}",
        "If the message is about the home folder, set the variable HOME to an existing folder; otherwise reinstall "
        "the package.",
    ),
    "file.no-temporary": (
        "No folder for temporary files is available: {reason}.",
        "Set one that can be written to: TMPDIR=FOLDER linkwright ... (TEMP on Windows).",
    ),
    "file.needs-package": (
        "This needs the package {package}, which isn't installed.",
        "Install it: pip install 'linkwright[{extra}]'.",
    ),
    "file.too-large": (
        "The file is larger than {limit} bytes, the limit for a model file.",
        "Put long tables into CSV files beside the model and name them under tables.",
    ),
    "file.binary": (
        "The file isn't valid UTF-8 text (byte {at}); it may be a binary file or saved in another encoding, such as "
        "GBK.",
        "Save the model as plain text in UTF-8.",
    ),
    "file.encoding": (
        "The file isn't valid UTF-8 (byte {at}); it looks like {encoding}.",
        "Save it as UTF-8: in Notepad and most editors under 'Save as', 'Encoding'.",
    ),
    "file.wide": (
        "The file has full-width characters where half-width ones are needed: {given}",
        "{hint}",
    ),
    "file.colon": (
        "A space is missing after the colon: {given}",
        "{hint}",
    ),
    "file.equals": (
        "A value must follow a colon, not '=': {given}",
        "{hint}",
    ),
    "file.decimal-comma": (
        "YAML splits '{text}' at the comma; numbers need a decimal point.",
        "Write {meant}.",
    ),
    "file.character": (
        "The text contains a control character.",
        "Type the text again, without \\x, \\u or \\0 escapes.",
    ),
    "file.empty": (
        "The file is empty.",
        "Start it with 'linkwright: 1', then add links and drives; see docs/file-format.md.",
    ),
    "file.documents": (
        "A second YAML document starts here (after '---' or '...'); a model file can contain only one.",
        "Remove the marker, or split the file.",
    ),
    "file.mapping": (
        "The file has no 'key: value' entries at its top level.",
        "Start it with 'linkwright: 1', then add links and drives; see docs/file-format.md.",
    ),
    "file.version": (
        "The file doesn't state the format version {known} (given: {given}).",
        "Write 'linkwright: {known}' as its first line.",
    ),
    "file.yaml": (
        "The file can't be read as YAML here: {reason}.",
        "Check this line and the line above for an open bracket or quote, a missing colon, or wrong indentation.",
    ),
    "file.tab": (
        "The line contains a tab; YAML allows only spaces here.",
        "Replace the tab with spaces; most editors can insert spaces for the tab key.",
    ),
    "file.quote": (
        "YAML can't read a value that starts like '{value}' as text.",
        "Put the value in double quotes.",
    ),
    "file.comma": (
        "YAML splits '{text}' at the commas because it isn't quoted.",
        'Put the expression in quotes: "{text}".',
    ),
    "file.alias": (
        "'{mark}' is a YAML anchor or alias, which model files don't support.",
        "Use a parameter instead; if the value is meant to begin with '*' or '&', put it in double quotes.",
    ),
    "file.tag": (
        "'{tag}' is a YAML type tag, which model files don't support.",
        "Remove the tag; if the value is meant to begin with '!', put it in double quotes.",
    ),
    "file.key": (
        "There is a list or mapping before a colon, where a name is expected.",
        "Write a plain name there; put a value in braces or brackets after the colon.",
    ),
    "file.depth": (
        "Values are nested more than {limit} levels deep.",
        "Model files need at most five levels: check for an extra bracket.",
    ),
    "file.duplicate": (
        "'{name}' is given twice in the same place, first in line {first}.",
        "Rename or remove one of the two.",
    ),
    "file.too-many": (
        "There are {count} entries here; a model file can have at most {limit}.",
        "Split the model; put long tables into CSV files.",
    ),
    "file.long": (
        "This text is longer than {limit} characters.",
        "Shorten it; define parts of a long expression as parameters.",
    ),
    "file.more": (
        "At least {count} more problems were found.",
        "Fix those above first; many of the others may result from them.",
    ),
    "file.missing": (
        "'{name}' is missing here.",
        "Add it. Keys of this kind of entry: {known}.",
    ),
    "file.unknown-key": (
        "Unknown key '{name}'.",
        "{near} Otherwise remove it.",
    ),
    "file.kind": (
        "'{name}: {kind}' isn't allowed here: the kind of an entry is written as a key.",
        "{near}",
    ),
    "file.kinds": (
        "An entry has one kind; here are keys of several: {keys}.",
        "Keep the keys of one kind, and write an entry of its own for the other.",
    ),
    "file.expected": (
        "Expected {wanted}, got {given}.",
        "{hint}",
    ),
    "file.not-finite": (
        "{given} isn't a finite number.",
        "Give a finite number.",
    ),
    "file.bad-name": (
        "'{name}' isn't a valid name.",
        "{hint}",
    ),
    "file.reserved-name": (
        "'{name}' is a reserved name: t is the time, pi the number, start and end are the ends of a run.",
        "Choose another name.",
    ),
    "builder.twice": (
        "'{name}' was added to the builder twice.",
        "Rename or remove one of the two.",
    ),
    "file.exists": (
        "The file {file} already exists.",
        "Give another name with --out, or add --force to overwrite it.",
    ),
    "gallery.unknown": (
        "The gallery has no model called '{name}'.",
        "{near} 'linkwright new' lists all models.",
    ),
    # Large studies.
    "file.link": (
        "{file} is a symbolic link; linkwright doesn't write through links.",
        "Remove the link, or give the path that it points to.",
    ),
    "folder.busy": (
        "Another run is writing to the folder {folder}.",
        "Wait until it ends, or choose another folder with --out.",
    ),
    "folder.busy-with": (
        "Another run is writing to the folder {folder}: {model}, started {date}, process {process} on {host}.",
        "Wait until it ends, or choose another folder with --out.",
    ),
    "folder.foreign": (
        "These files in {folder} would be overwritten, but linkwright didn't write them or they were changed since: {files}.",
        "Move or rename them, choose another folder with --out, or add --force to overwrite them.",
    ),
    "blocks.other-version": (
        "The file {file} contains the state of a study that was started with {theirs}; this is {ours}, whose results "
        "may differ.",
        "Resume it with {theirs}, or restart it with --fresh (in Python fresh=True; anew=True for a Checkpoint or "
        "store).",
    ),
    "blocks.holes": (
        "The store {file} lacks {count} of its {total} chunks, or they are truncated: another program has written to "
        "it.",
        "Run the same study again: it computes only what is missing.",
    ),
    "blocks.busy": (
        "Another process is writing to {file}.",
        "Wait until it ends, or use another file for this study.",
    ),
    "blocks.other-work": (
        "The file {file} contains the state of another study: the model or the options differ.",
        "Use another file for this study, restore the original model and options, or restart the study, which "
        "overwrites the file.",
    ),
    "blocks.corrupt": (
        "The file {file} contains the state of a study, but it is damaged.",
        "Restore a copy of it, or restart the study, which overwrites the file.",
    ),
    "blocks.no-space": (
        "There is no disk space left for {file}: {reason}.",
        "Free some space and run the same study again: it resumes from the saved state.",
    ),
    "blocks.unwritable": (
        "Can't write to {file}: {reason}.",
        "Fix the cause and run the same study again: it resumes from the saved state.",
    ),
    "blocks.cluster-unreachable": (
        "No Dask scheduler answers at {address}: {reason}.",
        "Check the address (such as tcp://host:8786), that 'dask scheduler' runs there, and that the firewall allows "
        "the connection.",
    ),
    "blocks.cluster-lost": (
        "The connection to the Dask scheduler at {address} was lost.",
        "Start the scheduler and its workers again, then run the same study: it resumes from the saved state.",
    ),
    "blocks.cluster-idle": (
        "The Dask scheduler at {address} has had no workers for {seconds} s.",
        "Start workers ('dask worker {address}'), then run the same study: it resumes from the saved state.",
    ),
    "blocks.workers-died": (
        "Several workers of the cluster died while computing the same atoms ({first} to {last}).",
        "Check the workers' logs. The cause is often memory: give each worker more memory, or fewer threads.",
    ),
    # Units and expressions.
    "units.wrong": (
        "'{word}' isn't a unit of {base}.",
        "Write a plain unit of {base}, for example {usual}.",
    ),
    "units.unknown": (
        "'{word}' isn't a known unit.",
        "Use units such as mm, deg, kg, s, N, N*m, rpm, mm/s; write products with *, quotients with /, powers with ^.",
    ),
    "expression.syntax": (
        "'{text}' can't be read as an expression: {reason}.",
        "Use + - * / ^ and brackets, as in '2*AB + 5 mm'; write * between factors.",
    ),
    "expression.respelled": (
        "'{text}' can't be read as an expression: {reason}.",
        "{hint}",
    ),
    "expression.units-conflict": (
        "'{part}' has the unit {given}, but {wanted} is expected here.",
        "Correct the unit or the parameter; a parameter takes its unit from its own value or from its other uses.",
    ),
    "expression.units-mixed": (
        "'{part}' combines the units {given} and {wanted}; such values can't be added.",
        "Write units with the numbers, or correct the parameter; parameters without a unit take it from their uses.",
    ),
    "expression.hertz": (
        "'{part}' counts events per second, so it isn't clear whether revolutions or radians are meant.",
        "Write rpm, r/s or deg/s for a speed; in sin and cos write 2*pi*{part}*t.",
    ),
    "expression.arguments": (
        "The function {name} has {given} arguments, but it takes {wanted}.",
        "Give {wanted} arguments, separated by commas.",
    ),
    "expression.unknown-function": (
        "There is no function, table or motion law called '{name}'.",
        "{near} Otherwise declare it under tables or laws.",
    ),
    "expression.unit-alone": (
        "'{name}' is a unit without a number, and no parameter has this name.",
        "Write the number before it, as in '1 {name}', or declare {name} under parameters.",
    ),
    "expression.undeclared-unit": (
        "A number has no unit here, and 'units' doesn't declare the unit of {base} (such numbers: {count}).",
        "Declare {base} under units, or write the unit after the number.",
    ),
    "expression.odd-unit": (
        "A number without a unit would be read in {dimension} here, which is rarely intended.",
        "Write the unit after the number.",
    ),
    "expression.not-constant": (
        "'{name}' changes while the mechanism moves, but a constant is expected here.",
        "Use only numbers, parameters and functions of them.",
    ),
    "expression.ambiguous-unit": (
        "In '{part}', '{word}' is read as a unit, but a parameter has the same name.",
        "To use the parameter, write it in brackets: '*({word})'. To use the unit, rename the parameter.",
    ),
    "parameters.cycle": (
        "These parameters depend on each other in a cycle: {cycle}.",
        "Give one of them as a number.",
    ),
    "parameters.value": (
        "'{text}' has no finite value: it divides by zero, takes a root of a negative number, or is too large.",
        "Check the numbers used in it.",
    ),
    "value.not-finite": (
        "'{text}' has no finite value: it divides by zero, takes a root of a negative number, or is too large.",
        "Check the numbers and parameters used in it.",
    ),
    "value.too-small": (
        "The {what} is {value} {unit}, which is too small.",
        "Give a positive value.",
    ),
    "value.rod": (
        "The ends {points} of the rod coincide.",
        "Use two different points, or write 'point' instead of 'rod'.",
    ),
    "value.not-rising": (
        "The interval from {low} to {high} is empty.",
        "Give the lower limit first.",
    ),
    # Names.
    "name.unknown": (
        "'{name}' isn't {kind} of this mechanism.",
        "{near}",
    ),
    "name.unknown-point": (
        "The link {link} has no point called '{name}'.",
        "{near} Otherwise add the point to the link.",
    ),
    "name.unknown-element": (
        "No element of this mechanism is called '{name}'.",
        "{near}",
    ),
    "name.unknown-kernel": (
        "There is no kernel called '{name}'.",
        "{near}",
    ),
    "name.unknown-parameter": (
        "There is no parameter called '{name}'.",
        "{near} Otherwise declare it under parameters.",
    ),
    "name.taken": (
        "'{name}' is the name of both {first} and {second}, so signals such as '{name}.x' would be ambiguous.",
        "Rename one of the two.",
    ),
    "signal.no-attribute": (
        "'{attribute}' isn't a signal of {name}.",
        "{near}",
    ),
    "signal.indeterminate": (
        "The {attribute} in the slide {joint} isn't determined by statics: the slides {loop} constrain each other's "
        "direction, and a moment can circulate through all of them.",
        "Use the forces .x, .y or .normal instead, or pin one of the links to a sliding block.",
    ),
    "signal.no-joint": (
        "{a} and {b} aren't joined, so there is no force between them.",
        "Write one of these: {options}. If three links share a pin, name the pin as the second argument.",
    ),
    "signal.several-joints": (
        "{a} and {b} are connected by several joints: {joints}.",
        "Name the joint as the third argument: force({a}, {b}, JOINT).",
    ),
    "signal.no-mass": (
        "'{name}' isn't a link with mass, so it has no centre of mass.",
        "Give the link a mass, or use one of its points.",
    ),
    "signal.same-link": (
        "'{name}' has no instant centre relative to itself.",
        "Name two different links: pole({name}, frame).x.",
    ),
    "signal.unknown": (
        "'{name}' isn't a signal.",
        "{hint}",
    ),
    "signal.element": (
        "'{name}' is {kind}, but one of its signals is expected.",
        "Write one of these: {signals}.",
    ),
    # Links, joints, drives, loads.
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
        "Give one of turns and slides with the name of a link, or extends with the name of a cylinder or slide.",
    ),
    "drive.on": (
        "A drive with turns or slides needs on, the other link; a drive with extends doesn't have on.",
        "Give on with turns and slides (often on: frame), and remove it with extends.",
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
    # Cams.
    "cam.contact": (
        "The contact between the follower and the cam isn't defined clearly; given: {given}.",
        "Give roller with at (its centre), knife with a point of the follower, or face with a line of it.",
    ),
    "cam.second": (
        "A contact with a second disc is given, but the follower is closed by {closed}.",
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
        "'{name}' can't be the output of a drive: it is neither a prismatic joint nor a link of this model.",
        "{near} An output is a prismatic joint, or a link that is pinned to the frame.",
    ),
    "drive.output-own": (
        "{link} and {on} are the drive's own links; '{name}' can't be its output.",
        "Remove output: the law then applies to the drive itself.",
    ),
    "drive.signal": (
        "The law of a drive can't depend on '{name}', which results from the motion.",
        "Write the law with t, parameters and tables.",
    ),
    "drive.linear-table": (
        "The table {table} uses linear interpolation, so the drive's speed would jump at each point.",
        "Write between: cubic or between: quintic in the table.",
    ),
    "drive.not-finite": (
        "The {what} of the drive {drive} has no finite value below 1e40 at t = {time:.6g} s.",
        "Check its position for a division by zero, a root of a negative number, or a root at zero.",
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
    "load.not-finite": (
        "The load or spring has no finite value at t = {time} s ({drive} = {value} {unit}).",
        "Check for a division by zero or a root of a negative number; a gas spring may be compressed beyond its gas "
        "column.",
    ),
    # Springs.
    "spring.ends": (
        "The two ends of the spring aren't defined clearly.",
        "Give from and to (two points), or turns and on (two links) for a torsional spring.",
    ),
    "spring.law": (
        "A spring needs exactly one law, with or without damping; given: {given}.",
        "Give one of stiffness, force (torsional: torque), gas, or damping only.",
    ),
    "spring.stray": (
        "These keys aren't allowed in a spring of this kind: {keys}.",
        "Remove them; docs/file-format.md shows which keys belong together.",
    ),
    "spring.free": (
        "The spring's free length is missing.",
        "Add free: the length (torsional: the angle) at which the spring exerts its preload, or no force.",
    ),
    "spring.gas": (
        "The force at the maximum length alone doesn't define a gas spring: the rise of the force is missing.",
        "Add progression (force at the minimum length divided by force at the maximum length) and length: [minimum, "
        "maximum].",
    ),
    "spring.progression": (
        "The progression of a gas spring must be above 1: its force increases when it is compressed.",
        "Give the force at the minimum length divided by the force at the maximum length, usually 1.2 to 1.5.",
    ),
    "spring.same-link": (
        "Both ends are on the link {name}, so the spring has no effect.",
        "Choose a point or link elsewhere; if several links share a point, give the links under in: [LINK, LINK].",
    ),
    "spring.no-direction": (
        "At t = {time} s ({drive} = {value} {unit}) the two ends of the spring coincide, so its force has no "
        "direction.",
        "Move one of its points.",
    ),
    "spring.outside-length": (
        "At t = {time} s ({drive} = {value} {unit}) the spring is {length} {of} long; {low} to {high} {of} is allowed.",
        "Use a part with another stroke, or move its points. The spring's law is extrapolated beyond these limits.",
    ),
    # Tables.
    "table.source": (
        "A table needs either a file or points.",
        "Give file with x and y, or points: [[x, y], ...].",
    ),
    "table.columns": (
        "The columns of the file aren't given.",
        "Add x and y as 'COLUMN UNIT', for example x: angle deg.",
    ),
    "table.inline-columns": (
        "{given} names a column of a file, but the points are given here.",
        "Remove it; write units with the points, or use the declared units.",
    ),
    "table.place": (
        "The file '{file}' isn't in the model's folder.",
        "Put it in the model's folder, or below, and write its name without '..' and without a drive or root.",
    ),
    "table.unreadable": (
        "The file {file} can't be read: {reason}.",
        "Put the file beside the model, with exactly this name, and allow reading it.",
    ),
    "table.too-large": (
        "The file {file} is larger than {limit} bytes, the limit.",
        "Remove rows and columns; in a drawing, remove everything except the path.",
    ),
    "table.not-text": (
        "The file {file} isn't valid UTF-8 text: byte {at} (line {line}) isn't allowed.",
        "Save it as a CSV file in UTF-8, not in UTF-16, GBK or a spreadsheet format.",
    ),
    "table.bad-line": (
        "The file {file} can't be read as CSV at line {line}: {reason}.",
        "Check this line and those above for an unmatched quotation mark.",
    ),
    "table.empty": (
        "The file {file} is empty.",
        "Write the names of the columns in the first line and numbers in the following lines, separated by commas.",
    ),
    "table.separator": (
        "The file {file} separates its columns with '{sign}'; commas are expected.",
        "Save it with commas between the columns and decimal points in the numbers.",
    ),
    "table.column-twice": (
        "The file {file} has several columns called '{name}'.",
        "Give each a name of its own, or remove those that aren't needed.",
    ),
    "table.no-column": (
        "The file has no column '{name}'. Its columns: {known}.",
        "Correct x and y, or the first line of the file.",
    ),
    "table.not-number": (
        "Line {row} of the file has '{given}' in the column '{name}', where a finite number below 1e40 is expected.",
        "Correct the cell; use decimal points, and no units.",
    ),
    "table.long": (
        "The file has more than {limit} rows.",
        "Remove rows: the spline between them needs few.",
    ),
    "table.short": (
        "The table has {given} points; the curve between them needs at least {wanted}.",
        "Add points, or write between: linear.",
    ),
    "table.order": (
        "The x values must increase (row {row}).",
        "Sort the points, and give each x value once.",
    ),
    "table.uneven": (
        "Some points are so close together, compared with the others, that no smooth curve passes through them.",
        "Remove the closest points, or write between: linear.",
    ),
    "table.period": (
        "The points span more than one period.",
        "Give a longer period, or fewer points.",
    ),
    "table.not-closed": (
        "The points span one whole period, but the last value differs from the first.",
        "Make the two equal, or remove the last point.",
    ),
    # Motion laws.
    "law.unknown": (
        "There is no motion law called '{name}'.",
        "{near} Otherwise give fractions, powers or a formula instead of law.",
    ),
    "law.segment": (
        "The kind of the segment isn't clear; found: {given}.",
        "Give exactly one of {known}.",
    ),
    "law.keys": (
        "{given} isn't allowed in a segment of this kind ({head}).",
        "Remove it, or put it into a segment of its own.",
    ),
    "law.no-over": (
        "The length of the segment along the axis is missing.",
        "Add over, for example over: 90 deg.",
    ),
    "law.way": (
        "The shape of the segment must be defined exactly once; found: {given}.",
        "Give exactly one of {known}; match, from, to, via and spline can be combined.",
    ),
    "law.argument-taken": (
        "In a formula, {name} runs from 0 to 1 over the segment, but a parameter is also called {name}.",
        "Rename the parameter.",
    ),
    "law.formula": (
        "'{name}' isn't allowed in the formula of a motion law.",
        "Use u, which runs from 0 to 1 over the segment, parameters and functions.",
    ),
    "law.place": (
        "The motion law '{name}' is called outside the position of a drive.",
        "Call it in the position of a drive or in the load of a cam study; in measures and loads of the model, use "
        "the drive's value.",
    ),
    "law.over": (
        "The segment's length along the axis isn't positive, or is out of range.",
        "Give it a length between 1e-12 and 1e12 s or rad.",
    ),
    "law.via": (
        "The points in via must be in increasing order and apart from each other, between the segment's start and end.",
        "Sort them; their positions are measured from the segment's start.",
    ),
    "law.conditions": (
        "One polynomial would have to satisfy {count} conditions; the limit is {limit}.",
        "Remove points, add spline: quintic, or split the segment.",
    ),
    "law.end-rates": (
        "A spline of degree {degree} needs {wanted} derivatives at each end.",
        "Give this number in from and to, or use match: velocity with spline: cubic, match: acceleration with "
        "spline: quintic.",
    ),
    "law.not-normal": (
        "The formula is {start} at u = 0 and {end} at u = 1; it must be 0 and 1.",
        "Subtract its value at u = 0, then divide it by its rise.",
    ),
    "law.not-smooth": (
        "The formula, or one of its first two derivatives, has no finite value somewhere between u = 0 and u = 1.",
        "Check it for a division by zero, or a root at zero.",
    ),
    "law.powers": (
        "A power is given twice.",
        "Give each power once.",
    ),
    "law.fractions": (
        "The {count} fractions add up to {sum}; a law needs four [b, c, d, z], or seven, each 0 or at least 1e-6, "
        "with the sum 1 and some acceleration on both sides.",
        "Correct them: [0.25, 0, 0.75, 0] is the modified sine.",
    ),
    "law.skew": (
        "The law can't have its maximum velocity at {share} of the segment.",
        "Give a skew from 0.001 to 0.999, and only with a symmetric law.",
    ),
    "law.control": (
        "The B-spline has {given} control values; its degree needs at least {wanted}.",
        "Add control values, or use a lower degree.",
    ),
    "law.period": (
        "The segments add up to {sum} {unit}; the period is {period} {unit}.",
        "Correct their lengths, add a dwell, or give the period.",
    ),
    "law.not-closed": (
        "The law starts at {start} {unit} and ends at {end} {unit}, so it can't be repeated.",
        "Make the segments return to the start, or write beyond: advance (continues from there) or beyond: hold "
        "(stays there).",
    ),
    "law.open-end": (
        "At its {side} the segment takes its derivatives from segment {other}, where they aren't given either.",
        "Give them in one of the two, with from or to.",
    ),
    "law.end-acceleration": (
        "The law {law} ends with a non-zero acceleration, and the adjacent segment doesn't continue with the same one.",
        "Add its mirror image directly after it, a fall with the same law, height and length; or use a law that ends "
        "with zero acceleration.",
    ),
    "drive.law-jumps": (
        "The {what} of the motion law {law} jumps at {at} by {jump}; no drive can follow this.",
        "Use another law there, or blends that match the velocity: {{rise: ..., over: ..., match: acceleration}}.",
    ),
    # Windows, measures, studies.
    "window.one-signal": (
        "A window needs exactly one signal; given: {count}.",
        "Write {{SIGNAL: [low, high]}} with one signal.",
    ),
    "window.signal": (
        "'{given}' isn't a signal such as motor.angle.",
        "Write {{SIGNAL: [low, high]}}, for example {{motor.angle: [0 deg, 90 deg]}}.",
    ),
    "window.outside": (
        "The window {name} lies outside the run.",
        "Correct the window, or make the study run longer.",
    ),
    "measure.reduction": (
        "A measure needs exactly one reduction of a signal; given: {given}.",
        "Give exactly one of: {known}.",
    ),
    "measure.where": (
        "'where' is required for 'value', and allowed only there.",
        "Write value and where together: {{value: crank.angle, where: max E.x}}.",
    ),
    "measure.within": (
        "'within' is required for 'dwell', and allowed only there.",
        "Write dwell and within together: {{dwell: E.x, within: 0.5 mm}}.",
    ),
    "measure.bad-where": (
        "'{given}' doesn't define an instant.",
        "Write one of: max SIGNAL, min SIGNAL, SIGNAL = VALUE (such as motor.angle = 24 deg), start, end.",
    ),
    "measure.unit": (
        "The value is in {wanted}; it can't be shown in {unit}.",
        "Use a unit of the same kind as {wanted}, or remove the unit.",
    ),
    "measure.table": (
        "The table '{name}' can't be used in a measure.",
        "Tables are for drives, loads and springs; write the measure in signals, t and parameters.",
    ),
    "measure.nothing": (
        "The measure {name} has no value: the run doesn't enter its window.",
        "Correct the window, or make the study run longer.",
    ),
    "measure.not-finite": (
        "The measure {name} has no finite value.",
        "Check its expression for a division by zero or a root of a negative number. Other possible causes are a "
        "singular position, or an instant centre at infinity or without motion.",
    ),
    "motion.too-many-turns": (
        "'{name}' makes too many turns in this run for its angle to be tracked continuously.",
        "Make the study run for a shorter time; a run whose only drive turns at constant speed has no such limit.",
    ),
    "measure.unbounded": (
        "The measure {name} is unbounded: {signal} grows without limit towards t = {time}.",
        "Choose a window without that instant, or measure the numerator and the denominator separately.",
    ),
    "measure.diverges": (
        "The measure {name} has no value: the integral of {signal} diverges at t = {time}.",
        "Choose a window without that instant.",
    ),
    "measure.undecided": (
        "{signal} may be unbounded near t = {time}; round-off prevents a decision, so the measure {name} has no value.",
        "Choose a window without that instant, or write the expression with fewer cancelling terms.",
    ),
    "measure.two-values": (
        "The measure {name} has two values: {signal} jumps at t = {time}, where it is evaluated.",
        "Evaluate it slightly earlier or later.",
    ),
    "measure.no-instant": (
        "The measure {name} has no value: the run never reaches the instant that its 'where' defines.",
        "Correct 'where' or the window, or make the study run longer.",
    ),
    "measure.unsettled": (
        "The search for {name} hadn't converged on its finest grid ({width}): digits or narrow peaks may be missing.",
        "Limit the measure to a window, or make the study run for a shorter time.",
    ),
    "study.unknown": (
        "There is no study called '{name}'.",
        "{near}",
    ),
    "study.missing": (
        "The file has no study {name}. Its studies: {has}.",
        "Add it to the file, for example 'studies: {{{name}: {example}}}'.",
    ),
    "study.options": (
        "The option {key} of the study {study} is invalid: {reason}.",
        "Correct it; docs/file-format.md lists the options of each study.",
    ),
    "study.choice": (
        "The option {key} of the study {study} can't be {given}.",
        "{near}",
    ),
    "study.not-in-sweep": (
        "'{name}' isn't available in the limits study: it moves one drive through its values at unit speed, without "
        "forces.",
        "Use positions, angles, travels and their derivatives; use forces and times in the measures of a cycle.",
    ),
    "study.cylinder-length": (
        "{drive} can't use its whole range: at {value} {unit} the cylinder {name} would have to be {by} "
        "{length_unit} {end} than possible: {length} {length_unit} between its pins; the limit is {limit} "
        "{length_unit}.",
        "Consider this when you read the range; studies.limits.ranges sets a smaller one.",
    ),
    "study.wide-range": (
        "The range of {drive} is wider than {limit} {unit}.",
        "Give a smaller range.",
    ),
    "motion.more-gaps": (
        "More intervals of the motion fail; the first {count} are listed.",
        "Fix the first one: the others usually repeat it in every turn.",
    ),
    "study.long-motion": (
        "{drive} travels {travel} {unit} in the motion of the cycle, but dead centres, maxima and minima of a motion "
        "are searched only up to a travel of {limit} {unit}. Those of each drive alone are complete.",
        "Give studies.cycle fewer turns or a shorter duration.",
    ),
    # Of the workspace: required paths and shapes.
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
    # Many parameter sets of one mechanism.
    "varied.slides": (
        "The directions of the slides {loop} agree only for the given value of {name}: for any other value, their "
        "loop can't be assembled.",
        "Write both lines of each slide with {name}, or don't vary it.",
    ),
    "varied.passage": (
        "The motion continues through a change point (through: keep), which another value of {names} would shift.",
        "Vary only the parameters of a motion without change points.",
    ),
    "varied.table": (
        "The x values or the period of the table {table} depend on {names}, which vary.",
        "Write these numbers explicitly, or don't vary what they depend on; the table's values may vary.",
    ),
    "varied.second": (
        "{names} vary in the law {law}, which determines the position of the second contact of {name}; that position "
        "is computed once, for the nominal values.",
        "Give the position of the second contact under second, or don't vary the law.",
    ),
    "varied.values": (
        "{count} of {samples} samples have values that aren't valid in the model; in the first one, {sample}: {what}",
        "Narrow the ranges of the varied parameters, or define dependent dimensions as expressions of them.",
    ),
    "varied.drive": (
        "In {count} of {samples} samples the law of {drive} has no finite value; in the first one, {sample}, at "
        "t = {time} s.",
        "Narrow the ranges of the parameters in its position, or change the law.",
    ),
    "varied.cannot-assemble": (
        "{count} of {samples} samples can't be assembled; the first one is {sample}, at t = {time} s: there {joints} "
        "of {links} are {distance} {unit} apart, {short}.",
        "Narrow the ranges of the varied lengths, or use only the remaining samples.",
    ),
    "varied.stuck": (
        "{count} of {samples} samples can't be followed; in the first one, {sample}, the Assur group {group} can't "
        "be followed to t = {time} s: it reaches a singular position between the nominal dimensions and those of the "
        "sample.",
        "Narrow the ranges of the varied parameters, or use only the remaining samples.",
    ),
    "accuracy.position": (
        "'{text}' isn't a position.",
        "Write 'max E.x' or 'min E.x' with a signal, 'start of W' or 'end of W' with a window, or a time.",
    ),
    "accuracy.no-derivative": (
        "There is no derivative of the reduction {reduction}, so tolerances can't be carried to the measure {name}.",
        "Name other outputs of the study.",
    ),
    "accuracy.outside-run": (
        "The position '{text}' isn't between 0 and {stop} {unit}, the run of the cycle.",
        "Give a time within the run.",
    ),
    "accuracy.correlation-limit": (
        "The deviations of {names} can't have the correlation {stated}: their distributions differ, and the limit "
        "for these is {limit}.",
        "Give a smaller correlation, or the same distribution for both.",
    ),
    "accuracy.correlation-mended": (
        "These distributions can't have all the given correlations at the same time; the samples use the nearest "
        "ones that are possible (the correlations of their normal scores change by {change} at most).",
        "Give smaller correlations, or normal distributions.",
    ),
    "accuracy.samples-fail": (
        "{count} of {samples} random samples within the tolerances have no value of some output: {share} % (of the "
        "whole production {low} to {high} %, with 95 % confidence). The results of each output use only the samples "
        "that have it.",
        "Narrow the tolerances, or change the dimensions so that the mechanism can be assembled with all of them.",
    ),
    "accuracy.points-fail": (
        "{count} of {samples} samples within the tolerances have no value of some output: {share} %. The results of "
        "each output use only the samples that have it.",
        "Narrow the tolerances, or change the dimensions so that the mechanism can be assembled with all of them. "
        "Use the plan random or latin to get a confidence interval of this share.",
    ),
    "accuracy.law": (
        "If only {names} deviates, the motion law {law} no longer adds up to its period, closes, or stays continuous.",
        "Make other numbers of the law depend on it: {{dwell: 360 deg - w}} beside {{rise: h, over: w}}, with the "
        "same h in the fall.",
    ),
    "accuracy.table": (
        "If only {names} deviates, the table {table} no longer closes over its period.",
        "Give its first and its last value the same expression.",
    ),
    "accuracy.vertices-fail": (
        "In the search for the worst case, the mechanism can't be assembled or followed at {lost} of {looked} points "
        "within the tolerances: the worst case covers only the points where it can.",
        "Narrow the tolerances, or change the dimensions so that the mechanism can be assembled with all of them.",
    ),
    # Of sweeps.
    "study.needs-cycle": (
        "The study {study} uses the motion of the file's cycle, but the file has no cycle.",
        "Add one beside it, for example cycle: {{turns: 1 motor, samples: 360}}.",
    ),
    "study.one-value": (
        "There is nothing to vary: {count} value(s).",
        "Give at least two values; parameters that don't vary aren't listed.",
    ),
    "study.sigma": (
        "The standard deviation {sigma} isn't positive.",
        "Give a positive value in the parameter's unit.",
    ),
    "study.cut-distribution": (
        "The distribution is truncated to a range that contains less than {share:g} of it.",
        "Widen the range from low to high, or move the mean.",
    ),
    "study.triangle": (
        "The low, most likely and high values of a triangular distribution must be in increasing order: {values}.",
        "Give them in this order; the most likely value may equal one of the limits.",
    ),
    "study.plan": (
        "{name} has a distribution, which the plan {plan} doesn't support.",
        "Give it steps or a list, or use another plan: latin, sobol, random.",
    ),
    "study.grid-samples": (
        "The plan {plan} computes all combinations, so its number of samples can't be set.",
        "Remove samples, or use another plan: latin, sobol, random.",
    ),
    "study.too-many-samples": (
        "There are {count} samples; the limit of the plan {plan} is {limit}.",
        "Use fewer values or samples; for distributions, the plan random allows the most.",
    ),
    "study.no-output": (
        "'{text}' is neither a measure of this file nor an expression of signals.",
        "{near} An output is a measure, a signal such as E.x, or an expression of signals.",
    ),
    "study.no-outputs": (
        "The sweep has no outputs: the file has no measures.",
        "Add measures, or list signals under outputs.",
    ),
    "study.varied-span": (
        "The length of the run depends on {name}, which isn't the same in all samples.",
        "Give the length as a constant, for example cycle: {{duration: 1.5 s}}, or don't vary that parameter.",
    ),
    "study.no-folder": (
        "More than {limit} values would have to be kept in memory.",
        "Give a folder to write them to, with --out or out=...; or set keep: reduced.",
    ),
    "study.no-value": (
        "In {count} of {samples} samples a measure or signal has no finite value, although the motion can be "
        "followed; the first one is sample {sample}.",
        "Check for a singular position, a cam that locks its follower, a division by zero or a window that isn't "
        "reached; or narrow the ranges.",
    ),
    "study.alone": (
        "The study {study} is for structures without drives, but {name} needs a motion.",
        "Move {name} to a file of its own, with a drive.",
    ),
    "reactions.drives": (
        "The mechanism is driven by {names}, but the study reactions is for structures without drives.",
        "Write studies: {{cycle: ...}} for the forces of a motion, or remove the drives.",
    ),
    "reactions.time": (
        "The time '{text}' is neither zero nor a positive number.",
        "Write a time, for example at: 0.5 s.",
    ),
    "reactions.several-poses": (
        "The links have at least {count} assembly modes, and none is selected.",
        "Give the positions of the points in sketch, or a side under assembly.",
    ),
    "reactions.not-closed": (
        "The joints of the structure can't all close: in the best pose found, the closure error is {miss} {unit}.",
        "Correct the lengths, or give the positions of the points in sketch.",
    ),
    "reactions.phased": (
        "The links can only be assembled simultaneously; then the relative position that {name} ({kind}) keeps from "
        "the drawn pose isn't known.",
        "Give the positions of the points in sketch or under assembly, so that the links can be assembled one after "
        "the other.",
    ),
    "reactions.not-finite": (
        "The loads on {links} have no finite value.",
        "Check for a table evaluated outside its range, or a division by zero; the option at sets the time of the "
        "loads.",
    ),
    "reactions.moves": (
        "The structure isn't in equilibrium: its joints allow a motion of {links}, on which the loads do work.",
        "Add a support or a bar that constrains these links, or correct the dimensions.",
    ),
    "reactions.indeterminate": (
        "The structure is statically indeterminate to degree {degree}: reactions of {joints} depend on the stiffness of "
        "its parts and have no value here.",
        "No change is needed. To get all reactions, release supports (let one end slide) until the structure is "
        "statically determinate.",
    ),
    "reactions.neutral": (
        "The joints allow motions ({motions}) on which the loads do no work: the structure is in equilibrium only "
        "under these loads.",
        "Add a support or a bar if it must carry other loads too.",
    ),
    "reactions.no-load": (
        "No load acts on the structure, so all its reactions are zero.",
        "Add loads, springs, or gravity with masses.",
    ),
    "reactions.unproven": (
        "Verification failed: relative closure error or equilibrium residual {residual} (limit 1e-9).",
        "Check for links that are nearly collinear: there, small errors of lengths cause large forces.",
    ),
    "reactions.measures": (
        "The study reactions evaluates no measures: {names}.",
        "Read the reactions from its table, or remove the measures.",
    ),
    "study.none": (
        "The file has no study.",
        "Add one, for example studies: {{cycle: {{period: 1.5 s, samples: 200}}}}.",
    ),
    # Of exports.
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
    "joint.follower-output": (
        "{motor} can't be followed: its law is defined at its output {output}.",
        "Name another drive as the motor, or give {motor} a law of its own.",
    ),
    "joint.follower-law": (
        "The law {law} must have the {over} of the motor as its argument and the {of} of the follower as its value; "
        "it has {given}.",
        "Write over: {over} and of: {of} in the law, or name another one.",
    ),
    "export.unproven": (
        "Verification failed: the export of {name} deviates from the model by {error} {unit}, so it isn't written.",
        "Check for a law or pose that is nearly singular; otherwise please report this as a bug of linkwright.",
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
    # Of batches.
    "batch.head": (
        "The column heading '{head}' can't be read.",
        "Write the name of a parameter with its unit in brackets, for example x1 [mm].",
    ),
    "batch.no-name": (
        "The file has no column 'name'. Its columns: {known}.",
        "Add the column name with a name for each row; 'linkwright new hinge --table' writes a file to start from.",
    ),
    "batch.parameter": (
        "The model '{model}' of this row has no parameter '{name}'.",
        "Leave the cell blank, or name another model in the column model.",
    ),
    "batch.empty": (
        "The file {file} has no rows below its headings.",
        "Add one for each mechanism; 'linkwright new hinge --table' writes a file to start from.",
    ),
    "batch.cells": (
        "The row has {count} cells, but there are {heads} columns.",
        "Remove the extra cells; a comma inside a cell needs quotes around the cell.",
    ),
    "batch.name": (
        "The name '{name}' can't be used at the start of file names.",
        "Use letters, digits, spaces, dots, hyphens and underscores, at most 60, starting with a letter or digit.",
    ),
    "batch.name-twice": (
        "The name '{name}' is already used in line {first}.",
        "Give each row a name of its own; upper-case and lower-case letters count as the same.",
    ),
    "batch.model": (
        "There is no model '{name}' in the gallery, and no such file beside this one.",
        "{near} Or write the path of a model file.",
    ),
    # Of joint functions.
    "functions.drives": (
        "Joint functions need exactly one driving joint; this mechanism has {count} drives: {names}.",
        "Keep one drive, and fix the links of the others to each other.",
    ),
    "functions.left-out": (
        "The joint {joint} is listed in left_out, but it is the one that {drive} drives.",
        "Remove it from left_out.",
    ),
    "functions.master-left-out": (
        "The joint {joint} is listed in left_out, but it is the master: all functions depend on it.",
        "Remove it from left_out, or name another master.",
    ),
    "functions.master-cam": (
        "The joint {joint} can't be the master: the functions of followers ({drives}) depend on the joint of their "
        "drive.",
        "Remove master; the joint of the drive is then the driving one.",
    ),
    "functions.master-still": (
        "The joint {joint} can't be the master: it doesn't move within the range.",
        "Name a joint that moves. These move in one direction over the whole range: {others}.",
    ),
    "functions.master-zero": (
        "The joint {joint} can't be the master: it has a dead centre at {drive} = {at} {unit}, where it reverses, "
        "and the zero pose is there.",
        "Set zero to a value of {drive} well away from it, or name another master. These move in one direction over "
        "the whole range: {others}.",
    ),
    "functions.master-turns": (
        "The joint {joint} can't be the master over this range: it has a dead centre at {drive} = {at} {unit}, where "
        "it reverses, so that each of its values belongs to two poses.",
        "Set range within [{low} {unit}, {high} {unit}], or name another master. These move in one direction over "
        "the whole range: {others}.",
    ),
    "functions.master-cut": (
        "The master {joint} has a dead centre at {drive} = {at} {unit}, where it reverses. The functions are valid "
        "only from {low} to {high} {unit} of {drive}.",
        "Set range within these values to confirm that this is enough, or name another master. These move in one "
        "direction over the whole range of {drive}: {others}.",
    ),
    "functions.master-stops": (
        "The master {joint} has a dead centre between the two stops.",
        "Set stops within [{low} {unit}, {high} {unit}], its range around the zero pose.",
    ),
    "functions.master-structure": (
        "The joint {joint} can't be the master: driven instead of {drive}, it leaves the mechanism under-constrained "
        "or over-constrained.",
        "Name a joint of a loop that {drive} moves.",
    ),
    "functions.no-dependent": (
        "No joint depends on {drive}, so there is no function to write.",
        "Close a loop, remove a joint from left_out, or remove the export; a joint that is driven directly needs no "
        "function.",
    ),
    "export.too-long": (
        "The angles of {joints} can't be tracked continuously over {duration} s.",
        "Give {name} a shorter duration; a few turns of the slowest drive are enough.",
    ),
    "export.joint": (
        "{name} doesn't support joints such as {joint} ({kind}).",
        "Don't export this mechanism there, or replace the joint with links, pins and slides.",
    ),
    "export.cannot-close-slides": (
        "{name} can't describe a loop of slides only, which {joints} would close: it closes loops with pins.",
        "Pin one of the links to a sliding block of its own, or don't export this mechanism.",
    ),
    "functions.wedge": (
        "{links} is in a loop of slides only (on {slides}), for which joint functions aren't supported.",
        "Write the functions by hand: the travels of such a loop are proportional to each other.",
    ),
    "functions.shared-pin": (
        "The drive {drive} moves two links relative to each other on the pin {pin}, but other links are placed on "
        "this pin before them; the tool's joints connect the first link of a pin to each of the others.",
        "Drive one of the links relative to the first link of the pin, or give the drive a pin of its own.",
    ),
    "functions.too-many": (
        "There would be {count} joints, including auxiliary ones; the limit of the tool's functions is {limit}.",
        "List joints that close loops under left_out, allow longer texts, or export a part of the mechanism.",
    ),
    "functions.name": (
        "The joint {joint} can't be called '{name}' in the tool.",
        "Under names, give it a name of at most 60 letters A to Z, digits and underscores that doesn't start with a "
        "digit; other names that the tool accepts aren't known.",
    ),
    "functions.same-name": (
        "Several joints are called '{name}': {joints}.",
        "Give each a name of its own under names.",
    ),
    "functions.mirror-names": (
        "The joints of both hinges have the same names.",
        "Give the two sides different suffixes or prefixes, for example mirror: {{suffixes: [_l, _r]}}.",
    ),
    "functions.two-ranges": (
        "Both range and stops limit the driving joint.",
        "Keep one: range in values of the drive, or stops in values of the joint from the zero pose.",
    ),
    "functions.no-range": (
        "The mechanism can't be moved from {drive} = {start} {unit}.",
        "Start the drive where the mechanism isn't at a dead centre; the limits study lists its ranges.",
    ),
    "functions.toggle": (
        "From {from} to {to} {unit} of {of} the mechanism passes a toggle position (Assur group {groups}): its two "
        "assembly modes meet there, and one function can't follow both.",
        "Set {key} within [{low} {unit}, {high} {unit}], the largest range around the start pose.",
    ),
    "functions.zero": (
        "Between the start and the zero pose, {drive} = {zero} {unit}, the mechanism passes a toggle position (Assur "
        "group {groups}): one function can't follow both assembly modes.",
        "Set zero within [{low} {unit}, {high} {unit}]; or start the drive on the side of the zero pose.",
    ),
    "functions.still": (
        "These joints don't move anywhere in the range: {joints}.",
        "If they should move, check whether two pivots coincide, or whether the range is too small.",
    ),
    "functions.sweep": (
        "A direction turns by {spread} deg over the range, relative to any link (joints {joints}); a function in the "
        "dialect {dialect} covers {most} deg.",
        "Use a narrower range; a range that is too wide for the arccosine of the dialect seed may be possible with "
        "atan2 in wizard.",
    ),
    "functions.error": (
        "With any number of decimals, the error of a function is {error} (rad or mm) at {drive} = {at} {unit}.",
        "Use a range farther from poses in which links are collinear or pins coincide.",
    ),
    "functions.length": (
        "The functions can't be split into texts below {longest} characters; the minimum is {least}.",
        "Set longest to {least} or more.",
    ),
    "functions.no-closed-form": (
        "The links {links} can only be assembled simultaneously (Assur group {group}): their joints have no function "
        "in closed form.",
        "Set approximate to use polynomials in the value of {drive}; over this range those of degree {degree} have "
        "an error of {error} (rad or mm), so approximate: {approximate} is enough. A narrower range reduces the "
        "error.",
    ),
    # Of workspaces.
    "workspace.drives": (
        "A workspace needs two drives (or one: then it is a curve); this mechanism has {count}: {names}.",
        "Fix links to each other until two drives remain, or give the mechanism another drive.",
    ),
    "workspace.cluster": (
        "The workspace study supports only mechanisms of dyads; this one has an Assur group that is solved by "
        "Newton's method: {groups}.",
        "Use a mechanism of dyads; the limits study can move one drive of this one.",
    ),
    "workspace.fixed-point": (
        "The working point {name} is on the frame, so it doesn't move.",
        "{near} The working point must belong to a moving link.",
    ),
    "workspace.no-values": (
        "There are no values of {name}.",
        "Give at least one, for example [0, 60, 90]; or remove the parameter.",
    ),
    "workspace.no-range": (
        "The drive {drive} is linear, and its range isn't given.",
        "Give its range, for example drives: {{{drive}: [0 {unit}, 100 {unit}]}}; or a cylinder's length.",
    ),
    "workspace.too-many": (
        "There would be {count} regions; the limit is {limit}.",
        "Use fewer values, or modes: own.",
    ),
    "workspace.unbounded": (
        "The region of the point {name} is unbounded: two guides are parallel near {at}.",
        "Give the drives ranges in which the guides aren't parallel.",
    ),
    "workspace.pins-meet": (
        "The outer pins of an Assur group coincide at {at}, at the end of a range or on a whole curve of such "
        "values; its links can have any direction there, and the region is divided.",
        "Give the drives ranges away from such values; or make the lengths of the group's links slightly different.",
    ),
    "workspace.incomplete": (
        "The region of the mode {mode} is incomplete: {share} % of the random samples lie outside it.",
        "Use another chord, or a part of the drives' ranges; its area is only a lower bound.",
    ),
    "workspace.doubt-area": (
        "The area of the mode {mode} isn't certified: as drawn it is {size} beyond the bounds proved by enclosures "
        "of all its poses.",
        "Use a smaller chord, or a part of the drives' ranges. The plot isn't reliable near {at}.",
    ),
    "workspace.doubt-open": (
        "The area of the mode {mode} isn't certified: {size} of it is undecided, more than one percent, most of it "
        "near {at}.",
        "The region is very thin there, or its boundaries almost touch. Use only those digits of its area on which "
        "the bounds agree.",
    ),
    "workspace.doubt-left-out": (
        "The region of the mode {mode} isn't certified: {size} that can certainly be reached lies outside it, some "
        "of it near {at}.",
        "Use another chord, or a part of the drives' ranges; rely only on the bounds of its area.",
    ),
    "workspace.doubt-too-much": (
        "The region of the mode {mode} isn't certified: {size} of it certainly can't be reached, some of it near {at}.",
        "Use another chord, or a part of the drives' ranges; rely only on the bounds of its area.",
    ),
    "workspace.doubt-edge": (
        "The boundary of the mode {mode} isn't certified: at {size} of its corners, one of them at {at}, it runs "
        "through points that are certainly inside or outside.",
        "Use another chord, or a part of the drives' ranges; rely only on the bounds of its area.",
    ),
    "workspace.doubt-count": (
        "The plot of the mode {mode} isn't certified: across {size} of its curves, some of it near {at}, the number "
        "of poses doesn't change as required.",
        "A curve may be missing or wrong there: the area and its bounds don't depend on it, but plots and the "
        "guaranteed region may. Use another chord, or a part of the drives' ranges.",
    ),
    "workspace.doubt-back": (
        "The region of the mode {mode} isn't certified: {size} of the tested positions aren't reproduced from their "
        "drive values, one of them at {at}.",
        "This is a bug of linkwright. Please report it with the file.",
    ),
    "workspace.doubt-unsettled": (
        "The region of the mode {mode} isn't certified: its area still changed by {size} in the last refinement of "
        "the mesh.",
        "Use a part of the drives' ranges, so that the mesh is finer there.",
    ),
    "workspace.doubt-cut": (
        "The region of the mode {mode} isn't certified: {size} of its curves lie between parts of one face, near {at}.",
        "A curve may be missing there. Use another chord, or a part of the drives' ranges.",
    ),
    "workspace.doubt-dangle": (
        "The region of the mode {mode} isn't certified: {size} of its curves have an open end, near {at}.",
        "A curve may be missing there. Use another chord, or a part of the drives' ranges.",
    ),
    "workspace.doubt-ring": (
        "The region of the mode {mode} isn't certified: {size} of its curves intersect themselves, near {at}.",
        "Use another chord, or a part of the drives' ranges.",
    ),
    "workspace.doubt-rough": (
        "The region of the mode {mode} isn't certified and isn't drawn: {size} pieces of its curves can't be "
        "followed, one of them near {at}.",
        "Two joints of an Assur group may coincide there in many positions, so that its links can have any "
        "direction. Change a length slightly, or use a part of the drives' ranges.",
    ),
    "workspace.doubt-nowhere": (
        "The region of the mode {mode} isn't certified: {size} pieces of its curves can't be located, near {at}.",
        "Use another chord, or a part of the drives' ranges.",
    ),
    "workspace.stopped": (
        "Interrupted after {done} of {total} regions. These are kept; other requested results for them may be missing.",
        "Run the study again. In the same results folder it resumes: finished regions aren't computed again.",
    ),
    "workspace.part-damaged": (
        "The file {file} with a region of an interrupted study is damaged or can't be read. The region was computed "
        "again.",
        "No change is needed. If it happens again, check the disk.",
    ),
    "workspace.no-area": (
        "The point {name} moves only along curves, or not at all, so it has no region{values}.",
        "Use a point that both drives move; or widen the drives' ranges.",
    ),
    "workspace.never-closes": (
        "The links can't be assembled at any pose{values}: {links} are closest to it at {at}, where {joints} are "
        "{distance} {unit} apart, {short}.",
        "{lengths}; or widen the drives' ranges.",
    ),
    # Of workspaces: maps.
    "workspace.two-drives": (
        "{section} needs two drives; with one, the point moves along a curve.",
        "Remove {section}, or give the mechanism another drive.",
    ),
    "workspace.map-name": (
        "There is no map called '{name}' here.",
        "Use one of these: {known}.",
    ),
    "workspace.map-task": (
        "The map '{name}' needs {key}.",
        "Add {key}, or use another map.",
    ),
    "workspace.limit-missing": (
        "{key} has no value for {drives}.",
        "Give one for each of the two drives.",
    ),
    "workspace.limit-positive": (
        "{what} isn't positive: {given}.",
        "Give a positive value, or remove it.",
    ),
    # Of workspaces: trajectories.
    "workspace.hold-steps": (
        "Trajectories need either a number of steps or a step size; both are given.",
        "Write steps, for example steps: 36, or every, for example every: 10 deg.",
    ),
    "workspace.hold-many": (
        "The range of {drive} has {count} such steps; at most {limit} trajectories are computed.",
        "Give a larger step under every.",
    ),
    # Of clearances.
    "clearance.cam": (
        "A clearance at {name} moves the contacts of the cam {cam}, which touches on two sides (closed: {closed}); "
        "linkwright doesn't compute which of them is in contact.",
        "Remove this joint; give the clearance as a tolerance of the centre distance instead.",
    ),
    "clearance.no-joint": (
        "{name} isn't a joint, so it has no clearance.",
        "{near} A pin made by a revolute joint has the name of that joint.",
    ),
    "clearance.one-link": (
        "{name} is a point of {link} only, so there is no joint that could have a clearance.",
        "Give another link a point of that name, or remove the clearance.",
    ),
    "clearance.not-positive": (
        "The length {text} isn't positive.",
        "Give a positive length; joints without clearance aren't listed.",
    ),
    "clearance.indeterminate": (
        "The clearance of {name} needs its moment, which isn't determined: the slides {loop} constrain each other's "
        "direction.",
        "Remove this clearance, or pin one of the links to a sliding block.",
    ),
    "clearance.no-length": (
        "The length of the guide {name} is missing; it determines how far the slider tilts.",
        "Give it beside the clearance, for example length: 60.",
    ),
    "clearance.centre": (
        "{name} isn't a point of {links}, the two links of this guide.",
        "Name the point of one of them at the middle of the guide's bearing length.",
    ),
    "clearance.short-guide": (
        "The clearance of {name} is at least half of its length, so the slider isn't guided.",
        "Check both numbers and their units.",
    ),
    "clearance.no-key": (
        "The clearance of {name} ({kind}) has no {key}.",
        "Remove {key}.",
    ),
    "clearance.no-play": (
        "The clearance of {name} can't be evaluated: joints of this kind ({kind}) don't define their points of "
        "contact.",
        "Remove it, or give the clearance as the tolerance of a dimension.",
    ),
    "clearance.not-on-pin": (
        "{link} isn't on the pin {name}, so the pin can't be fixed in it.",
        "Name one of its links: {links}.",
    ),
    "clearance.too-large": (
        "The clearance of {name} isn't smaller than the link {link}, which reaches {length} from there.",
        "Check the number and its unit: it is the radial clearance, half the difference of the diameters.",
    ),
    "clearance.roller": (
        "The clearance of {name} isn't smaller than the radius of the roller there, {radius}.",
        "Check the number and its unit: it is the radial clearance, half the difference of the diameters.",
    ),
    "clearance.no-force": (
        "The joint {name} of {links} transmits no force in the whole run, so its side of contact isn't known: its "
        "clearance is included only in the bound.",
        "Add masses, loads or springs that load the joint, or use the bound.",
    ),
    "clearance.undetermined": (
        "The reaction in the joint {name} of {links} has no finite value somewhere in the run: its clearance is "
        "included only in the bound.",
        "Check for a singular position, or for a load without a value there.",
    ),
    "clearance.no-figure": (
        "The effect of the clearances on {names} isn't computed: {why}.",
        "Use a position, an angle or a length, with max, min, extremes, span, value, mean or rms.",
    ),
    # Tolerances.
    "tolerance.unknown-class": (
        "'{given}' is neither a tolerance class nor a parameter of this file.",
        "Write a number, [lower, upper], or a class such as {known}.",
    ),
    "tolerance.class-or-parameter": (
        "{name} is both a tolerance class and a parameter of this file.",
        "Rename the parameter; or write ({name}) if the parameter is meant.",
    ),
    "tolerance.distribution": (
        "'{given}' isn't a distribution of a tolerance.",
        "Write one of: {known}.",
    ),
    "tolerance.cp-and-sigma": (
        "Both cp and sigma are given, but each of them defines the width of the distribution.",
        "Keep one of them.",
    ),
    "tolerance.no-sigma": (
        "The width of a {name} distribution follows from the limits; cp and sigma don't apply.",
        "Remove them, or write distribution: normal or truncated.",
    ),
    "tolerance.cp": (
        "The capability cp = {cp} isn't positive.",
        "Give a positive number; 1 means that the limits are six standard deviations apart.",
    ),
    "tolerance.limits": (
        "The limits {given} don't define a tolerance: the lower limit must be below the upper one.",
        "Give a positive number for plus and minus, or [lower, upper]; for a fixed deviation, change the value itself.",
    ),
    "tolerance.too-large": (
        "The tolerance reaches {limit} {unit}; it must be smaller than the dimension itself ({nominal} {unit}).",
        "Correct the tolerance or its unit. Give a coordinate that may be zero as zero.",
    ),
    "tolerance.derived": (
        "{name} is computed from other parameters ({text}), so it can't have a tolerance of its own.",
        "Give the tolerance to these parameters, or add a parameter for the error to the expression, such as "
        "{name}_error: 0.",
    ),
    "tolerance.size": (
        "{given} has no tolerance for {asked} {unit}: it covers {low} to {high} {unit}.",
        "Use another class, or give the limits.",
    ),
    "tolerance.side": (
        "{given} defines the tolerance of an angle by the length of its shorter side, which is missing.",
        "Give it beside the limits, for example side: 60 mm; or give the limits as numbers.",
    ),
    "tolerance.class-dimension": (
        "{given} has tolerances of lengths only (a general class of angles too), and {name} isn't one.",
        "Give the limits as a number or [lower, upper].",
    ),
    "tolerance.missing": (
        "{name} is listed as a deviation but has no tolerance, and there is no general tolerance for it.",
        "Give it a tolerance under parameters; or write general: ISO 2768-m, which covers lengths, and angles with a "
        "side.",
    ),
    "tolerance.named-twice": (
        "{name} is listed twice.",
        "List each parameter once.",
    ),
    "tolerance.none": (
        "No tolerances are defined, and there is no change of temperature.",
        "Define dimensions under parameters and give them a tolerance, for example AB: {{value: 155, tolerance: "
        "0.05}}; or write general: ISO 2768-m.",
    ),
    "tolerance.skipped": (
        "{general} has no tolerance for the size of {names}, so these are treated as exact.",
        "If they deviate, give them tolerances of their own.",
    ),
    "tolerance.no-derivative": (
        "{text} has no derivative at the nominal dimensions, so deviations can't be propagated through it.",
        "Write it in a different form, or give this parameter's value as a number.",
    ),
    "tolerance.no-contributor": (
        "No deviation is called {name}.",
        "{near} Use a parameter with a tolerance, or a change of temperature.",
    ),
    "tolerance.correlation-twice": (
        "{name} is listed twice in one correlation.",
        "List each deviation once; its correlation with itself is always 1.",
    ),
    "tolerance.correlation-pair": (
        "The correlation of {names} is already given in an entry before this one.",
        "Give each pair once.",
    ),
    "tolerance.correlation-shape": (
        "The correlation matrix of {count} names needs {count} rows of {count} numbers.",
        "Give all of them, including the diagonal; or one number for all pairs.",
    ),
    "tolerance.correlation-range": (
        "The correlation coefficient {value} lies outside -1 to 1.",
        "Give a value within this range.",
    ),
    "tolerance.correlation-diagonal": (
        "The diagonal of the correlation matrix must be 1.",
        "Write 1 there: the correlation of a deviation with itself is always 1.",
    ),
    "tolerance.correlation-symmetry": (
        "The correlation matrix isn't symmetric.",
        "Give the same coefficient for a pair in both of its positions.",
    ),
    "tolerance.correlation-indefinite": (
        "These correlations aren't possible: the correlation matrix has the eigenvalue {least}, and none may be "
        "negative.",
        "Correct the coefficients: two deviations that are each closely correlated with a third are also correlated "
        "with each other. Pairs that aren't given count as 0.",
    ),
    "tolerance.material-or-expansion": (
        "A change of temperature needs exactly one of the material and its expansion coefficient.",
        "Write material: steel; or expansion: 11.5, in 1e-6/K.",
    ),
    "tolerance.material": (
        "The expansion coefficient of '{given}' isn't known.",
        "{near} Otherwise write expansion: with the coefficient in 1e-6/K.",
    ),
    "tolerance.thermal-name": (
        "A parameter has the same name as this change of temperature.",
        "Rename one of the two.",
    ),
    "tolerance.no-length": (
        "Nothing expands: the file has no parameter that is a length and isn't computed from others.",
        "Define lengths under parameters.",
    ),
    "tolerance.not-a-length": (
        "{name} isn't a length, so it doesn't expand.",
        "Name lengths only.",
    ),
    # Of accuracy: tolerances from targets, dimensions from measurements.
    "accuracy.cost": (
        "The cost law {law} can't have these coefficients: {given}.",
        "Give finite numbers: the first of several may be 0, all others must be positive; costs in a table may be 0.",
    ),
    "accuracy.no-contributor": (
        "{name} isn't a deviation of this study: its tolerance can't be allocated, and its deviation can't be "
        "estimated.",
        "{near} Otherwise give the parameter a tolerance, or general, and list it under parameters.",
    ),
    "accuracy.no-target": (
        "'{name}' isn't a result of this study.",
        "{near} An output of a signal at a position is 'E.x at POSITION'.",
    ),
    "accuracy.target": (
        "The target half-width {text} isn't positive, or is too large.",
        "Give the allowed deviation to either side, for example 0.5.",
    ),
    "accuracy.half-widths": (
        "The half-widths of a tolerance must be positive and increasing: {low}, {high}.",
        "Give between: [minimum, maximum], in the parameter's unit.",
    ),
    "accuracy.no-grade": (
        "ISO 286 has no half-width of {grades} for {name}: its grades cover lengths up to 3150 mm.",
        "Give a table of half-widths in {unit}: table: [[half-width, cost], ...]; or grades: false.",
    ),
    "accuracy.no-grade-between": (
        "No standard grade of {name} lies between {low} and {high} {unit}.",
        "Widen between, or give grades: false.",
    ),
    "accuracy.target-unreachable": (
        "{name} can't be kept within {wanted} {unit}: the minimum tolerances that are allowed give {best} {unit}.",
        "Allow smaller half-widths (between), give more parameters a cost law, or tighten the tolerances of those "
        "without one.",
    ),
    "accuracy.targets-loose": (
        "The maximum tolerances that are allowed meet all targets, so the targets have no effect.",
        "Set narrower targets, or allow larger half-widths (between).",
    ),
    "accuracy.no-choice": (
        "No combination of standard grades or processes meets the targets, although continuous half-widths do.",
        "Allow finer ones: widen between, or add processes to the tables.",
    ),
    "accuracy.not-optimal": (
        "The tolerances of minimum cost weren't found: the optimality conditions have a residual of {off} of the cost.",
        "Narrow the half-widths (between), or scale costs and targets to common magnitudes.",
    ),
    "accuracy.measured-source": (
        "Measurements need either a file or points.",
        "Give file: measured.csv, or points: [{{t: 0.1 s, E.x: 712.3}}, ...].",
    ),
    "accuracy.no-place": (
        "No column gives the position at which the outputs were measured; the columns are: {given}.",
        "Add one of these, or name it with at: {known}.",
    ),
    "accuracy.measured-unit": (
        "The unit {unit} doesn't fit {name}.",
        "Use a unit such as {usual}.",
    ),
    "accuracy.measured-number": (
        "In row {row} of the measurements, {name} isn't a number.",
        "Write a number with a decimal point; only cells of outputs may be empty.",
    ),
    "accuracy.nothing-measured": (
        "There are no measured outputs.",
        "Add a column for each output, and a row for each position.",
    ),
    "accuracy.empty-column": (
        "The column {name} has no values.",
        "Write numbers, or remove the column.",
    ),
    "accuracy.no-pose": (
        "Row {row} was measured at {name} = {value} {unit}, which the run doesn't reach.",
        "Correct the row, or make studies.cycle cover it.",
    ),
    "accuracy.several-poses": (
        "Row {row} was measured at a value that {name} has several times, in different poses: at {times}.",
        "Give the time t of each row instead, or make studies.cycle cover one direction of motion only.",
    ),
    "accuracy.sigma": (
        "The standard deviation {sigma} of measurements isn't positive.",
        "Give a positive value in the output's unit, or remove it: it is then estimated from the residuals.",
    ),
    "accuracy.not-measured": (
        "{name} isn't measured; measured outputs: {known}.",
        "Give sigma for measured outputs only.",
    ),
    "accuracy.few-measurements": (
        "There are {count} measurements for {parameters} deviations; at least {least} are needed.",
        "Measure at more positions, list fewer deviations under parameters, give sigma, or set prior: true.",
    ),
    "accuracy.sigma-open": (
        "The measurements of {name} aren't sufficient to estimate their standard deviation as well.",
        "Give it under sigma, or measure at more positions.",
    ),
    "accuracy.measured-without-value": (
        "An output has no finite value or derivative at a measured position of the nominal motion.",
        "Remove the rows near dead centres and other singular positions.",
    ),
    "accuracy.scale-open": (
        "The size of the mechanism isn't identifiable from the measurements: {names} may all be larger or smaller in "
        "proportion.",
        "Measure a length too, or remove one of them from parameters; only their ratios are estimated.",
    ),
    "accuracy.not-told-apart": (
        "{names} aren't identifiable separately: their deviations can cancel each other in every measured output.",
        "Measure another output or at other positions, or remove one of them from parameters.",
    ),
    "accuracy.no-effect": (
        "{name} isn't identifiable: it has no effect on the measured outputs, or far too little.",
        "Measure another output or at other positions, or remove it from parameters.",
    ),
    "accuracy.poor-fit": (
        "The residuals are larger than the given sigmas explain: chi-square is {ratio} times its degrees of freedom, "
        "which happens by chance with probability {share}.",
        "Check for outliers, or for a deviation that isn't listed under parameters; or give larger sigmas.",
    ),
    "accuracy.outliers": (
        "{count} measurement(s) deviate more than random errors explain; rows {rows}.",
        "Check these rows, and remove those that are wrong.",
    ),
    "accuracy.not-settled": (
        "The estimate hasn't converged: another step would change it by {step} of the tolerances' sigmas.",
        "Measure at more positions, or list fewer deviations under parameters.",
    ),
    # Structure.
    "structure.drive-no-joint": (
        "{link} and {on} share no {joint} joint, so the drive can't act between them.",
        "Name two links that meet at a pin (turns) or on a line (slides).",
    ),
    "structure.drive-two-joints": (
        "{link} and {on} are connected by several joints ({joints}), so it isn't clear which one the drive moves.",
        "Keep only one joint between the two links.",
    ),
    "structure.drive-too-many": (
        "{link} and {on} are already fully constrained by their joints or other drives; this drive makes them "
        "over-constrained.",
        "Remove the drive or a joint.",
    ),
    "structure.output-apart": (
        "The motion of {output} isn't connected to {link} and {on}, so a drive between them can't move it.",
        "Let the drive act on links that are connected to the output, or name another output.",
    ),
    "structure.loose": (
        "Under-constrained links: {links} (remaining degrees of freedom: {freedom}).",
        "Join them to constrained links, check the spelling of shared points, or add a drive. {hint}",
    ),
    "structure.loose-many": (
        "{count} links are under-constrained (remaining degrees of freedom: {freedom}); those next to the "
        "constrained links are {links}.",
        "Join them to constrained links, check the spelling of shared points, or add a drive. {hint}",
    ),
    "structure.unpinned": (
        "The points {point} of {link} and {other} of {on} have similar names, but each is on one link only, so they "
        "aren't a pin. Under-constrained links: {links} (remaining degrees of freedom: {freedom}).",
        "Give both points the same name if they are one pin; otherwise join the links to constrained ones, or add a "
        "drive.",
    ),
    "structure.unpinned-joint": (
        "The point {point} of {link} is on no other link, although its name is similar to that of the joint {other}. "
        "Under-constrained links: {links} (remaining degrees of freedom: {freedom}).",
        "Call it {other} if it is on that pin; otherwise join the links to constrained ones, or add a drive.",
    ),
    "structure.overconstrained": (
        "Over-constrained links: {links} (constraints too many: {excess}).",
        "Remove a joint or a drive, or add the link that is missing between two pins.",
    ),
    "structure.redundant-movable": (
        "{part} is redundant: with these dimensions the mechanism can still move (rank {rank} of {constraints} "
        "constraints, Gruebler's formula {gruebler}, mobility {mobility}), but its share of the forces is "
        "undetermined.",
        "Remove {part} from the model: the motion stays the same. The forces that it carries depend on clearance and "
        "stiffness.",
    ),
    "structure.nearly-redundant": (
        "{part} could move along as a redundant part, but the closure error of its joints reaches {miss} {unit}.",
        "Correct its dimensions, or remove it from the model.",
    ),
    "structure.moments-indeterminate": (
        "The slides {joints} constrain each other's direction: their forces are determined, but their moments "
        "aren't. Their moments and lever arms aren't reported.",
        "No change is needed. To get the moments, pin one of the links to a sliding block instead of guiding it.",
    ),
    "structure.loop-of-slides": (
        "The links {links} can't be assembled one after the other: they are in loops of slides only, which "
        "linkwright can't solve simultaneously.",
        "Drive another link, or replace one slide with a pin and a sliding block.",
    ),
    "structure.redundant": (
        "The joint {joint} between {links} is redundant: other joints already impose its constraints, so its forces "
        "are undetermined.",
        "Remove this joint, or the link that duplicates another.",
    ),
    # Assembly and motion.
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
        "No assembly of {links} was found at the start near the positions sketched under assembly.",
        "Check the lengths, and sketch the pins at their positions at the start of the motion.",
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
        "Transmit the load by other means: a third crank, a flywheel or gears take a parallelogram through its "
        "change point.",
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
    "motion.not-periodic": (
        "The motion isn't periodic: after {period}, point {element} is {distance} {unit} from its start.",
        "Correct the period, or give duration instead of period.",
    ),
}

# Phrases inside the texts above.
_TERMS: dict[str, str] = {
    # What is expected where something else is given.
    "expression": "a number or an expression",
    "plain": "a number, a text, true, false, a list or a mapping",
    "mapping": "a mapping (key: value)",
    "list": "a list",
    "text": "a text (numbers in quotes)",
    "name": "a name (letters, digits, underscores)",
    "other": "another kind of value",
    "outline-few": "at least three different points are needed, each once",
    "outline-crossed": "the lines between them cross, or all points are collinear",
    "direction": "three numbers [x, y, z], not all zero",
    "position": "[x, y] or 'r at angle'",
    "place": "a point of the link, [x, y] or 'r at angle'",
    "line": "a line such as 'G at 90 deg'",
    "shape": "'rod A-B', 'disc RADIUS at A' or 'point A'",
    "assembly": "'left of B-D', 'right of B-D', 'open', 'crossed', 'ahead of B along JOINT', 'behind B along JOINT' or [x, y]",
    "requirement": "'>= VALUE', '<= VALUE' or 'LOW .. HIGH'",
    "vector": "[x, y]",
    "interval": "[low, high]",
    "triangle": "[low, most likely, high]",
    "varying": "steps (from, to, count), a list of values, or a distribution (normal, uniform, triangular)",
    "cost": "a cost law, such as reciprocal: B or [A, B], exponential: [A, B, M], table: {{IT7: COST}}; numbers without units",
    "processes": "grades with costs ({{IT6: 12, IT7: 8}}), or [[half-width, cost], ...]",
    "tolerance": "a number, [lower, upper], a class such as ISO 2768-m, or a mapping",
    "correlation": "a number, or a matrix of numbers as a list of rows",
    "two-links": "[LINK, LINK]",
    "kind-revolute": "pin",
    "kind-prismatic": "prismatic joint",
    "kind-pin_in_slot": "pin in a slot",
    "kind-cam": "cam",
    "slot-place": "[ALONG, ACROSS]",
    "slot-places": "a list of points [ALONG, ACROSS]",
    "slot-radius": "radius",
    "two-points": "[POINT, POINT], one of each link",
    "two-lines": "[POINT at ANGLE, POINT at ANGLE], one on each link",
    "points": "points by name",
    "turns": "a number of turns and the drive that makes them, such as '1 motor'",
    "numbers": "a list of numbers",
    "segments": "a list of segments",
    "law-start": "start",
    "law-end": "end",
    "law-value": "value",
    "law-velocity": "velocity",
    "table-row": "[x, y]",
    "table-rows": "a list of points [x, y]",
    "column": "'COLUMN UNIT', for example angle deg",
    # Which names may be meant.
    "frame-other": "Rename '{name}' to 'frame', here and wherever it is used.",
    "frame-none": "Rename the fixed link to 'frame', here and wherever it is used.",
    "file-name": "Check its name and folder; 'linkwright new' writes a file to start from.",
    "gallery-model": "'{name}' is a model of the gallery; 'linkwright new {name}' writes it to a file.",
    "signal-forms": "Write POINT.x, LINK.angle, JOINT.s, DRIVE.torque, force(LINK, LINK).x, com(LINK).x or "
    "pole(LINK, LINK).x; see docs/file-format.md.",
    "near-one": "Did you mean '{names}'?",
    "near-some": "Did you mean one of these: {names}?",
    "near-one-of": "Did you mean '{names}'? All of them: {known}.",
    "near-some-of": "Did you mean one of these: {names}? All of them: {known}.",
    "near-none": "Write one of these: {names}.",
    "near-nothing": "The file has none yet.",
    # What the value of an option must be.
    "must-bool": "it must be true or false, not {given}",
    "must-number": "it must be a number, not {given}",
    "must-whole": "it must be a whole number, not {given}",
    "must-text": "it must be a text, not {given}",
    "must-above": "it must be greater than {gt}, not {given}",
    "must-least": "it must be at least {ge}, not {given}",
    "must-below": "it must be less than {lt}, not {given}",
    "must-most": "it must be at most {le}, not {given}",
    "must-choice": "it must be {expected}, not {given}",
    # What is given.
    "nothing": "nothing",
    "tab": "tab",
    "positive": "it must be positive",
    "and": "{first} and {last}",
    "none": "none",
    "given-mapping": "a mapping",
    "given-list": "a list of length {count}",
    # Why an entity of a drawing makes no path.
    "drawn-line": "line {at}",
    "drawn-group": "group {at} from its beginning",
    "drawn-inconsistent": "its data are inconsistent",
    "drawn-radius": "its radius isn't positive",
    "drawn-axis": "its major axis has no length",
    "drawn-ratio": "the ratio of its axes isn't between 0 and 1",
    "drawn-degree": "its degree is too small or too large",
    "drawn-knots": "its knots don't increase",
    "drawn-weights": "its weights aren't positive",
    "drawn-large": "its coordinates aren't finite",
    "drawn-far": "it lies farther from the origin than {limit} times its size",
    "drawn-long": "it has more than {limit} points",
    # What is wrong with the length of a run.
    "one-length": "give one of period, duration, turns",
    "length-positive": "it must be positive",
    "length-limit": "the run would last {seconds} s, but the limit is {limit} s; give fewer turns, a shorter time or a faster drive",
    "turns-form": "'{text}' isn't a positive number and a drive, such as '2 {drive}'",
    "turns-constant": "{drive} doesn't turn at constant speed; give duration instead",
    "turns-none": "{drive} doesn't turn",
    # What isn't a regular file.
    "a-folder": "a folder",
    "a-pipe": "a named pipe",
    "a-socket": "a socket",
    "a-device": "a device",
    "no-unit": "1 (a pure number)",
    # Kinds of names.
    "a-link": "a link",
    "a-point": "a point",
    "a-joint": "a joint",
    "a-slide": "a prismatic joint",
    "a-cylinder": "a cylinder",
    "a-cam": "a cam",
    "closure": "the closure of the joints",
    "equilibrium": "the equilibrium of the links",
    "power": "the power balance",
    "work": "the balance of work and energy",
    "measures": "the check of the measures",
    "unknown-share": "(unknown)",
    "shorter": "shorter",
    "longer": "longer",
    "a-drive": "a drive",
    "a-contributor": "a contributor (a parameter with a tolerance, a change of temperature)",
    "drive-limit": "The limit of {drive} under {under}",
    "limit-error": "The error limit",
    "size-of-force": "The magnitude of the force",
    "force": "[x, y] of a force",
    "a-spring": "a spring",
    "a-load": "a load",
    "a-counterweight": "a counterweight",
    "kind-spring": "spring",
    "kind-load": "load",
    "kind-counterweight": "counterweight",
    "weight-on": "{name} on {link}",
    "spring-between": "{name} from {start} to {end}, {does}",
    "spring-between-pull": "pulls with {effort} at the start",
    "spring-between-push": "pushes with {effort} at the start",
    "spring-between-none": "no force at the start",
    "spring-torsional": "{name} between {start} and {end}, {does}",
    "spring-torsional-pull": "turns {link} clockwise with {effort} at the start",
    "spring-torsional-push": "turns {link} counter-clockwise with {effort} at the start",
    "spring-torsional-none": "no torque at the start",
    "a-parameter": "a parameter",
    "a-function": "a function",
    "a-table": "a table",
    "a-law": "a motion law",
    "a-window": "a window",
    "a-measure": "a measure",
    "the-shaking": "the shaking force",
    "the-energies": "the energies",
    # Why links can't be assembled, and how long they would have to be.
    "gap-wide": "{by} {unit} more than the links can span ({limit} {unit})",
    "gap-narrow": "{by} {unit} less than the links can span ({limit} {unit})",
    "lengths-longer": "Make the links longer by at least {by} {unit}",
    "lengths-equal": "Make the difference between the links' lengths at least {by} {unit} smaller",
    # Why a clearance has no effect to state.
    "play-no-position": "it contains velocities, accelerations or forces, on which the effect of clearances isn't known",
    "play-reduction": "it evaluates many positions at once, or rates of change",
    "play-window": "the window moves with the clearances",
    # Quantities.
    "mass": "mass",
    "inertia": "moment of inertia",
    "number": "number",
    "radius": "radius",
    "length": "shortest length",
    "period": "period",
    "within": "width of the band",
    "side": "length of the shorter side",
    # Why an expression can't be read.
    "syntax-empty": "it is empty",
    "syntax-long": "it is longer than {limit} characters",
    "syntax-deep": "it is nested too deeply; give parts of it as parameters",
    "syntax-large": "the number {given} is too large",
    "syntax-character": "the character {given} has no meaning here",
    "syntax-operator": "an operator is missing before '{before}'",
    "syntax-open": "a closing bracket has no opening bracket",
    "syntax-close": "a closing bracket is missing before '{before}'",
    "syntax-close-end": "a closing bracket is missing at the end",
    "syntax-value": "a value is missing before '{before}'",
    "syntax-value-end": "a value is missing at the end",
    "syntax-attribute": "a name is missing after the dot",
    "syntax-unit": "'{word}' isn't a unit",
    "syntax-unit-power": "the power of a unit is one digit, 1 to 9",
    "syntax-place": "{name} isn't allowed here",
    # Other spellings than those of a file, and what is meant.
    "respelled-wide": "it has full-width characters",
    "respelled-signs": "it has characters that expressions don't support",
    "respelled-stray": "it has characters that aren't part of an expression",
    "respelled-comma": "numbers have a decimal point, not a comma",
    "respelled-speed": "rotational speeds are written in rpm or r/s",
    "respelled-unit": "units are written by their short names",
    "respelled-dot": "a dot is missing between an element and its signal",
    "respelled-sense": "the sign gives the direction of rotation; counter-clockwise is positive",
    "respelled-factor": "a * is missing between factors",
    "respelled-tolerance": "a tolerance is a key of its own, without a sign",
    "write-tolerance": "Write '{{value: {value}, tolerance: {text}}}'.",
    # Why YAML can't be read.
    "yaml-colon": "a value without quotes contains a colon, or the line above has none",
    "yaml-no-colon": "a name has no colon and value",
    "yaml-indentation": "the indentation of this line, or its '-', doesn't match the lines above",
    "yaml-bracket": "a bracket isn't closed, or a comma is missing",
    "yaml-quote": "a quote isn't closed",
    "write-bound": "Write '>= {text}' or '<= {text}'.",
    "write-name": "Use letters of any script, digits and underscores, for example {text}.",
    "name-form": "Use letters of any script, digits and underscores (at most {limit}), and don't start with a digit; name a point "
    "of a link without the link.",
    "write-bare": "Write {text}.",
    "write": "Write '{text}'.",
    "write-either": "Write '{text}', or '{other}' if the comma separates thousands.",
}

_ALL = {**_TEXTS, **CAM_TEXTS, **PLAUSIBILITY_TEXTS, **ABSENT_TEXTS}

FINDINGS: dict[str, str] = {
    **{f"{code}.what": what for code, (what, _) in _ALL.items()},
    **{f"{code}.mend": mend for code, (_, mend) in _ALL.items()},
    **{f"term.{name}": text for name, text in {**_TERMS, **CAM_TERMS, **EXAMPLE_TERMS, **PLAUSIBILITY_TERMS}.items()},
}
