"""Problems of joint functions."""

PROBLEMS: dict[str, tuple[str, str]] = {
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
        "The joint {joint} can't be the master: it has a limit position at {drive} = {at} {unit}, where it reverses, "
        "and the zero pose is there.",
        "Set zero to a value of {drive} well away from it, or name another master. These move in one direction over "
        "the whole range: {others}.",
    ),
    "functions.master-turns": (
        "The joint {joint} can't be the master over this range: it has a limit position at {drive} = {at} {unit}, where "
        "it reverses, so that each of its values belongs to two poses.",
        "Set range within [{low} {unit}, {high} {unit}], or name another master. These move in one direction over "
        "the whole range: {others}.",
    ),
    "functions.master-cut": (
        "The master {joint} has a limit position at {drive} = {at} {unit}, where it reverses. The functions are valid "
        "only from {low} to {high} {unit} of {drive}.",
        "Set range within these values to confirm that this is enough, or name another master. These move in one "
        "direction over the whole range of {drive}: {others}.",
    ),
    "functions.master-stops": (
        "The master {joint} has a limit position between the two stops.",
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
}
