"""Problems of clearances."""

PROBLEMS: dict[str, tuple[str, str]] = {
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
}
