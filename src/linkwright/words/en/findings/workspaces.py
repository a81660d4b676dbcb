"""Problems of workspaces, their maps and trajectories."""

PROBLEMS: dict[str, tuple[str, str]] = {
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
    "workspace.hold-steps": (
        "Trajectories need either a number of steps or a step size; both are given.",
        "Write steps, for example steps: 36, or every, for example every: 10 deg.",
    ),
    "workspace.hold-many": (
        "The range of {drive} has {count} such steps; at most {limit} trajectories are computed.",
        "Give a larger step under every.",
    ),
}
