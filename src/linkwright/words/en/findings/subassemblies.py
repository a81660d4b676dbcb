"""Problems of sub-assemblies and their copies."""

PROBLEMS: dict[str, tuple[str, str]] = {
    "subassembly.unused": (
        "No copy of the sub-assembly {name} is placed, so nothing of it is checked or computed.",
        "Place one under copies: {{{name}_1: {{of: {name}}}}}; or remove the sub-assembly.",
    ),
    "subassembly.circular": (
        "The sub-assembly {name} contains itself: {circle}.",
        "Remove one of these copies.",
    ),
    "subassembly.sketch": (
        "The sketch of the sub-assembly {name} has three coordinates.",
        "Write positions in the plane of the mechanism, [x, y]. A sketch in the vehicle's coordinates belongs to the "
        "whole file.",
    ),
    "subassembly.port-twice": (
        "The port {name} is listed twice.",
        "List each port once.",
    ),
    "subassembly.port-own": (
        "{name} is a port, but the sub-assembly defines an element of that name itself.",
        "Rename one of the two. A port is a point, a link or another element that each copy is given under join.",
    ),
    "subassembly.port-unused": (
        "Nothing in the sub-assembly uses the port {name}.",
        "Use it as a point of a link or as a name of an element, or remove it from ports.",
    ),
    "subassembly.port-given": (
        "The point {point} of the link {link} is a port, so its position is that of the point to which a copy is joined.",
        "Remove the point here, or remove it from ports, so that each copy has its own.",
    ),
    "subassembly.mass": (
        "The link {name} isn't the sub-assembly's own: a copy only adds points to it.",
        "State the mass where the link is defined, or add a counterweight on it.",
    ),
    "subassembly.no-port": (
        "'{name}' isn't a port of the sub-assembly {of}.",
        "{near} Otherwise add it to the ports of the sub-assembly.",
    ),
    "subassembly.unjoined": (
        "The copy isn't joined at all ports of the sub-assembly {of}. Missing: {ports}.",
        "Name what each one is in the mechanism. Example: join: {{{example}: NAME}}",
    ),
    "subassembly.no-parameter": (
        "The sub-assembly {of} has no parameter called '{name}'.",
        "{near} Otherwise declare it under the parameters of the sub-assembly.",
    ),
    "subassembly.tolerance": (
        "The parameter {name} has a tolerance in the sub-assembly, but its value here depends on other parameters, whose "
        "deviations it would follow as well.",
        "If only these deviate, write {{value: {value}, tolerance: none}}. For a deviation of its own, write a number in "
        "place of the expression.",
    ),
    "subassembly.mirrored": (
        "The copy can't be mirrored: for '{name}' in the section {section} of the sub-assembly {of}, it isn't defined what "
        "its mirror image is.",
        "Only elements that act on links of the sub-assembly and on the frame can be mirrored, and whose expressions "
        "depend only on their motion; torsional springs with a table can't. Define the element outside the sub-assembly, "
        "or write a second sub-assembly.",
    ),
    "subassembly.same-point": (
        "Two ports of the link {link} are joined to the same point ({points}).",
        "Join each port of a link to a point of its own.",
    ),
    "subassembly.taken": (
        "The copy would add {name} to {section}, which is there already.",
        "Rename the copy or the other element.",
    ),
    "subassembly.long-name": (
        "With the name of the copy in front, {name} is longer than {limit} characters.",
        "Use a shorter name for the copy or for the element.",
    ),
    "subassembly.deep": (
        "Copies of sub-assemblies are nested more than {limit} levels deep.",
        "Write the inner levels as links and joints of one sub-assembly.",
    ),
    "subassembly.too-many": (
        "With this copy there would be {count} entries in {section}; at most {limit} are possible.",
        "Place fewer copies, or split the model.",
    ),
}
