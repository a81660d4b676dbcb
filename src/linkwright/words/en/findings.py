"""What findings say: `CODE.what` and `CODE.mend`, with the data of the finding filled in.

`term.…` are phrases that stand for data inside them. Quantities in the data carry their units; the few that
don't are in SI, and the text says so.
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
        "{file} is {kind}; only regular files are read.",
        "Name a file, or a link to one.",
    ),
    "file.not-found": (
        "There is no file {file}.",
        "{hint}",
    ),
    "file.unwritable": (
        "Can't write to {file}: {reason}.",
        "Choose another folder with --out, or make this one writable.",
    ),
    "file.package-fails": (
        "The package {package} can't be loaded: {reason}",
        "Where it looks for your home, name a folder by the variable HOME; else install the package again.",
    ),
    "file.no-temporary": (
        "There is no folder for temporary files: {reason}.",
        "Name a folder that can be written to: TMPDIR=FOLDER linkwright ... (TEMP on Windows).",
    ),
    "file.needs-package": (
        "This needs the package {package}, which isn't installed.",
        "Install it: pip install 'linkwright[{extra}]'.",
    ),
    "file.too-large": (
        "The file has more than {limit} bytes, the most that a model file may have.",
        "Put long tables into CSV files beside the model and name them under tables.",
    ),
    "file.binary": (
        "This is no text file: byte {at} can't stand in one.",
        "Save the model as plain text in UTF-8.",
    ),
    "file.encoding": (
        "The file isn't UTF-8 (byte {at}); it looks like {encoding}.",
        "Save it as UTF-8: in Notepad and most editors under 'Save as', 'Encoding'.",
    ),
    "file.wide": (
        "Full-width characters stand where a file takes half-width ones: {given}",
        "{hint}",
    ),
    "file.colon": (
        "A space is missing behind the colon: {given}",
        "{hint}",
    ),
    "file.equals": (
        "A value follows a colon, not '=': {given}",
        "{hint}",
    ),
    "file.decimal-comma": (
        "YAML splits '{text}' at the comma; numbers have a decimal point.",
        "Write {meant}.",
    ),
    "file.character": (
        "A text here holds a control character.",
        "Type the text again; write no \\x, \\u or \\0 escapes in it.",
    ),
    "file.empty": (
        "The file is empty.",
        "Start it with 'linkwright: 1', then give links and drives; see docs/file-format.md.",
    ),
    "file.documents": (
        "A second document starts here (after '---' or '...'); a model file holds one.",
        "Take the marker out, or split the file.",
    ),
    "file.mapping": (
        "The file holds no 'key: value' entries at its top level.",
        "Start it with 'linkwright: 1', then give links and drives; see docs/file-format.md.",
    ),
    "file.version": (
        "The file doesn't say that it is a model of format version {known} (given: {given}).",
        "Write 'linkwright: {known}' as its first line.",
    ),
    "file.yaml": (
        "This can't be read as YAML: {reason}.",
        "Look here and in the line above for an open bracket or quote, a missing colon, or wrong indentation.",
    ),
    "file.tab": (
        "A tab stands where YAML takes spaces only.",
        "Replace the tab by spaces; most editors can insert spaces for the tab key.",
    ),
    "file.quote": (
        "YAML doesn't take a value that starts like '{value}' as text.",
        "Put the value in double quotes.",
    ),
    "file.comma": (
        "YAML splits '{text}' at the commas, because it isn't quoted.",
        'Put the expression in quotes: "{text}".',
    ),
    "file.alias": (
        "'{mark}' is an anchor or alias of YAML, which model files don't have.",
        "Use a parameter instead; if the value is meant to begin with '*' or '&', put it in double quotes.",
    ),
    "file.tag": (
        "'{tag}' is a type tag of YAML, which model files don't have.",
        "Take the tag out; if the value is meant to begin with '!', put it in double quotes.",
    ),
    "file.key": (
        "A list or mapping stands where a name is expected before a colon.",
        "Write a plain name there; a value in braces or brackets goes after the colon.",
    ),
    "file.depth": (
        "Values are nested more than {limit} levels deep.",
        "Model files need five levels at most: look for a bracket too many.",
    ),
    "file.duplicate": (
        "'{name}' stands twice in the same place, first in line {first}.",
        "Rename or remove one of the two.",
    ),
    "file.too-many": (
        "There are {count} entries here; {limit} is the most that a model file may hold.",
        "Split the model; put long tables into CSV files.",
    ),
    "file.long": (
        "This text is longer than {limit} characters.",
        "Shorten it; give parts of a long expression as parameters.",
    ),
    "file.more": (
        "At least {count} more problems were found.",
        "Correct those above first; many of the others may result from them.",
    ),
    "file.missing": (
        "'{name}' is missing here.",
        "Add it. The keys of such an entry are: {known}.",
    ),
    "file.unknown-key": (
        "'{name}' isn't a key that can stand here.",
        "{near} Otherwise remove it.",
    ),
    "file.kind": (
        "'{name}: {kind}': the kind of an entry is a key of its own.",
        "{near}",
    ),
    "file.kinds": (
        "An entry has one kind; here are keys of several: {keys}.",
        "Keep the keys of one kind, and write an entry of its own for the other.",
    ),
    "file.expected": (
        "Wanted here: {wanted}. Given: {given}.",
        "{hint}",
    ),
    "file.not-finite": (
        "{given} is no finite number.",
        "Give a finite number.",
    ),
    "file.bad-name": (
        "'{name}' can't be a name.",
        "{hint}",
    ),
    "file.reserved-name": (
        "'{name}' means something already: t is the time, pi the number, start and end the ends of a run.",
        "Choose another name.",
    ),
    "builder.twice": (
        "'{name}' was given to the builder twice.",
        "Rename or remove one of the two.",
    ),
    "file.exists": (
        "The file {file} is there already.",
        "Give another name with --out, or --force to write over it.",
    ),
    "gallery.unknown": (
        "The gallery has no model called '{name}'.",
        "{near} 'linkwright new' lists all.",
    ),
    # Large studies.
    "file.link": (
        "{file} is a symbolic link, through which linkwright writes nothing.",
        "Remove the link, or name the place that it leads to.",
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
        "The file {file} keeps the state of a study that was begun with {theirs}; this is {ours}, whose results may differ.",
        "Resume it with {theirs}, or start it anew: --fresh (in Python fresh=True, of a Checkpoint or store anew=True).",
    ),
    "blocks.holes": (
        "The store {file} lacks {count} of its {total} chunks, or they are cut short: something else has written to it.",
        "Start the same study again: it computes what is missing.",
    ),
    "blocks.busy": (
        "Another process is writing to {file}.",
        "Wait until it ends, or give this study another file.",
    ),
    "blocks.other-work": (
        "The file {file} keeps the state of another study: the model or the options differ.",
        "Give this study another file, put back what it was begun with, or start anew, which writes over the file.",
    ),
    "blocks.corrupt": (
        "The file {file} keeps the state of a study, but it is damaged.",
        "Put back a copy of it, or start the study anew, which writes over the file.",
    ),
    "blocks.no-space": (
        "There is no space left for {file}: {reason}.",
        "Make space and start the same study again: it goes on from what is saved.",
    ),
    "blocks.unwritable": (
        "Can't write to {file}: {reason}.",
        "Mend that and start the same study again: it goes on from what is saved.",
    ),
    "blocks.cluster-unreachable": (
        "No Dask scheduler answers at {address}: {reason}.",
        "Check the address (such as tcp://host:8786), and that 'dask scheduler' runs there and a firewall lets it through.",
    ),
    "blocks.cluster-lost": (
        "The connection to the Dask scheduler at {address} is lost.",
        "Start the scheduler and its workers again, then the same study: it goes on from what is saved.",
    ),
    "blocks.cluster-idle": (
        "The Dask scheduler at {address} has had no workers for {seconds} s.",
        "Start workers ('dask worker {address}'), then the same study: it goes on from what is saved.",
    ),
    "blocks.workers-died": (
        "Several workers of the cluster died over the same atoms ({first} to {last}).",
        "Look into the workers' logs; often it is memory: give each worker more of it, or fewer threads.",
    ),
    # Units and expressions.
    "units.wrong": (
        "'{word}' isn't a unit of {base}.",
        "Write a plain unit of {base}, for example {usual}.",
    ),
    "units.unknown": (
        "'{word}' isn't a unit.",
        "Write units such as mm, deg, kg, s, N, N*m, rpm, mm/s; products with *, quotients with /, powers with ^.",
    ),
    "expression.syntax": (
        "'{text}' can't be read as an expression: {reason}.",
        "Write arithmetic with + - * / ^ and brackets, as in '2*AB + 5 mm'; put a * between factors.",
    ),
    "expression.respelled": (
        "'{text}' can't be read as an expression: {reason}.",
        "{hint}",
    ),
    "expression.units-conflict": (
        "'{part}' has the unit {given}; here {wanted} is wanted.",
        "Correct the unit written, or the parameter; a parameter takes its unit from its own value or its other uses.",
    ),
    "expression.units-mixed": (
        "In '{part}' a value with the unit {given} meets one with {wanted}; they can't be added.",
        "Write units on the numbers, or correct the parameter; bare parameters take their units from their uses.",
    ),
    "expression.hertz": (
        "'{part}' counts events a second, which leaves open whether revolutions or radians are meant.",
        "Write rpm, r/s or deg/s for a speed; in sin and cos write 2*pi*{part}*t.",
    ),
    "expression.arguments": (
        "The function {name} is given {given} arguments; it takes {wanted}.",
        "Give {wanted} arguments, with commas between them.",
    ),
    "expression.unknown-function": (
        "There is no function, table or motion law called '{name}'.",
        "{near} Otherwise declare it under tables or laws.",
    ),
    "expression.unit-alone": (
        "'{name}' is a unit without a number, and no parameter is called so.",
        "Write the number before it, as in '1 {name}', or declare {name} under parameters.",
    ),
    "expression.undeclared-unit": (
        "A number without a unit stands here, but 'units' doesn't say the unit of {base} (such numbers: {count}).",
        "Declare {base} under units, or write the unit behind the number.",
    ),
    "expression.odd-unit": (
        "A number without a unit would be read in {dimension} here, which is seldom meant.",
        "Write the unit behind the number.",
    ),
    "expression.not-constant": (
        "'{name}' changes while the mechanism moves; here a constant is wanted.",
        "Use numbers, parameters and functions of them only.",
    ),
    "expression.ambiguous-unit": (
        "In '{part}', '{word}' is read as a unit, but a parameter is called so too.",
        "For the parameter write it in brackets: '*({word})'. For the unit, rename the parameter.",
    ),
    "parameters.cycle": (
        "These parameters are defined by one another: {cycle}.",
        "Give one of them as a number.",
    ),
    "parameters.value": (
        "'{text}' has no value: it divides by zero, takes a root of a negative number, or is too large.",
        "Check the numbers that go into it.",
    ),
    "value.not-finite": (
        "'{text}' has no value: it divides by zero, takes a root of a negative number, or is too large.",
        "Check the numbers and parameters that go into it.",
    ),
    "value.too-small": (
        "The {what} is {value} {unit}, which is too small.",
        "Give a positive value.",
    ),
    "value.rod": (
        "The ends {points} of the rod lie in one place.",
        "Name two points apart, or write 'point' instead of 'rod'.",
    ),
    "value.not-rising": (
        "The interval from {low} to {high} is empty.",
        "Give the lower end first.",
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
        "Nothing in this mechanism is called '{name}'.",
        "{near}",
    ),
    "name.unknown-kernel": (
        "There is no kernel '{name}'.",
        "{near}",
    ),
    "name.unknown-parameter": (
        "There is no parameter called '{name}'.",
        "{near} Otherwise declare it under parameters.",
    ),
    "name.taken": (
        "'{name}' is the name of {first} and of {second}; signals such as '{name}.x' couldn't be told apart.",
        "Rename one of the two.",
    ),
    "signal.no-attribute": (
        "'{attribute}' isn't a signal of {name}.",
        "{near}",
    ),
    "signal.indeterminate": (
        "The {attribute} in the slide {joint} isn't determined by statics: the slides {loop} hold each other's "
        "direction, and a couple may go round through all of them.",
        "Ask for the forces .x, .y or .normal instead, or pin one of the links to a sliding block.",
    ),
    "signal.no-joint": (
        "{a} and {b} don't touch each other, so there is no force between them.",
        "Write one of these: {options}. With three links on a pin, name the pin as the second.",
    ),
    "signal.several-joints": (
        "{a} and {b} touch each other at several joints: {joints}.",
        "Name the joint as the third: force({a}, {b}, JOINT).",
    ),
    "signal.no-mass": (
        "'{name}' isn't a link with mass, so it has no centre of mass.",
        "Give the link a mass, or follow one of its points.",
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
        "'{name}' is {kind}; one of its signals is wanted.",
        "Write one of these: {signals}.",
    ),
    # Links, joints, drives, loads.
    "model.no-frame": (
        "No link is called 'frame', so nothing stands still. Links: {links}.",
        "{hint}",
    ),
    "model.frame-mass": (
        "The frame has a mass; it doesn't move, so its mass has no effect.",
        "Take the mass out.",
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
        "The mechanism has no drive and can't move: its mobility is {mobility} by Gruebler's count.",
        "For the reactions of a structure write studies: {{reactions: {{}}}}. For a motion, remove a joint or split a link, "
        "and add a drive.",
    ),
    "model.no-drive": (
        "There is no drive, so nothing says how the mechanism moves.",
        "Add one, for example drives: {{motor: {{turns: crank, on: frame, speed: 60 rpm, start: 0 deg}}}}.",
    ),
    "mass.shape-and-com": (
        "A shape says where the mass sits already, but {given} is given too.",
        "Keep the shape, or com and inertia.",
    ),
    "mass.missing": (
        "{given} is given without a mass.",
        "Add the mass.",
    ),
    "mass.incomplete": (
        "A mass is given, but not how it is spread ({missing} is missing).",
        "Add com and inertia, or a shape such as 'rod A-B'.",
    ),
    "joint.kind": (
        "It isn't clear whether this joint slides or turns.",
        "Give either prismatic with line, or revolute with at.",
    ),
    "joint.line": (
        "A prismatic joint needs a line on each link, and nothing else.",
        "Write line: [H at 0 deg, G at 0 deg]: on each of the two links a point and the direction of the line.",
    ),
    "joint.at": (
        "A revolute joint needs the pinned point of each link, and nothing else.",
        "Write at: [P, Q], a point of the first link and one of the second.",
    ),
    "joint.slot": (
        "A pin in a slot needs exactly one of straight, arc and curve; given: {given}.",
        "For example straight: C at 0 deg, arc: {{centre: C, radius: 40}}, or curve: {{along: C at 0 deg, through: [[0, 0], "
        "[30, 8], [60, 0]]}}.",
    ),
    "joint.slot-places": (
        "A curved slot is given by 2 to {most} places; given: {count}.",
        "Write through: [[0, 0], [30, 8], [60, 0]], in the order along the line.",
    ),
    "joint.slot-order": (
        "The places of the curved slot don't ascend along its line (place {row}).",
        "Sort them by their first coordinate, and leave out places that stand twice.",
    ),
    "joint.lifts-off": (
        "The links of {joint} ({kind}) leave each other: they would have to be pulled together with {force} {of} at "
        "t = {time} s ({drive} = {value} {unit}).",
        "Preload them with a spring or a weight; a pin in a slot may bear on both flanks (flank: both).",
    ),
    "joint.same-link": (
        "Both links are {name}; a joint or drive acts between two different ones.",
        "Name the other link.",
    ),
    "joint.pin-twice": (
        "The link {link} would be on the pin {pin} with several of its points ({points}).",
        "Give these points other names, or take the joint out that ties them together.",
    ),
    "drive.kind": (
        "It isn't clear what is driven.",
        "Give one of turns and slides with the name of a link, or extends with that of a cylinder or slide.",
    ),
    "drive.on": (
        "A drive that turns or slides a link says on which other one; one that extends a slide doesn't.",
        "Give on with turns and slides (often on: frame), and leave it out with extends.",
    ),
    "sketch.missing-point": (
        "The link {link} takes the place of {name} from the sketch, which doesn't have it.",
        "{near} Otherwise give the point's place under sketch, or its coordinates in the link's own axes.",
    ),
    "sketch.unused": (
        "No link takes the sketched point {name}.",
        "List it among the points of a link, or take it out of the sketch.",
    ),
    "sketch.no-value": (
        "The value of {name} can't be read off the sketch.",
        "Give it as a number. The sketch tells the angle between links whose first two points are sketched, the "
        "length of a cylinder between sketched points, and the travel of a slide on the frame.",
    ),
    "sketch.mixed": (
        "Some sketched points have three coordinates ({three}), others two ({two}).",
        "Give all of them three, in the vehicle's axes, or all of them two, in the plane of the linkage.",
    ),
    "sketch.in-line": (
        "The sketched points lie in a line (or are less than three): they don't tell the plane of the linkage.",
        "State it, such as plane: xz or plane: {{normal: [0, 1, 0.02]}}, or sketch another pose.",
    ),
    "sketch.coincident": (
        "The points {a} and {b} of the link {link} lie at the same place in the plane of the linkage.",
        "Check their coordinates and the plane: the two need a distance.",
    ),
    "sketch.no-plane": (
        "This is no plane linkage: {name} lies {off} {unit} off the plane with the normal ({normal}), more than "
        "{limit} {unit}.",
        "Check the coordinates. Pins that stand at different places along their axes need the plane stated "
        "(plane: xz, or its normal); plane: {{within: LENGTH}} allows more or less.",
    ),
    "sketch.off-plane": (
        "{name} lies {off} {unit} off the plane with the normal ({normal}) that fits the pinned points best.",
        "Check its coordinates, or state the plane; plane: {{within: LENGTH}} says how much is meant.",
    ),
    "sketch.plane-unused": (
        "A plane is stated, but the sketch has no points of three coordinates.",
        "Give the sketched points as [x, y, z] in the vehicle's axes, or leave the plane out.",
    ),
    "sketch.plane-twice": (
        "The plane has both axes and normal.",
        "Give axes for a plane of two of the vehicle's axes, normal for any other.",
    ),
    "cylinder.same-point": (
        "Both ends of the cylinder are at {point}.",
        "Name two different points, such as one on the frame and one on the link that it moves.",
    ),
    # Cams.
    "cam.contact": (
        "What touches the cam isn't clear; given: {given}.",
        "Give roller with at (its centre), or knife with a point of the follower, or face with a line of it.",
    ),
    "cam.second": (
        "What rides on a second disc is stated, and the follower is closed by {closed}.",
        "Say closed: conjugate, or leave second out.",
    ),
    "cam.second-twice": (
        "The second disc is stated by more than one of base, at and face: {given}.",
        "Give one: where the follower's second contact is, or the disc's base circle.",
    ),
    "cam.second-other": (
        "Both discs of a pair have contacts of one kind; the first has {first}, the second {given}.",
        "Give the second the same kind: a roller with at, an edge by at alone, or a face.",
    ),
    "cam.same-link": (
        "Cam, follower and carrier must be three links: {cam}, {follower}, {on}.",
        "Name the link that carries the cam, the link that rides on it, and the one on which both are guided.",
    ),
    "cam.no-shaft": (
        "The cam's link {cam} isn't pinned to {on}.",
        "Give both a point of the same name on the camshaft's axis, or name another link under on.",
    ),
    "cam.no-motor": (
        "No drive turns {cam} on {on} by a law of its own.",
        "Add a drive that turns {cam} on {on}, without output; the cam's law is asked at its angle.",
    ),
    "cam.no-guide": (
        "The follower {follower} is neither pinned to {on} nor does it slide on it.",
        "Give both a point of the same name, or list a prismatic joint between them.",
    ),
    "cam.law": (
        "The law {law} doesn't fit the follower ({given}).",
        "Take a law with over: angle, of: {of} and beyond: repeat.",
    ),
    "cam.period": (
        "The law {law} goes over {period} {unit}; a cam needs a whole turn, or a whole part of one.",
        "Let the segments add up to a turn, for example with a dwell.",
    ),
    "cam.side": (
        "On which side the follower lies isn't clear: {given}.",
        "Write for example 'side: {meant}'.",
    ),
    "cam.askew": (
        "The face is {angle} {unit} out of square with the slide.",
        "Turn the face's line; only a face square to the slide is known.",
    ),
    "cam.offset": (
        "The follower {follower} passes the shaft at {offset} {unit}; base circle and roller reach out to {limit} {unit} "
        "only.",
        "Take a larger base circle, or lead the follower nearer to the shaft.",
    ),
    "cam.second-side": (
        "The second contact of {follower} must stay on the other side of the line from shaft to pivot all over the lift: "
        "its arm or face makes {low} to {high} {unit} with it; {least} to {most} {unit} would do.",
        "Move the second point or face, or change the second base circle.",
    ),
    "cam.second-height": (
        "The second contact of {follower} must stay beyond the shaft; at the largest lift it is {height} {unit} on the "
        "first one's side of it.",
        "Move the second point or face further away from the first.",
    ),
    "cam.second-base": (
        "The second contact of {follower} leaves its disc a base circle of {base} {unit}.",
        "Move the second contact further away from the shaft, or take a smaller second roller.",
    ),
    "joint.locks": (
        "The link that {joint} ({kind}) moves locks at t = {time} s ({drive} = {value} {unit}): {why}.",
        "Take a smaller lift or a longer way for it, by which the normal stays off the square to the link's way.",
    ),
    "cam.lifts-off": (
        "The follower of the cam {joint} lifts off: it would have to be pulled with {force} {of} at t = {time} s ({drive} = "
        "{value} {unit}).",
        "Add a spring or a stronger one, turn slower, or say closed: groove (conjugate, yoke) where form holds it.",
    ),
    "cam.locks": (
        "The follower of the cam {joint} locks at t = {time} s ({drive} = {value} {unit}): {why}.",
        "Take a smaller lift or a longer way for it; or another pivot, arm or base circle, by which the normal stays off "
        "the square to the follower's way.",
    ),
    "cam.loose": (
        "The yoke of the cam {cam} has up to {play} of play; forces are those of one without.",
        "Take a law whose lifts half a turn apart add up to the same everywhere, or a second disc: closed: conjugate.",
    ),
    "cam.reach": (
        "The arm of {follower} misses the base circle by {by} {unit}: arm {arm} {unit} and centre distance {distance} "
        "{unit} allow a roller's centre from {low} {unit} to {high} {unit} off the shaft; base circle and roller ask for "
        "{pitch} {unit}.",
        "Change the base circle, the arm or the centre distance until the asked distance lies between.",
    ),
    "cam.face": (
        "The face of {follower} can't lie on the base circle: its radius {base} {unit} less the face's offset {face} "
        "{unit} isn't within the centre distance {distance} {unit}.",
        "Change the base circle, the face's place or the centre distance.",
    ),
    "cam.no-distance": (
        "The follower {follower} is pinned where the cam's shaft is.",
        "Set the two pins apart.",
    ),
    "cam.no-arm": (
        "The point {point} lies on the follower's own pin.",
        "Name a point of the follower away from its pin.",
    ),
    "study.cams": (
        "The study {study} moves two drives through all their values, each on its own; the followers of cams ({names}) "
        "move with their motors.",
        "Leave the study out, or put a drive in the place of each cam.",
    ),
    "study.follower": (
        "{name} is the follower of a cam: it moves with the motor {motor}, not on its own.",
        "Name {motor} as the drive; its followers move along.",
    ),
    "motion.cylinder-length": (
        "The cylinder {name} would have to be {by} {length_unit} {end} than it can be: {length} {length_unit} "
        "between its pins at {time} s ({drive} {value} {unit}), where {limit} {length_unit} is the limit.",
        "Limit the drive, move one of the cylinder's points, or take a cylinder of another stroke.",
    ),
    "drive.law": (
        "It isn't clear how the drive moves.",
        "Give either speed and start (with an acceleration, if need be), or position as an expression in t.",
    ),
    "drive.start": (
        "Speed and start belong together.",
        "Give both: speed (constant), and start (the value at t = 0). A drive whose value a sketch shows may leave start out.",
    ),
    "drive.acceleration": (
        "An acceleration alone doesn't say where the motion begins.",
        "Add speed and start: speed and value at t = 0.",
    ),
    "drive.twice": (
        "{a} and {b} are driven against each other by {other} already.",
        "Keep one of the two drives.",
    ),
    "drive.output": (
        "'{name}' is no output that a drive can move: neither a prismatic joint nor a link of this model.",
        "{near} An output is a prismatic joint, or a link that is pinned to the frame.",
    ),
    "drive.output-own": (
        "{link} and {on} are the drive's own links; '{name}' is no output of it.",
        "Leave output out: the law then holds for the drive itself.",
    ),
    "drive.signal": (
        "The law of a drive can't follow '{name}', which results from the motion.",
        "Write the law in t, parameters and tables.",
    ),
    "drive.linear-table": (
        "The table {table} joins its points by straight lines, so the drive's speed would jump at each.",
        "Write between: cubic or between: quintic in the table.",
    ),
    "drive.not-finite": (
        "The {what} of the drive {drive} has no finite value below 1e40 at t = {time:.6g} s.",
        "Check its position for a division by zero, a root of a negative number, or a root at zero.",
    ),
    "drive.outside-table": (
        "The drive {drive} asks a table for {at:.6g}, outside its range {low:.6g} to {high:.6g} (in SI units: s, m, rad).",
        "Extend the table, or give it a period.",
    ),
    "load.empty": (
        "The load has neither a force nor a torque.",
        "Give one of them.",
    ),
    "load.at": (
        "It isn't said where the force acts.",
        "Add at: a point of the link, or [x, y] in its own coordinates.",
    ),
    "load.direction": (
        "A force is two numbers [Fx, Fy], or one number along a slide.",
        "Write force: [Fx, Fy] without along, or one number with along: JOINT.",
    ),
    "load.in": (
        "A force along a slide has its direction from the slide; 'in' has no meaning for it.",
        "Take 'in' out.",
    ),
    "joint.slides-tilted": (
        "The slide {joint} doesn't close the loop of the slides {loop}: the directions of its two lines differ by "
        "{angle} {unit} from what the others say.",
        "Correct the angles in line, so that around the loop they add up to the same direction.",
    ),
    "load.against-itself": (
        "The load acts on {name} against {name} itself: the two forces cancel.",
        "Name another link under against, or remove it if the load comes from outside the mechanism.",
    ),
    "load.signal": (
        "The load depends on '{name}', which itself results from the forces.",
        "Let it depend on the time, the motion, tables and parameters.",
    ),
    "load.outside-table": (
        "At t = {time} s ({drive} = {value} {unit}) the table {table} is asked for {at} {of}, outside its range {low} to "
        "{high} {of}.",
        "Extend the table, give it a period, or confine the load to a window.",
    ),
    "load.not-finite": (
        "It has no finite value at t = {time} s ({drive} = {value} {unit}).",
        "Look for a division by zero or the root of a negative number; a gas spring may be pushed in past its gas column.",
    ),
    # Springs.
    "spring.ends": (
        "It isn't clear between what this spring acts.",
        "Give from and to (two points), or turns and on (two links) for a torsional one.",
    ),
    "spring.law": (
        "A spring has one law, and may have damping besides; given: {given}.",
        "Give one of stiffness, force (torsional: torque), gas, or damping alone.",
    ),
    "spring.stray": (
        "{keys} has no meaning in a spring of this kind.",
        "Take it out; docs/file-format.md says what belongs together.",
    ),
    "spring.free": (
        "It isn't said where this spring is relaxed.",
        "Add free: the length (torsional: the angle) at which it exerts its preload, or nothing.",
    ),
    "spring.gas": (
        "A gas spring's push at the greater length alone doesn't say how it rises.",
        "Add progression (push at the smaller length over that at the greater one) and length: [smallest, greatest].",
    ),
    "spring.progression": (
        "The progression of a gas spring is above 1: it pushes harder when it is pushed in.",
        "Give the push at the smaller length over that at the greater one, mostly 1.2 to 1.5.",
    ),
    "spring.same-link": (
        "Both ends are on the link {name}, so the spring has no effect.",
        "Name a point or link elsewhere; with a point that several links share, say which under in: [LINK, LINK].",
    ),
    "spring.no-direction": (
        "At t = {time} s ({drive} = {value} {unit}) its two ends meet, so its force has no direction.",
        "Move one of its points.",
    ),
    "spring.outside-length": (
        "At t = {time} s ({drive} = {value} {unit}) it is {length} {of} long; the part allows {low} to {high} {of}.",
        "Take a part with another stroke, or move its points. Its law is continued beyond its ends.",
    ),
    # Tables.
    "table.source": (
        "A table has either a file or points.",
        "Give file with x and y, or points: [[x, y], ...].",
    ),
    "table.columns": (
        "It isn't said which columns of the file to take.",
        "Add x and y as 'COLUMN UNIT', for example x: angle deg.",
    ),
    "table.inline-columns": (
        "{given} names a column of a file, but the points stand here.",
        "Take it out; write units on the points, or leave them to the units that are declared.",
    ),
    "table.place": (
        "The file '{file}' doesn't lie beside the model.",
        "Put it into the model's folder, or below, and write its name without '..' and without a drive or root.",
    ),
    "table.unreadable": (
        "The file {file} can't be read: {reason}.",
        "Put the file beside the model, with its name as it is written here and permission to read it.",
    ),
    "table.too-large": (
        "The file {file} has more than {limit} bytes, the most that is read.",
        "Leave rows and columns out of it; of a drawing, all but the path.",
    ),
    "table.not-text": (
        "The file {file} isn't text in UTF-8: byte {at} (line {line}) can't stand in it.",
        "Save it as a CSV file in UTF-8, not in UTF-16, GBK or a spreadsheet's own format.",
    ),
    "table.bad-line": (
        "The file {file} can't be read as CSV at line {line}: {reason}.",
        "Look there and above for a quotation mark without its partner.",
    ),
    "table.empty": (
        "The file {file} is empty.",
        "Its first line names the columns, the following ones hold their numbers, with commas between them.",
    ),
    "table.separator": (
        "The file {file} separates its columns by '{sign}', where commas are expected.",
        "Save it with commas between the columns and points in decimal numbers.",
    ),
    "table.column-twice": (
        "The file {file} has several columns called '{name}'.",
        "Give each its own name, or remove those that aren't meant.",
    ),
    "table.no-column": (
        "The file has no column '{name}'. Its columns: {known}.",
        "Correct x and y, or the first line of the file.",
    ),
    "table.not-number": (
        "Line {row} of the file has '{given}' in the column '{name}', where a finite number below 1e40 belongs.",
        "Correct the cell; write decimal points, and no units.",
    ),
    "table.long": (
        "The file has more than {limit} rows.",
        "Leave rows out: the spline between them needs few.",
    ),
    "table.short": (
        "The table has {given} points; the curve between them needs at least {wanted}.",
        "Add points, or write between: linear.",
    ),
    "table.order": (
        "The argument doesn't ascend at point {row}.",
        "Sort the points, and give each argument once.",
    ),
    "table.uneven": (
        "Some points lie so close together, measured by the others, that no smooth curve goes through them.",
        "Leave out what is closest, or write between: linear.",
    ),
    "table.period": (
        "The points span more than one period.",
        "Give a longer period, or fewer points.",
    ),
    "table.not-closed": (
        "The points span one whole period, but the last value differs from the first.",
        "Make the two equal, or leave the last point out.",
    ),
    # Motion laws.
    "law.unknown": (
        "There is no motion law called '{name}'.",
        "{near} Otherwise give fractions, powers or a formula instead of law.",
    ),
    "law.segment": (
        "It isn't clear what kind of segment this is: given are {given}.",
        "Give one of {known}.",
    ),
    "law.keys": (
        "{given} can't stand in a segment of this kind ({head}).",
        "Take it out, or put it into a segment of its own.",
    ),
    "law.no-over": (
        "It isn't said how far along the axis the segment goes.",
        "Add over, for example over: 90 deg.",
    ),
    "law.way": (
        "It isn't said in one way how the value gets to its end: given are {given}.",
        "Give one of {known}; match, from, to, via and spline go together.",
    ),
    "law.argument-taken": (
        "In a formula {name} runs from 0 to 1 over the segment, but a parameter is called {name}.",
        "Give the parameter another name.",
    ),
    "law.formula": (
        "'{name}' can't stand in the formula of a motion law.",
        "Write it in u, which runs from 0 to 1 over the segment, parameters and functions.",
    ),
    "law.place": (
        "The motion law '{name}' is called where no drive's position stands.",
        "Call it in the position of a drive or the load of a cam study; measures and loads of the model name the drive's "
        "value.",
    ),
    "law.over": (
        "The segment's length along the axis isn't positive, or out of all proportion.",
        "Give it a length between 1e-12 and 1e12 s or rad.",
    ),
    "law.via": (
        "The points via don't lie in order, and apart, between the segment's start and end.",
        "Sort them; ways count from the segment's start.",
    ),
    "law.conditions": (
        "One polynomial is to meet {count} conditions; {limit} is the most.",
        "Leave points out, add spline: quintic, or cut the segment.",
    ),
    "law.end-rates": (
        "A spline of degree {degree} takes {wanted} rates at either end.",
        "Give as many in from and to, or match: velocity with spline: cubic, match: acceleration with spline: quintic.",
    ),
    "law.not-normal": (
        "The formula is {start} at u = 0 and {end} at u = 1; it must be 0 and 1.",
        "Divide it by its rise, and take its first value off.",
    ),
    "law.not-smooth": (
        "The formula, or one of its first two derivatives, has no finite value somewhere between u = 0 and u = 1.",
        "Check it for a division by zero, or a root at zero.",
    ),
    "law.powers": (
        "A power stands twice.",
        "Give each power once.",
    ),
    "law.fractions": (
        "The {count} fractions add up to {sum}; there must be four [b, c, d, z], or seven, none negative or below 1e-6 but 0, with the sum 1, and some acceleration on either side.",
        "Correct them: [0.25, 0, 0.75, 0] is the modified sine.",
    ),
    "law.skew": (
        "The law can't have its greatest velocity at {share} of its way.",
        "Give a skew from 0.001 to 0.999, and only of a symmetric law.",
    ),
    "law.control": (
        "{given} control values are too few for the B-spline; its degree needs {wanted}.",
        "Add control values, or give a smaller degree.",
    ),
    "law.period": (
        "The segments add up to {sum} {unit}; the period is {period} {unit}.",
        "Correct their lengths, add a dwell, or give the period.",
    ),
    "law.not-closed": (
        "The law starts at {start} {unit} and ends at {end} {unit}, so it can't be repeated.",
        "Let the segments come back, or write beyond: advance (goes on from there) or beyond: hold (stays there).",
    ),
    "law.open-end": (
        "At its {side} the segment takes its rates from segment {other}, which leaves them open too.",
        "State them in one of the two, by from or to.",
    ),
    "law.end-acceleration": (
        "The law {law} ends with an acceleration, and beside it the motion doesn't go on with the same one.",
        "Let its mirror image follow at once, a fall of the same law, height and length; or take a law that ends without acceleration.",
    ),
    "drive.law-jumps": (
        "The {what} of the motion law {law} jumps at {at} by {jump}, which no drive can follow.",
        "Take another law there, or blends that match the velocity: {{rise: ..., over: ..., match: acceleration}}.",
    ),
    # Windows, measures, studies.
    "window.one-signal": (
        "A window by a signal has one signal; {count} are given.",
        "Write {{SIGNAL: [low, high]}} with one signal.",
    ),
    "window.signal": (
        "'{given}' isn't a signal such as motor.angle.",
        "Write {{SIGNAL: [low, high]}}, for example {{motor.angle: [0 deg, 90 deg]}}.",
    ),
    "window.outside": (
        "The window {name} lies outside the run.",
        "Correct the window, or let the study run longer.",
    ),
    "measure.reduction": (
        "A measure asks for one thing of a signal; given: {given}.",
        "Give exactly one of: {known}.",
    ),
    "measure.where": (
        "A value is taken at one instant, and only a value is.",
        "Write value and where together: {{value: crank.angle, where: max E.x}}.",
    ),
    "measure.within": (
        "A dwell is told by the width of its band, and only a dwell is.",
        "Write dwell and within together: {{dwell: E.x, within: 0.5 mm}}.",
    ),
    "measure.bad-where": (
        "'{given}' doesn't name an instant.",
        "Write one of: max SIGNAL, min SIGNAL, SIGNAL = VALUE (such as motor.angle = 24 deg), start, end.",
    ),
    "measure.unit": (
        "The figure is in {wanted}; it can't be shown in {unit}.",
        "Choose a unit of the same kind as {wanted}, or take the unit out.",
    ),
    "measure.table": (
        "The table '{name}' can't be used in a measure.",
        "Tables are for drives, loads and springs; write the measure in signals, t and parameters.",
    ),
    "measure.nothing": (
        "The measure {name} has no value: nothing of the run lies in its window.",
        "Correct the window, or let the study run longer.",
    ),
    "measure.not-finite": (
        "The measure {name} has no finite value.",
        "Check its expression for a division by zero or a root of a negative number; is the mechanism at a singular pose, "
        "or an instant centre at infinity or without a motion?",
    ),
    "motion.too-many-turns": (
        "'{name}' turns too often in this run for its angle to be followed without gaps.",
        "Let the study run for a shorter time; a run whose only drive turns at constant speed has no such limit.",
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
        "{signal} may be unbounded near t = {time}; round-off hides which, so the measure {name} has no value.",
        "Choose a window without that instant, or write the expression with fewer cancelling terms.",
    ),
    "measure.two-values": (
        "The measure {name} has two values: {signal} jumps at t = {time}, where it is to be taken.",
        "Take the value a little earlier or later.",
    ),
    "measure.no-instant": (
        "The measure {name} has no value: the run doesn't reach the place that its 'where' names.",
        "Correct 'where' or the window, or let the study run longer.",
    ),
    "measure.unsettled": (
        "The search for {name} ended at its finest grid ({width}) and still changed: digits or narrow peaks may be "
        "missing.",
        "Confine the measure to a window, or let the study run for a shorter time.",
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
        "The option {key} of the study {study} is wrong: {reason}.",
        "Correct it; docs/file-format.md lists the options of each study.",
    ),
    "study.choice": (
        "The option {key} of the study {study} can't be {given}.",
        "{near}",
    ),
    "study.not-in-sweep": (
        "'{name}' has no meaning in the limits study: one drive moves through its values at unit speed, without forces.",
        "Take positions, angles, travels and their rates; forces and times belong into the measures of a cycle.",
    ),
    "study.cylinder-length": (
        "{drive} is not free to move so far: at {value} {unit} the cylinder {name} would have to be {by} {length_unit} "
        "{end} than it can be: {length} {length_unit} between its pins, where {limit} {length_unit} is the limit.",
        "Read the range with that in mind; studies.limits.ranges gives a smaller one.",
    ),
    "study.wide-range": (
        "The range of {drive} is wider than {limit} {unit}.",
        "Give a smaller range.",
    ),
    "motion.more-gaps": (
        "More intervals of the motion fail; the first {count} are listed.",
        "Correct the first one: the others usually repeat it turn by turn.",
    ),
    "study.long-motion": (
        "{drive} travels {travel} {unit} in the motion of the cycle: dead centres and extremes of a motion are searched "
        "for up to a travel of {limit} {unit}. Those of each drive alone are complete.",
        "Give studies.cycle fewer turns or a shorter duration.",
    ),
    # Of the workspace: wanted paths, required places.
    "workspace.path-source": (
        "A wanted path has one source; given are: {given}.",
        "Write points, or file, or drawing, or x and y as formulas in u.",
    ),
    "workspace.path-pace": (
        "A wanted path is followed either with the motor at constant speed, or in a given time.",
        "Write speed, for example speed: 30 rpm, or duration, for example duration: 2 s; not both.",
    ),
    "workspace.path-key": (
        "{key} has a meaning only together with {of}.",
        "Take it out, or add what it belongs to.",
    ),
    "workspace.path-still": (
        "The motor has no speed, so that it follows no path.",
        "Give one, for example 30 rpm; a negative one turns it the other way round.",
    ),
    "workspace.path-none": (
        "In none of {count} regions can the wanted path {name} be followed as it is asked. Nearest to it comes the mode {mode} "
        "(values: {values}); what stands in the way there is told apart.",
        "Read on there; the summary has all attempts, with the stretches that can't be followed.",
    ),
    "workspace.section-drives": (
        "Paths and figures in the workspace need two drives; this mechanism has {count}.",
        "Take the section out, or give the mechanism another drive.",
    ),
    "workspace.not-positive": (
        "{key}: {text} isn't positive.",
        "Give a positive value.",
    ),
    "workspace.fit-kind": (
        "A figure is one of circle, rectangle and largest; given are: {given}.",
        "Write for example circle: 10 mm, rectangle: [20 mm, 10 mm] or largest: circle.",
    ),
    "workspace.fit-none": (
        "{name} fits into no region. In the best one (mode {mode}; values: {values}) {share} % of its area lie outside, up to {by}; there "
        "it would fit at {scale} of its size.",
        "Make it smaller, move it, or change the mechanism; largest: circle says what there is room for.",
    ),
    "workspace.path-short": (
        "The wanted path has {given} distinct points; its curve wants {wanted} or more.",
        "Give more points, or take straight pieces (between: linear).",
    ),
    "workspace.path-unit": (
        "The column '{column}' of the wanted path is no length.",
        "Write its unit in brackets, as in 'x [mm]'.",
    ),
    "workspace.path-drawing": (
        "The drawing {file} holds {count} curves where the wanted path is one.",
        "Join them into one polyline, or name the layer that holds only the path.",
    ),
    "drawing.unreadable": (
        "The drawing {file} can't be read as DXF: {reason}.",
        "Save it again as DXF from the program that made it.",
    ),
    "drawing.code": (
        "The drawing {file} has '{given}' ({place}) where the number of a group belongs.",
        "Save it again as DXF from the program that made it.",
    ),
    "drawing.number": (
        "The drawing {file} has '{given}' in a group {code} ({place}), where a finite number below 1e40 belongs.",
        "Correct the number, or draw the curve again; save the drawing again as DXF.",
    ),
    "drawing.entity": (
        "The {kind} with the handle {handle} in the drawing {file} makes no path: {reason}.",
        "Draw it again, best as one polyline near the origin.",
    ),
    "workspace.path-name": (
        "'{name}' can't stand in the formula of a wanted path.",
        "Write x and y in u, which runs from 0 to 1, with parameters and functions.",
    ),
    "workspace.path-value": (
        "The formula of the wanted path has no value at u = {u:.6g}.",
        "Look for a division by zero or a root of something negative.",
    ),
    "workspace.path-rests": (
        "The formula of the wanted path stands still at u = {u:.6g}, where the motor can't.",
        "Write x and y so that they go on evenly with u, or give the path in time.",
    ),
    "workspace.path-corner": (
        "The wanted path has {count} corners, the first at u = {u:.6g}: there the speed of the drives jumps.",
        "Round the corners, or let the curve pass through the points (between: cubic).",
    ),
    "workspace.path-outside": (
        "{point} can't reach the wanted path from u = {start} to {stop}: it runs up to {by} outside the region.",
        "Move or shrink the path, or choose another assembly mode; the largest circle and rectangle say what has room.",
    ),
    "workspace.path-singular": (
        "From u = {start} to {stop} the wanted path can't be followed: a singular curve is met, on which {point} can't move in one direction (the determinant of d(x, y)/d(drives) is zero).",
        "Keep the path away from the singular curves, which the pictures show, or begin it elsewhere.",
    ),
    "workspace.path-modes": (
        "From u = {start} to {stop} the wanted path can't be followed: two assembly modes meet, where the drives don't hold the mechanism (the determinant of a closure is zero).",
        "Keep the path away from the edge of this assembly mode, or choose another one.",
    ),
    "workspace.path-limit": (
        "From u = {start} to {stop} the wanted path can't be followed: {drive} is at the end of its range.",
        "Widen the range of {drive}, or move the path.",
    ),
    "workspace.path-turns": (
        "From u = {start} to {stop} the wanted path can't be followed at constant speed: {drive} would have to turn back.",
        "End the path there, or give it in time, so that both drives follow it.",
    ),
    "workspace.path-dead": (
        "Along the wanted path {count} dead positions are passed, the first at {time:.6g} s: there {point} moves in one direction only, "
        "and errors of the path go into the drives by their square root.",
        "Take care that the drives follow their laws; on a path off the singular curves, where there is one, {point} is held better.",
    ),
    "workspace.servo-reverses": (
        "Along the wanted path {servo} turns back {count} times, the first time at {time:.6g} s, though never_reverse forbids it.",
        "Choose another path, another speed of the motor, or another start; or allow it.",
    ),
    # Many parameter sets of one mechanism.
    "varied.slides": (
        "The directions of the slides {loop} agree for the given value of {name} alone: for any other one their loop "
        "can't be put together.",
        "Write both lines of each slide with {name}, or don't vary it.",
    ),
    "varied.passage": (
        "The motion goes on through a change point (through: keep), which another value of {names} would move.",
        "Vary the parameters of a motion without change points.",
    ),
    "varied.table": (
        "The arguments or the period of the table {table} hold expressions of {names}, which vary.",
        "Write these numbers out, or don't vary what they depend on; the table's values may vary.",
    ),
    "varied.second": (
        "{names} vary in the law {law}, by whose largest lift the second contact of the cam {cam} is placed.",
        "Give the place of the second contact under second, or don't vary the law.",
    ),
    "varied.values": (
        "{count} of {samples} samples have values that the model can't take; in the first one, {sample}: {what}",
        "Narrow the ranges of the varied parameters, or let what must fit them follow as an expression of them.",
    ),
    "varied.drive": (
        "In {count} of {samples} samples the law of {drive} has no finite value; in the first one, {sample}, at "
        "t = {time} s.",
        "Narrow the ranges of the parameters in its position, or change the law.",
    ),
    "varied.cannot-assemble": (
        "{count} of {samples} samples can't be put together; the first one, {sample}, at t = {time} s: there {joints} of "
        "{links} come {distance} {unit} apart, {by} {unit} {way} than the links can span ({limit} {unit}).",
        "Narrow the ranges of the varied lengths, or count on the samples that are left.",
    ),
    "varied.stuck": (
        "{count} of {samples} samples can't be followed; in the first one, {sample}, the group {group} can't be followed "
        "to t = {time} s: on the way from the nominal pose it reaches a singular one.",
        "Narrow the ranges of the varied parameters, or count on the samples that are left.",
    ),
    "accuracy.position": (
        "'{text}' is no position.",
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
        "Deviations of {names} can't have the correlation {stated}: their distributions aren't alike, and with these it goes "
        "as far as {limit}.",
        "State a smaller correlation, or the same distribution for both.",
    ),
    "accuracy.correlation-mended": (
        "No normal scores give these distributions the stated correlations, all at once; the samples have some that are near: "
        "those of the scores differ by {change} at most.",
        "State smaller correlations, or normal distributions.",
    ),
    "accuracy.samples-fail": (
        "{count} of {samples} random samples inside the tolerances lack a value of some output, {share} % (of all that "
        "might be made {low} to {high} %, with 95 % confidence). Each output's figures are those of the samples that have it.",
        "Narrow the tolerances, or change the dimensions so that the mechanism can be assembled with all of them.",
    ),
    "accuracy.points-fail": (
        "{count} of {samples} samples inside the tolerances lack a value of some output, {share} %. Each output's figures "
        "are those of the samples that have it.",
        "Narrow the tolerances, or change the dimensions so that the mechanism can be assembled with all of them. Take the "
        "plan random or latin for a confidence interval of the share.",
    ),
    "accuracy.law": (
        "With a deviation of {names} alone the motion law {law} no longer adds up to its period, closes, or runs on.",
        "Let others of its numbers follow: {{dwell: 360 deg - w}} beside {{rise: h, over: w}}, the same h to fall.",
    ),
    "accuracy.table": (
        "With a deviation of {names} alone the table {table} no longer closes over its period.",
        "Give its first and its last value the same expression.",
    ),
    "accuracy.vertices-fail": (
        "The search for the worst case met {lost} of {looked} places inside the tolerances at which the mechanism can't be "
        "assembled or followed: there is no worst case, only one of those that work.",
        "Narrow the tolerances, or change the dimensions so that the mechanism can be assembled with all of them.",
    ),
    # Of sweeps.
    "study.needs-cycle": (
        "The study {study} looks at the motion of the file's cycle, and there is none.",
        "Add one beside it, for example cycle: {{turns: 1 motor, samples: 360}}.",
    ),
    "study.one-value": (
        "There is nothing to vary: {count} value(s).",
        "Give two values or more; a parameter that stays as it is needn't be named.",
    ),
    "study.sigma": (
        "The standard deviation {sigma} isn't positive.",
        "Give a positive one, in the parameter's unit.",
    ),
    "study.cut-distribution": (
        "The distribution is cut to a range that holds less than {share:g} of it.",
        "Widen the range from low to high, or move the mean.",
    ),
    "study.triangle": (
        "Low, most likely and high value of a triangular distribution don't follow each other: {values}.",
        "Give them in this order; the most likely value may be one of the ends.",
    ),
    "study.plan": (
        "{name} has a distribution, of which the plan {plan} knows no points.",
        "Give it steps or a list, or take another plan: latin, sobol, random.",
    ),
    "study.grid-samples": (
        "The plan {plan} has as many samples as there are combinations.",
        "Leave samples out, or take another plan: latin, sobol, random.",
    ),
    "study.too-many-samples": (
        "There are {count} samples; the plan {plan} has at most {limit}.",
        "Take fewer values or samples; of distributions the plan random has the most.",
    ),
    "study.no-output": (
        "'{text}' is neither a measure of this file nor an expression of signals.",
        "{near} An output is a measure, a signal such as E.x, or an expression of signals.",
    ),
    "study.no-outputs": (
        "The sweep has nothing to find out: the file has no measures.",
        "Add measures, or name signals under outputs.",
    ),
    "study.varied-span": (
        "The length of the run depends on {name}, which isn't the same in all samples.",
        "State the length by itself, for example cycle: {{duration: 1.5 s}}, or don't vary that parameter.",
    ),
    "study.no-folder": (
        "More than {limit} values would have to be kept in memory.",
        "Name a folder to write them to, with --out or out=...; or take keep: reduced.",
    ),
    "study.no-value": (
        "In {count} of {samples} samples a measure or signal has no finite value, though their motion can be followed; the "
        "first one is sample {sample}.",
        "Look for a singular pose, a cam that locks its follower, a division by zero or a window that isn't reached; or "
        "narrow the ranges.",
    ),
    "study.alone": (
        "The study {study} is about a structure that nothing moves; {name} needs a motion.",
        "Put {name} into a file of its own, with a drive.",
    ),
    "reactions.drives": (
        "The mechanism is driven by {names}; the study reactions is for structures that nothing drives.",
        "Write studies: {{cycle: ...}} for the forces of a motion, or remove the drives.",
    ),
    "reactions.time": (
        "The time '{text}' isn't a number from 0 on.",
        "Write a time, for example at: 0.5 s.",
    ),
    "reactions.several-poses": (
        "The links can be put together in {count} ways or more, and nothing says which.",
        "Give the places of the points in sketch, or a side under assembly.",
    ),
    "reactions.not-closed": (
        "The joints of the structure can't all close: at the best pose found they miss by {miss} {unit}.",
        "Correct the lengths, or give the places of the points in sketch.",
    ),
    "reactions.phased": (
        "The links can only be put together all at once, where what {name} ({kind}) keeps from the drawn pose isn't known.",
        "Give the places of the points in sketch or under assembly, so that the links are placed one after the other.",
    ),
    "reactions.not-finite": (
        "What acts on {links} has no finite value.",
        "Look for a table asked outside its range, or a division by zero; the option at says when loads are taken.",
    ),
    "reactions.moves": (
        "The structure doesn't stand: its joints leave a motion on which the loads do work. It would move {links}.",
        "Add a support or a bar that holds these links, or correct the dimensions.",
    ),
    "reactions.indeterminate": (
        "The structure is statically indeterminate to degree {degree}: reactions of {joints} depend on the stiffness of "
        "its parts and have no value here.",
        "Nothing needs to be changed. For all reactions, release supports (let one end slide) until nothing is held twice.",
    ),
    "reactions.neutral": (
        "The joints leave motions ({motions}) on which the loads do no work: the structure stands by chance.",
        "Add a support or a bar if it is to stand under other loads too.",
    ),
    "reactions.no-load": (
        "Nothing acts on the structure, so all its reactions are zero.",
        "Add loads, springs, or gravity with masses.",
    ),
    "reactions.unproven": (
        "Verification failed: the joints or the equilibrium miss by {residual} of the size or of the largest force (limit "
        "1e-9).",
        "Look for links that are nearly in line, so that small errors of lengths make large forces.",
    ),
    "reactions.measures": (
        "The study reactions evaluates no measures: {names}.",
        "Read the reactions from its table, or remove the measures.",
    ),
    "study.none": (
        "The file asks for no study.",
        "Add one, for example studies: {{cycle: {{period: 1.5 s, samples: 200}}}}.",
    ),
    # Of exports.
    "export.which": (
        "Nothing says which tool the mechanism is exported for.",
        "Add --to and one of these: {known}.",
    ),
    "export.unknown": (
        "There is no export to '{name}'.",
        "{near}",
    ),
    "export.missing": (
        "The file doesn't say how it is exported to {name}. Its exports: {has}.",
        "Add it to the file, for example 'exports: {{{name}: {example}}}'.",
    ),
    "export.options": (
        "The option {key} of the export to {export} is wrong: {reason}.",
        "Correct it; docs/file-format.md lists the options of each target.",
    ),
    "export.choice": (
        "The option {key} of the export to {study} can't be {given}.",
        "{near}",
    ),
    "export.handle": (
        "The handle {name} is a point of the frame: it doesn't move.",
        "Name a point of the panel, where a hand opens it.",
    ),
    "export.outline": (
        "These points make no outline: {reason}.",
        "List three points or more of the panel, in order around it, each once.",
    ),
    "export.setting": (
        "'{given}' isn't an option and its value.",
        "Write KEY=VALUE, the value as in a model file: --set decimals=12.",
    ),
    "export.no-mass": (
        "MuJoCo wants a mass for every moving body: {links} got {mass}, with a radius of gyration of {radius}.",
        "Give them masses in the model, or another tiny_mass.",
    ),
    "export.no-inertia": (
        "MuJoCo wants a moment of inertia for every moving body: {links} got that of a radius of gyration of {radius}.",
        "Give them one in the model where it matters.",
    ),
    "export.no-duration": (
        "Nothing says how long the motion lasts.",
        "Give duration under exports.{export}, or a cycle under studies.",
    ),
    "export.too-many-pieces": (
        "The law of {drive} has more than {limit} pieces in this time; it isn't written as text.",
        "Take its values from motion.csv, or give a shorter duration.",
    ),
    "export.no-formula": (
        "The law of {drive} has no formula; it isn't written as text.",
        "Take its values from motion.csv.",
    ),
    "joint.winds": (
        "The kind of this joint, {kind}, asks for the angle of a link of which only the direction is known.",
        "Its package has to state winds = True in the kind, so that angles are followed over whole turns.",
    ),
    "joint.follower-output": (
        "{motor} can't be followed: its law is that of its output {output}.",
        "Name another drive as the motor, or give {motor} a law of its own.",
    ),
    "joint.follower-law": (
        "The law {law} isn't over the {over} of the motor with the {of} of the follower as its value: it has {given}.",
        "Write over: {over} and of: {of} in the law, or name another one.",
    ),
    "export.unproven": (
        "What would be written for {name} is off the model by {error} {unit}; it isn't given.",
        "Look for a law or pose that is nearly singular; else tell the authors, since this is a fault of linkwright.",
    ),
    "export.left-out": (
        "The file for MuJoCo doesn't have {names}.",
        "Add them to the file by hand where the simulation needs them.",
    ),
    "export.followers": (
        "MuJoCo has no cam pairs: the followers of {names} have actuators of their own, which move them by the laws; the "
        "camshafts' actuators don't feel them.",
        "Take their controls from positions.csv; take forces and torques on cams from linkwright.",
    ),
    # Of batches.
    "batch.head": (
        "The column '{head}' can't be read.",
        "Write the name of a parameter and its unit in brackets, for example x1 [mm].",
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
        "The file {file} has no rows below its heads.",
        "Add one for each mechanism; 'linkwright new hinge --table' writes a file to start from.",
    ),
    "batch.cells": (
        "The row has {count} cells, and there are {heads} columns.",
        "Remove the cells that are too many; a comma inside a cell needs quotes around the cell.",
    ),
    "batch.name": (
        "The name '{name}' can't begin the names of files.",
        "Write letters, digits, spaces, dots, hyphens and underscores, 60 at most, with a letter or digit first.",
    ),
    "batch.name-twice": (
        "The name '{name}' stands in line {first} already.",
        "Give each row a name of its own; small and capital letters count as the same.",
    ),
    "batch.model": (
        "There is no model '{name}', neither in the gallery nor as a file beside this one.",
        "{near} Or write the path of a model file.",
    ),
    # Of joint functions.
    "functions.drives": (
        "Joint functions ask for one driving joint; this mechanism has {count} drives: {names}.",
        "Leave one drive, and fix the links of the others to each other.",
    ),
    "functions.left-out": (
        "The joint {joint} is left out, but it is the one that {drive} drives.",
        "Take it out of left_out.",
    ),
    "functions.master-left-out": (
        "The joint {joint} is left out, but it is the master: all functions ask for it.",
        "Remove it from left_out, or name another master.",
    ),
    "functions.master-cam": (
        "The joint {joint} can't be the master: functions of cams ask for the camshaft's joint ({drives} follow cams).",
        "Remove master; then the joint that the camshaft turns on is the driving one.",
    ),
    "functions.master-still": (
        "The joint {joint} can't be the master: it stands still over the range.",
        "Name a joint that moves. These go one way over the whole range: {others}.",
    ),
    "functions.master-zero": (
        "The joint {joint} can't be the master: it has a dead centre at {drive} = {at} {unit}, where it turns back, and "
        "the zero pose lies there.",
        "Set zero to a value of {drive} well away from it, or name another master. These go one way over the whole range: "
        "{others}.",
    ),
    "functions.master-turns": (
        "The joint {joint} can't be the master over this range: it has a dead centre at {drive} = {at} {unit}, where it "
        "turns back, so that its value belongs to two poses.",
        "Take range within [{low} {unit}, {high} {unit}], or name another master. These go one way over the whole range: "
        "{others}.",
    ),
    "functions.master-cut": (
        "The master {joint} has a dead centre at {drive} = {at} {unit}, where it turns back. The functions hold from {low} "
        "to {high} {unit} of {drive} only.",
        "Set range within these values to state that this is enough, or name another master. These go one way over all "
        "that {drive} reaches: {others}.",
    ),
    "functions.master-stops": (
        "The master {joint} doesn't reach both stops without a dead centre.",
        "Take stops within [{low} {unit}, {high} {unit}], its range around the zero pose.",
    ),
    "functions.master-structure": (
        "The joint {joint} can't be the master: driven instead of {drive}, it leaves the mechanism loose or over-constrained.",
        "Name a joint of a loop that {drive} moves.",
    ),
    "functions.no-dependent": (
        "No joint depends on {drive}: there is nothing to write a function for.",
        "Close a loop, take a joint out of left_out, or leave the export out; a joint that is driven alone needs no function.",
    ),
    "export.too-long": (
        "The angles of {joints} can't be followed continuously over {duration} s.",
        "Give {name} a shorter duration; a few turns of the slowest drive are enough.",
    ),
    "export.joint": (
        "{name} has no joint like {joint} ({kind}).",
        "Don't export this mechanism there, or replace the joint by links, pins and slides.",
    ),
    "export.cannot-close-slides": (
        "{name} can't write a loop of slides alone, which {joints} would close: its loops are closed by pins.",
        "Pin one of the links to a sliding block of its own, or don't export this mechanism.",
    ),
    "functions.wedge": (
        "{links} lies in a loop of slides (on {slides}), for which no joint functions are written.",
        "Write the functions by hand: the travels of such a loop are proportional to each other.",
    ),
    "functions.shared-pin": (
        "The drive {drive} moves two links against each other on the pin {pin}, which holds others that are placed before "
        "them; the tool's joints lead from the first link of a pin to each other one.",
        "Drive one of the links against the first one of the pin, or give the drive a pin of its own.",
    ),
    "functions.too-many": (
        "There would be {count} joints, helping ones included; the tool's functions know {limit} at most.",
        "Name joints that close loops under left_out, allow longer texts, or export a part of the mechanism.",
    ),
    "functions.name": (
        "The joint {joint} can't be called '{name}' in the tool.",
        "Give it a name of at most 60 letters A to Z, digits and underscores, no digit first, under names; what else the "
        "tool takes isn't known.",
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
        "Both range and stops say how far the driving joint goes.",
        "Keep one: range in values of the drive, or stops in values of the joint since the zero pose.",
    ),
    "functions.no-range": (
        "The mechanism can't be moved from {drive} = {start} {unit}.",
        "Start the drive where the mechanism isn't at a dead centre; `limits` tells its ranges.",
    ),
    "functions.toggle": (
        "From {from} to {to} {unit} of {of} the mechanism meets a toggle (group {groups}): there its two assembly modes "
        "meet, and one function can't follow both.",
        "Take {key} within [{low} {unit}, {high} {unit}], the largest range around the start pose.",
    ),
    "functions.zero": (
        "Between the start and the zero pose, {drive} = {zero} {unit}, the mechanism meets a toggle (group {groups}): one "
        "function can't follow both of its assembly modes.",
        "Take zero within [{low} {unit}, {high} {unit}]; or start the drive on the side where the zero pose is.",
    ),
    "functions.still": (
        "These joints stand still over the whole range: {joints}.",
        "If they shouldn't: see whether two pivots stand in one place, or whether the range is too small.",
    ),
    "functions.sweep": (
        "A direction turns by {spread} deg over the range, seen from any link (joints {joints}); a function in the dialect "
        "{dialect} holds {most} deg.",
        "Take a narrower range; what is too far for the arccosine of the dialect seed may do for atan2 in wizard.",
    ),
    "functions.error": (
        "However many decimals are taken, a function is off by {error} (rad or mm) at {drive} = {at} {unit}.",
        "Take a range that stays further away from poses in which links are in line or pins meet.",
    ),
    "functions.length": (
        "No splitting brings all functions under {longest} characters; the least possible is {least}.",
        "Set longest to {least} or more.",
    ),
    "functions.no-closed-form": (
        "The links {links} can only be placed all together (group {group}): their joints have no function in closed form.",
        "Set approximate to take polynomials in the value of {drive}; over this range those of degree {degree} come within "
        "{error} (rad or mm), so approximate: {approximate} is enough. A narrower range makes them better.",
    ),
    # Of workspaces.
    "workspace.drives": (
        "A workspace needs two drives (or one: then it is a curve); this mechanism has {count}: {names}.",
        "Fix links to each other until two drives are left, or give the mechanism another drive.",
    ),
    "workspace.cluster": (
        "The workspace study knows mechanisms of dyads only; this one has a group that is solved by Newton's method: {groups}.",
        "Take a mechanism whose groups are pairs of links; the limits study moves one drive of this one.",
    ),
    "workspace.fixed-point": (
        "The working point {name} lies on the frame, so that it doesn't move.",
        "{near} The working point belongs to a moving link.",
    ),
    "workspace.no-values": (
        "There are no values of {name}.",
        "Give at least one, for example [0, 60, 90]; or leave the parameter out.",
    ),
    "workspace.no-range": (
        "The drive {drive} slides, and nothing says how far.",
        "Give its range, for example drives: {{{drive}: [0 {unit}, 100 {unit}]}}; or a cylinder's length.",
    ),
    "workspace.too-many": (
        "These would be {count} regions; at most {limit} are computed.",
        "Take fewer values, or modes: own.",
    ),
    "workspace.unbounded": (
        "The point {name} can run away: two guides are parallel near {at}, so that its region has no end.",
        "Give the drives ranges in which the guides cross at an angle.",
    ),
    "workspace.pins-meet": (
        "The outer pins of a group meet at {at}, an end of a range or one of a whole curve of such values; its links may "
        "point anywhere there, and the region falls apart.",
        "Give the drives ranges that keep clear of such values; or make the group's links unequal by a little.",
    ),
    "workspace.incomplete": (
        "The region of the mode {mode} isn't whole: {share} % of the places sampled at random lie outside of it.",
        "Take another chord, or a part of the drives' ranges; trust its area as a lower bound only.",
    ),
    "workspace.doubt-area": (
        "The area of the mode {mode} isn't certified: as drawn it is {size} beyond the bounds that enclosures of all its "
        "poses prove.",
        "Take a smaller chord, or a part of the drives' ranges. Don't trust the picture near {at}.",
    ),
    "workspace.doubt-open": (
        "The area of the mode {mode} isn't certified: {size} of it is left open, more than a hundredth, most of it near "
        "{at}.",
        "The region is very thin there, or its edges almost touch. Trust the bounds of its area, not its figures beyond "
        "them.",
    ),
    "workspace.doubt-left-out": (
        "The region of the mode {mode} isn't certified: {size} that are reached for sure lie outside of it, some near "
        "{at}.",
        "Take another chord, or a part of the drives' ranges; trust the bounds of its area only.",
    ),
    "workspace.doubt-too-much": (
        "The region of the mode {mode} isn't certified: {size} of it can't be reached for sure, some near {at}.",
        "Take another chord, or a part of the drives' ranges; trust the bounds of its area only.",
    ),
    "workspace.doubt-edge": (
        "The edge of the mode {mode} isn't certified: it runs through places that are decided, at {size} of its corners; "
        "one is at {at}.",
        "Take another chord, or a part of the drives' ranges; trust the bounds of its area only.",
    ),
    "workspace.doubt-count": (
        "The picture of the mode {mode} isn't certified: over {size} of its curves, some near {at}, the number of poses "
        "doesn't change as it must.",
        "A curve may be missing there, or be false: the area and its bounds don't depend on it, pictures and the guaranteed "
        "part may. Take another chord, or a part of the drives' ranges.",
    ),
    "workspace.doubt-back": (
        "The region of the mode {mode} isn't certified: {size} of the places tried don't come back from their drive "
        "values, one at {at}.",
        "This is a fault of linkwright. Please report it with the file.",
    ),
    "workspace.doubt-unsettled": (
        "The region of the mode {mode} isn't certified: its area still changed by {size} when the mesh was last doubled.",
        "Take a part of the drives' ranges, so that the mesh is finer there.",
    ),
    "workspace.doubt-cut": (
        "The region of the mode {mode} isn't certified: {size} of its curves lie between parts of one face, near {at}.",
        "A curve may be missing there. Take another chord, or a part of the drives' ranges.",
    ),
    "workspace.doubt-dangle": (
        "The region of the mode {mode} isn't certified: {size} of its curves end where no other begins, near {at}.",
        "A curve may be missing there. Take another chord, or a part of the drives' ranges.",
    ),
    "workspace.doubt-ring": (
        "The region of the mode {mode} isn't certified: {size} of its curves cross themselves, near {at}.",
        "Take another chord, or a part of the drives' ranges.",
    ),
    "workspace.doubt-rough": (
        "The region of the mode {mode} isn't certified, nor drawn: {size} pieces of its curves can't be followed, one near "
        "{at}.",
        "Two joints of a group may meet there in many positions, so that its links may point anywhere. Change a length by "
        "little, or take a part of the drives' ranges.",
    ),
    "workspace.doubt-nowhere": (
        "The region of the mode {mode} isn't certified: {size} pieces of its curves have no place, near {at}.",
        "Take another chord, or a part of the drives' ranges.",
    ),
    "workspace.stopped": (
        "Interrupted with {done} of {total} regions done. These are kept; what else was asked of them may be missing.",
        "Run the study again. In the same results folder it resumes: regions that are done aren't computed again.",
    ),
    "workspace.part-damaged": (
        "The file {file} held a region of an interrupted study, but is damaged or can't be read. The region was computed "
        "again.",
        "There is nothing to do. If it happens again, check the disk.",
    ),
    "workspace.no-area": (
        "The point {name} moves along curves only, or not at all, so that it has no region{values}.",
        "Take a point that both drives move; or widen the drives' ranges.",
    ),
    "workspace.never-closes": (
        "The links never close{values}: {links} fail nearest to closing at {at}, where {joints} are {distance} {unit} "
        "apart, {by} {unit} {way} than the links can span ({limit} {unit}).",
        "Make the links {direction}, by {by} {unit} at least; or widen the drives' ranges.",
    ),
    # Of workspaces: maps.
    "workspace.two-drives": (
        "{section} needs two drives; with one, the point moves along a curve.",
        "Take {section} out, or give the mechanism another drive.",
    ),
    "workspace.map-name": (
        "There is no map of the name '{name}' here.",
        "Take one of these: {known}.",
    ),
    "workspace.map-task": (
        "The map '{name}' isn't there without {key}.",
        "Add {key}, or take another map.",
    ),
    "workspace.limit-missing": (
        "Under {key} there is nothing for {drives}.",
        "Give one for each of the two drives.",
    ),
    "workspace.limit-positive": (
        "{what} isn't positive: {given}.",
        "Give a positive value, or leave it out.",
    ),
    # Of workspaces: trajectories.
    "workspace.hold-steps": (
        "Trajectories have either a number of steps or a step size; both are given.",
        "Write steps, for example steps: 36, or every, for example every: 10 deg.",
    ),
    "workspace.hold-many": (
        "The range of {drive} has {count} such steps; at most {limit} trajectories are computed.",
        "Write a larger step under every.",
    ),
    # Of clearances.
    "clearance.cam": (
        "A clearance at {name} moves the contacts of the cam {cam}, which touches on two sides (closed: {closed}): "
        "which of them holds the follower isn't followed.",
        "Leave this joint out; state the play as a tolerance of the centre distance instead.",
    ),
    "clearance.no-joint": (
        "{name} is no joint, so it has no clearance.",
        "{near} A pin made by a revolute joint has the name of that joint.",
    ),
    "clearance.one-link": (
        "{name} is a point of {link} alone, so there is no joint that could have a clearance.",
        "Give another link a point of that name, or take the clearance out.",
    ),
    "clearance.not-positive": (
        "The length {text} isn't positive.",
        "Give a positive length; a joint without clearance needn't be named.",
    ),
    "clearance.indeterminate": (
        "The clearance of {name} needs its moment, which isn't determined: the slides {loop} hold each other's direction.",
        "Remove this clearance, or pin one of the links to a sliding block.",
    ),
    "clearance.no-length": (
        "The guide {name} has no length, which decides whether its slider tilts.",
        "Give it beside the clearance, for example length: 60.",
    ),
    "clearance.centre": (
        "{name} is no point of {links}, the two links of this guide.",
        "Name the point of one of them that is in the middle of the length over which the guide bears.",
    ),
    "clearance.short-guide": (
        "The clearance of {name} is half of its length or more: the slider isn't guided.",
        "Check both numbers and their units.",
    ),
    "clearance.no-key": (
        "The clearance of {name} ({kind}) has no {key}.",
        "Take {key} out.",
    ),
    "clearance.no-play": (
        "A clearance of {name} can't be evaluated: joints of this kind ({kind}) don't state their points of contact.",
        "Remove it, or state the clearance as the tolerance of a dimension.",
    ),
    "clearance.not-on-pin": (
        "{link} isn't on the pin {name}, so the pin can't be fixed in it.",
        "Name one of the links on it: {links}.",
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
        "The joint {name} of {links} transmits no force in the whole run, so it isn't known where it rests: its clearance "
        "counts in the bound alone.",
        "Give masses, loads or springs that press the joint, or read the bound.",
    ),
    "clearance.undetermined": (
        "The reaction in the joint {name} of {links} has no finite value somewhere in the run: its clearance counts in "
        "the bound alone.",
        "Look for a singular pose, or for a load without a value there.",
    ),
    "clearance.no-figure": (
        "No effect of the clearances is stated on {names}: {why}.",
        "Ask for a position, an angle or a length, and of it for max, min, extremes, span, value, mean or rms.",
    ),
    # Tolerances.
    "tolerance.unknown-class": (
        "'{given}' is neither a class of tolerances nor a parameter of this file.",
        "Write a number, [lower, upper], or a class such as {known}.",
    ),
    "tolerance.class-or-parameter": (
        "{name} is a class of tolerances and a parameter of this file.",
        "Rename the parameter; or write ({name}) where the parameter is meant.",
    ),
    "tolerance.distribution": (
        "'{given}' is no distribution of a tolerance.",
        "Write one of: {known}.",
    ),
    "tolerance.cp-and-sigma": (
        "Both cp and sigma are given, and each says how wide the distribution is.",
        "Keep one of them.",
    ),
    "tolerance.no-sigma": (
        "A {name} distribution has its width from the limits alone; cp and sigma say nothing of it.",
        "Take them out, or write distribution: normal or truncated.",
    ),
    "tolerance.cp": (
        "The capability cp = {cp} isn't positive.",
        "Give a positive number; 1 means that six standard deviations fill the limits.",
    ),
    "tolerance.limits": (
        "The limits {given} hold no tolerance: the lower one must lie below the upper one.",
        "Give a positive number for plus and minus, or [lower, upper]; of a fixed deviation change the value itself.",
    ),
    "tolerance.too-large": (
        "The tolerance reaches {limit} {unit}, as far as the dimension itself ({nominal} {unit}) or farther.",
        "Correct the tolerance or its unit. A coordinate that may be zero is stated as zero.",
    ),
    "tolerance.derived": (
        "{name} follows from other parameters ({text}), so it can't have a tolerance of its own.",
        "Give the tolerance to the parameters that it follows from; or add one to it, as {name}_error: 0.",
    ),
    "tolerance.size": (
        "{given} has no tolerance for {asked} {unit}: it is stated over {low} to {high} {unit}.",
        "Take another class, or state the limits.",
    ),
    "tolerance.side": (
        "{given} tells the tolerance of an angle by the length of its shorter side, which isn't stated.",
        "State it beside the limits, for example side: 60 mm; or state the limits as numbers.",
    ),
    "tolerance.class-dimension": (
        "{given} has tolerances of lengths only (a general class of angles too), and {name} isn't one.",
        "State the limits as a number or [lower, upper].",
    ),
    "tolerance.missing": (
        "{name} is to deviate, but states no tolerance, and there is no general one for it.",
        "Give it a tolerance under parameters; or write general: ISO 2768-m, which is for lengths and for angles with a side.",
    ),
    "tolerance.named-twice": (
        "{name} is named twice.",
        "Name each parameter once.",
    ),
    "tolerance.none": (
        "Nothing deviates: no parameter has a tolerance, and there is no change of temperature.",
        "Name dimensions under parameters and give them a tolerance, for example AB: {{value: 155, tolerance: 0.05}}; or "
        "write general: ISO 2768-m.",
    ),
    "tolerance.skipped": (
        "{general} has no tolerance for the size of {names}, so these are taken as exact.",
        "Give them tolerances of their own where they deviate.",
    ),
    "tolerance.no-derivative": (
        "{text} has no derivative at the nominal dimensions, so no deviation can be carried through it.",
        "Write it in another way, or give this parameter's value as a number.",
    ),
    "tolerance.no-contributor": (
        "Nothing that deviates is called {name}.",
        "{near} A parameter with a tolerance or a change of temperature can stand here.",
    ),
    "tolerance.correlation-twice": (
        "{name} stands twice in one correlation.",
        "Name each deviation once; that it goes together with itself needs no saying.",
    ),
    "tolerance.correlation-pair": (
        "The correlation of {names} is stated already, in an entry before this one.",
        "State each pair once.",
    ),
    "tolerance.correlation-shape": (
        "Of {count} names the matrix of correlations has {count} rows of {count} numbers.",
        "Give all of them, the diagonal too; or one number for all pairs.",
    ),
    "tolerance.correlation-range": (
        "The correlation coefficient {value} lies outside -1 to 1.",
        "Give one within.",
    ),
    "tolerance.correlation-diagonal": (
        "The diagonal of the matrix of correlations isn't 1 throughout.",
        "Write 1 there: each deviation goes together with itself.",
    ),
    "tolerance.correlation-symmetry": (
        "The matrix of correlations isn't symmetric.",
        "Give the same coefficient for a pair in both of its places.",
    ),
    "tolerance.correlation-indefinite": (
        "No deviations go together like this: the matrix of correlations has the eigenvalue {least}, and none may be "
        "negative.",
        "Correct the coefficients: if two deviations each follow a third closely, they follow one another too. Pairs that "
        "aren't stated count as 0.",
    ),
    "tolerance.material-or-expansion": (
        "A change of temperature says either the material or its expansion.",
        "Write material: steel; or expansion: 11.5, in 1e-6/K.",
    ),
    "tolerance.material": (
        "The expansion of '{given}' isn't known.",
        "{near} Otherwise write expansion: and the coefficient in 1e-6/K.",
    ),
    "tolerance.thermal-name": (
        "A parameter has the name of this change of temperature.",
        "Call one of the two otherwise.",
    ),
    "tolerance.no-length": (
        "Nothing expands: the file has no parameter that is a length and isn't derived.",
        "Give lengths names under parameters.",
    ),
    "tolerance.not-a-length": (
        "{name} isn't a length, so it doesn't expand.",
        "Name lengths only.",
    ),
    # Of accuracy: tolerances from what is wanted, dimensions from what is measured.
    "accuracy.cost": (
        "The cost law {law} can't have these numbers: {given}.",
        "Give finite ones: the first of several may be 0, all others are positive; costs in a table may be 0.",
    ),
    "accuracy.no-contributor": (
        "{name} is no deviation of this study: its tolerance can't be allotted, nor its deviation estimated.",
        "{near} Otherwise give the parameter a tolerance, or general, and name it under parameters.",
    ),
    "accuracy.no-target": (
        "'{name}' is no figure of this study.",
        "{near} An output of a signal at a position is 'E.x at POSITION'.",
    ),
    "accuracy.target": (
        "The wanted half-width {text} isn't positive, or is too large.",
        "Give how far the output may be off to either side, for example 0.5.",
    ),
    "accuracy.half-widths": (
        "The half-widths of a tolerance don't rise from a positive one: {low}, {high}.",
        "Give between: [least, largest], in the parameter's unit.",
    ),
    "accuracy.no-grade": (
        "ISO 286 has no half-width of {grades} for {name}: it has grades of lengths up to 3150 mm.",
        "Give a table of half-widths in {unit}: table: [[half-width, cost], ...]; or grades: false.",
    ),
    "accuracy.no-grade-between": (
        "No standard grade of {name} lies between {low} and {high} {unit}.",
        "Widen between, or give grades: false.",
    ),
    "accuracy.target-unreachable": (
        "{name} can't be held within {wanted} {unit}: the least tolerances that may be allotted leave {best} {unit}.",
        "Allow smaller half-widths (between), give more parameters a cost law, or tighten those without one.",
    ),
    "accuracy.targets-loose": (
        "All targets are kept by the largest tolerances that may be allotted, so that they decide nothing.",
        "Set narrower targets, or allow larger half-widths (between).",
    ),
    "accuracy.no-choice": (
        "No choice of standard grades or processes keeps the targets that continuous half-widths do.",
        "Allow finer ones: widen between, or add processes to the tables.",
    ),
    "accuracy.not-optimal": (
        "The cheapest tolerances weren't found: they are off the conditions of the optimum by {off} of the cost.",
        "Narrow the half-widths (between), or bring costs and targets to usual sizes.",
    ),
    "accuracy.measured-source": (
        "Measurements come either from a file or from points.",
        "Give file: measured.csv, or points: [{{t: 0.1 s, E.x: 712.3}}, ...].",
    ),
    "accuracy.no-place": (
        "No column says where the outputs were measured; there are: {given}.",
        "Add one of these, or name it with at: {known}.",
    ),
    "accuracy.measured-unit": (
        "The unit {unit} doesn't fit {name}.",
        "Write one such as {usual}.",
    ),
    "accuracy.measured-number": (
        "In row {row} of the measurements, {name} isn't a number.",
        "Write a number with a decimal point; only a cell of an output may be left empty.",
    ),
    "accuracy.nothing-measured": (
        "There are no measured outputs.",
        "Add a column for each output, and a row for each position.",
    ),
    "accuracy.empty-column": (
        "The column {name} has no values.",
        "Write numbers, or leave the column out.",
    ),
    "accuracy.no-pose": (
        "Row {row} was measured at {name} = {value} {unit}, where the run never is.",
        "Correct the row, or let studies.cycle cover it.",
    ),
    "accuracy.several-poses": (
        "Row {row} was measured at a value that {name} has several times, in different poses: at {times}.",
        "Give the time t of each row instead, or let studies.cycle cover one way only.",
    ),
    "accuracy.sigma": (
        "The standard deviation {sigma} of measurements isn't positive.",
        "Give a positive one, in the output's unit, or leave it out: it is then estimated from the residuals.",
    ),
    "accuracy.not-measured": (
        "{name} isn't measured; there are: {known}.",
        "Write sigma for a measured output.",
    ),
    "accuracy.few-measurements": (
        "There are {count} measurements for {parameters} deviations; at least {least} are needed.",
        "Measure at more positions, name fewer under parameters, state sigma, or take prior: true.",
    ),
    "accuracy.sigma-open": (
        "The measurements of {name} don't suffice to estimate their standard deviation too.",
        "State it under sigma, or measure at more positions.",
    ),
    "accuracy.measured-without-value": (
        "An output has no finite value or derivative at a measured position of the nominal motion.",
        "Leave the rows near dead centres and other singular poses out.",
    ),
    "accuracy.scale-open": (
        "The measurements don't tell the size of the mechanism: {names} may all be larger or smaller in proportion.",
        "Measure a length too, or leave one of them out of parameters; only their ratios are estimated.",
    ),
    "accuracy.not-told-apart": (
        "The measurements don't tell {names} apart: deviations of these can cancel in every measured output.",
        "Measure another output or at other positions, or leave one of them out of parameters.",
    ),
    "accuracy.no-effect": (
        "{name} changes no measured output, or far too little to be told.",
        "Measure another output or at other positions, or leave it out of parameters.",
    ),
    "accuracy.poor-fit": (
        "The residuals are larger than the stated sigmas explain: chi square is {ratio} times its degrees of freedom, which "
        "happens by chance with probability {share}.",
        "Look for outliers, for a deviation that isn't among the parameters, or state larger sigmas.",
    ),
    "accuracy.outliers": (
        "{count} measurement(s) lie farther off than random errors do; rows {rows}.",
        "Check these rows, and leave them out where they are wrong.",
    ),
    "accuracy.not-settled": (
        "The estimate doesn't stand still: another step would move it by {step} of the tolerances' sigmas.",
        "Measure at more positions, or name fewer deviations under parameters.",
    ),
    # Structure.
    "structure.drive-no-joint": (
        "{link} and {on} share no {joint} joint, so the drive can't act between them.",
        "Name two links that meet at a pin (turns) or on a line (slides).",
    ),
    "structure.drive-two-joints": (
        "{link} and {on} meet at several joints ({joints}), so the drive can't tell which to move.",
        "Leave one joint between the two links.",
    ),
    "structure.drive-too-many": (
        "{link} and {on} are held already, by their joints or other drives; this drive would fight them.",
        "Take the drive out, or a joint.",
    ),
    "structure.output-apart": (
        "The motion of {output} doesn't reach {link} and {on}, so a drive between them can't move it.",
        "Let the drive act on links that are joined to the output, or name another output.",
    ),
    "structure.loose": (
        "These links aren't held: {links} (free motions: {freedom}).",
        "Join them to links that are held, check the spelling of shared points, or add a drive. {hint}",
    ),
    "structure.loose-many": (
        "{count} links aren't held (free motions: {freedom}); nearest to what is held are {links}.",
        "Join them to links that are held, check the spelling of shared points, or add a drive. {hint}",
    ),
    "structure.unpinned": (
        "The points {point} of {link} and {other} of {on} have like names, but each lies on one link only, so that they "
        "aren't a pin; and these links aren't held: {links} (free motions: {freedom}).",
        "Give both points one name if they are one pin; else join the links to others that are held, or add a drive.",
    ),
    "structure.unpinned-joint": (
        "The point {point} of {link} lies on no other link, though its name is like that of the joint {other}; and these "
        "links aren't held: {links} (free motions: {freedom}).",
        "Call it {other} if it is on that pin; else join the links to others that are held, or add a drive.",
    ),
    "structure.overconstrained": (
        "These links are held too much: {links} (constraints too many: {excess}).",
        "Take out a joint or a drive, or add the link that is missing between two pins.",
    ),
    "structure.redundant-movable": (
        "{part} is redundant: with these dimensions the mechanism moves all the same (rank {rank} of {constraints} "
        "constraints, Gruebler's count {gruebler}, mobility {mobility}). But how it shares the forces is undetermined.",
        "Leave {part} out of the model: the motion stays the same. The forces that it takes over depend on play and "
        "stiffness.",
    ),
    "structure.nearly-redundant": (
        "{part} could move along as a redundant part, but its joints miss by {miss} {unit} on the way.",
        "Correct its dimensions, or leave it out of the model.",
    ),
    "structure.moments-indeterminate": (
        "The slides {joints} hold each other's direction: their forces are determined, but not how they share moments. "
        "Their moments and arms aren't reported.",
        "Nothing needs to be changed. For the moments, pin one of the links to a sliding block instead of guiding it.",
    ),
    "structure.loop-of-slides": (
        "The links {links} can't be placed one after the other: they lie in loops of slides alone, which linkwright "
        "solves one link at a time.",
        "Drive another link, or replace one slide by a pin and a sliding block.",
    ),
    "structure.redundant": (
        "The joint {joint} between {links} holds what other joints hold already, so its forces are undetermined.",
        "Take this joint out, or the link that doubles another.",
    ),
    # Assembly and motion.
    "assembly.slides-parallel": (
        "The slides {joints} of {link} are parallel, so that nothing places it along them.",
        "Correct the angles in line, or drive {link}.",
    ),
    "assembly.missing": (
        "{links} can be put together in two ways, and nothing says which.",
        "Add to assembly: {options}. Or give the point's place in a sketch: [x, y].",
    ),
    "assembly.contradiction": (
        "These rules ask for both ways of putting one pair of links together: {rules}.",
        "Keep one of them.",
    ),
    "assembly.unused": (
        "The rule for {point} says nothing about a pair of links that can be put together in two ways.",
        "Take it out, or name the pin in the middle of such a pair.",
    ),
    "assembly.wrong-pins": (
        "The rule for {point} doesn't name the joints by which its pair of links hangs.",
        "Write {options}.",
    ),
    "assembly.not-four-bar": (
        "'open' and 'crossed' are words for a four-bar, and {point} isn't the pin of one.",
        "Write {options}.",
    ),
    "assembly.ambiguous": (
        "At the start the rule for {point} fits both ways of putting the links together equally well.",
        "Write {options}. Or start elsewhere.",
    ),
    "assembly.cannot-close": (
        "{links} can't be put together at the start: {joints} are {distance} {unit} apart, "
        "{by} {unit} {way} than the links can span ({limit} {unit}).",
        "Make the links {direction}, by {by} {unit} at least; or start elsewhere.",
    ),
    "assembly.degenerate": (
        "{links} have no definite pose at the start: their joints {joints} coincide, or their lines are parallel.",
        "Correct the points and lines of these links; or start elsewhere.",
    ),
    "assembly.no-sketch": (
        "{links} can only be put together all at once, in one of several assembly modes, and the file doesn't say which.",
        "Run 'linkwright modes FILE': it lists the modes, each with the lines to copy. Or give the places of the pins {pins} "
        "in a pose near the start, under assembly: '{first}: [x, y]' and so on.",
    ),
    "assembly.not-found": (
        "No way was found to put {links} together at the start near the places sketched under assembly.",
        "Check the lengths, and sketch the pins as they stand at the start of the motion.",
    ),
    "assembly.no-mode": (
        "The links can't be put together in any way at this pose of the drives.",
        "Check the lengths, or look at another pose: another start of the drive, or studies.modes.at.",
    ),
    "motion.stuck": (
        "At t = {time} s ({drive} = {value} {unit}) the group {group} reaches a singular pose of its own; it can't be "
        "followed further.",
        "Change the lengths, or keep the motion away from that pose.",
    ),
    "motion.cannot-assemble": (
        "{links} can't be put together between {drive} = {from} and {to} {unit}: {joints} come {distance} {length_unit} "
        "apart, {by} {length_unit} {way} than the links can span ({limit} {length_unit}).",
        "Make the links {direction}, by {by} {length_unit} at least; or keep {drive} out of that range.",
    ),
    "motion.out-of-reach": (
        "{drive} can't follow its law from t = {time} to {until} s: it goes to {worst} {unit} there, but the links bring "
        "it no farther than {from} {unit} (and {to} {unit} at the end of that time). {joints} would come {distance} "
        "{length_unit} apart, {by} {length_unit} {way} than {links} can span ({limit} {length_unit}).",
        "Keep the law of {drive} within that; or make the links {direction}, by {by} {length_unit} at least.",
    ),
    "motion.dead-centre": (
        "At t = {time} s ({drive} = {value} {unit}) {motors} stands at a dead centre against {drive}: it doesn't move "
        "while {drive} does, so that no effort of it moves or holds {drive} there.",
        "Keep the law of {drive} on one side of {value} {unit}, or let the drive act at another joint.",
    ),
    "motion.singular": (
        "At t = {time} s ({drive} = {value} {unit}) the motion passes a change point or dead centre of {group} "
        "(determinant {determinant}): the links can go on in two ways there, and rates and forces have no meaning.",
        "Write through: keep in studies: cycle where the motion is meant to go on smoothly (a parallelogram stays "
        "one). Else hold the links by a third crank or a drive, change the lengths, or keep the motion away from there.",
    ),
    "motion.cannot-carry": (
        "At t = {time} s ({drive} = {value} {unit}) {group} is in a singular pose through which the motion can't be "
        "carried: the poses around don't tell its limit.",
        "Let the drives move smoothly through that pose, without a rest or a jump of the acceleration, and the loads act "
        "so, without an end of a window or a corner of a table there; or keep away from it by other lengths or another "
        "range of the drives.",
    ),
    "motion.starts-at-change-point": (
        "The motion starts at a change point of {group} (t = {time} s, {drive} = {value} {unit}), where its two modes "
        "are one. The rule '{rules}' is taken for the side on which it goes on.",
        "Check in the drawing that it is the motion that is meant, or start elsewhere.",
    ),
    "motion.unbounded-forces": (
        "At the change point of {group} at t = {time} s ({drive} = {value} {unit}) forces grow without bound, since "
        "no link can turn another there: {signals}. They have no value at that instant.",
        "Take up the load elsewhere: a third crank, a flywheel or gears carry a parallelogram through its change point.",
    ),
    "motion.near-change-point": (
        "At t = {time} s ({drive} = {value} {unit}) {group} passes a change point closely (determinant "
        "{determinant}): a small error of a length or a play decides there on which side the links go on.",
        "Make the lengths meet exactly where a parallelogram or the like is meant (and write through: keep), or keep "
        "farther away.",
    ),
    "motion.unproven": (
        "The results don't hold: {check} misses by {figure} of its size, where round-off leaves 1e-9 at most.",
        "Look for dimensions of very different size, a point far away, or a pose all but singular; the report's "
        "certificate tells more. If there is none, please report the model as a fault of linkwright.",
    ),
    "motion.not-periodic": (
        "The motion isn't closed: after {period} the point {element} is {distance} {unit} from where it began.",
        "Correct the period, or give duration instead of period.",
    ),
}

# Phrases inside the texts above.
_TERMS: dict[str, str] = {
    # What is wanted where something else is given.
    "expression": "a number or an expression",
    "plain": "a number, a text, true, false, a list or a mapping",
    "mapping": "a mapping (key: value)",
    "list": "a list",
    "text": "a text (numbers in quotes)",
    "name": "a name (letters, digits, underscores)",
    "other": "another kind of value",
    "outline-few": "it takes three different points at least, each once",
    "outline-crossed": "the lines between them cross, or they lie in a line",
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
    "slot-places": "a list of places [ALONG, ACROSS]",
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
    "frame-none": "Name the link that doesn't move 'frame', here and wherever it is used.",
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
    "none": "none",
    "given-mapping": "a mapping",
    "given-list": "a list of {count}",
    # Why an entity of a drawing makes no path.
    "drawn-line": "line {at}",
    "drawn-group": "group {at} from its beginning",
    "drawn-inconsistent": "what it holds doesn't fit together",
    "drawn-radius": "its radius isn't positive",
    "drawn-axis": "its major axis has no length",
    "drawn-ratio": "the ratio of its axes isn't between 0 and 1",
    "drawn-degree": "its degree is too small or too large",
    "drawn-knots": "its knots don't ascend",
    "drawn-weights": "its weights aren't positive",
    "drawn-large": "its places aren't finite",
    "drawn-far": "it lies farther from the origin than {limit} times its size",
    "drawn-long": "it has more than {limit} points",
    # What is wrong with the length of a run.
    "one-length": "give one of period, duration, turns",
    "length-positive": "it must be positive",
    "length-limit": "the run would last {seconds} s, and {limit} s is the longest; give fewer turns, a shorter time or a faster drive",
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
    "power": "the balance of power",
    "work": "the balance of work and energy",
    "measures": "the check of the measures",
    "unknown-share": "an unknown share",
    "shorter": "shorter",
    "longer": "longer",
    "a-drive": "a drive",
    "a-contributor": "a contributor (a parameter with a tolerance, a change of temperature)",
    "drive-limit": "The limit of {drive} under {under}",
    "limit-error": "The limit of the error",
    "size-of-force": "The size of the force",
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
    # Why a clearance has no effect to state.
    "play-no-position": "that holds rates or forces, of which the play isn't known",
    "play-reduction": "that looks at many places at once, or at rates",
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
    "syntax-open": "a bracket is closed that wasn't opened",
    "syntax-close": "a closing bracket is missing before '{before}'",
    "syntax-close-end": "a closing bracket is missing at the end",
    "syntax-value": "a value is missing before '{before}'",
    "syntax-value-end": "a value is missing at the end",
    "syntax-attribute": "a name is missing after the point",
    "syntax-unit": "'{word}' isn't a unit",
    "syntax-unit-power": "the power of a unit is one digit, 1 to 9",
    "syntax-place": "{name} can't stand here",
    # What is written otherwise than in a file, and what is meant.
    "respelled-wide": "it has full-width characters",
    "respelled-signs": "it has characters that expressions don't take",
    "respelled-stray": "it has characters that belong to no expression",
    "respelled-comma": "numbers have a decimal point, not a comma",
    "respelled-speed": "rotational speeds are written in rpm or r/s",
    "respelled-unit": "units are written by their short names",
    "respelled-dot": "a point is missing between an element and its signal",
    "respelled-sense": "the sense of rotation is the sign, counter-clockwise being positive",
    "respelled-factor": "a * is missing between factors",
    "respelled-tolerance": "a tolerance is written apart from the value, without a sign",
    "write-tolerance": "Write '{{value: {value}, tolerance: {text}}}'.",
    # Why YAML gives up.
    "yaml-colon": "a colon stands in a value without quotes, or the line above lacks one",
    "yaml-no-colon": "a name stands here without a colon and a value",
    "yaml-indentation": "this line is indented, or begins with '-', unlike those above it",
    "yaml-bracket": "a bracket isn't closed, or a comma is missing",
    "yaml-quote": "a quote isn't closed",
    "write-bound": "Write '>= {text}' or '<= {text}'.",
    "write-name": "Use letters of any script, digits and underscores, for example {text}.",
    "name-form": "Use letters of any script, digits and underscores (at most {limit}), and no digit first; a point of a link is "
    "named without the link.",
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
