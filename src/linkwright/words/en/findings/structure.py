"""Problems of the structure of a mechanism."""

PROBLEMS: dict[str, tuple[str, str]] = {
    "structure.drive-no-joint": (
        "{link} and {on} share no {joint}, so the drive can't act between them.",
        "Name two links that meet on a line (slides), or prescribe the position of a point along a line, e.g. "
        "'{{moves: {link}, at: P, on: {on}, along: O at 0 deg, ...}}'.",
    ),
    "structure.drive-angle-fixed": (
        "The angle of {link} relative to {on} is already determined by prismatic joints or other drives.",
        "Remove the drive, or let it move another link.",
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
    "structure.redundant-joints": (
        "The mechanism is redundant: constraints of {joints} follow from those of the other joints (rank {rank} of "
        "{constraints} constraints, Gruebler's formula {gruebler}, mobility {mobility}). With exactly these dimensions "
        "it moves all the same; the motion and the drive efforts don't depend on {joints}. {reactions}",
        "No change is needed. In the real mechanism, deviations of the dimensions must be taken up by clearance or "
        "elasticity.",
    ),
    "structure.redundant-study": (
        "{name} can't be computed for a redundant mechanism: constraints of {joints} follow from those of the other "
        "joints.",
        "Remove {joints} from a copy of the model: the motion and the drive efforts stay the same.",
    ),
    "structure.nearly-redundant": (
        "{joint} could be a redundant joint, but with these dimensions its closure error reaches {miss} {unit}: the "
        "mechanism binds unless clearance and elasticity there take up at least that much.",
        "Correct the dimensions so that the joint closes in every position, or remove it from the model.",
    ),
    "stiffness.value": (
        "The stiffness isn't clear: exactly one of value and equal is needed.",
        "Write one of these: 50 kN/mm, or equal.",
    ),
    "stiffness.mixed": (
        "The stiffness of {name} is 'equal', but that of others is a number: how they compare isn't known.",
        "Give every stiffness as a number, or all of them as equal.",
    ),
    "stiffness.link": (
        "{link} can't have a stiffness: only a link with exactly two joints, both pins, has one, along the line of these.",
        "Remove this stiffness, or give one to the joints of {link}.",
    ),
    "stiffness.loaded": (
        "{link} can't have a stiffness, since {name} acts on it: how much it deforms depends on where.",
        "Let {name} act on another link of the same pin, or give a stiffness to the joints of {link}.",
    ),
    "stiffness.tilt": (
        "{name} isn't a slide, so it has no stiffness in tilting.",
        "Remove tilt.",
    ),
    "stiffness.no-effect": (
        "The mechanism isn't redundant: its reactions don't depend on stiffness.",
        "Remove stiffness if no redundant joint is missing in the model.",
    ),
    "stiffness.separating": (
        "How {joints} share the load can't be computed from stiffness: teeth also push their gears apart, by a share of "
        "the size of the tooth force.",
        "Remove stiffness: motion, drive efforts and all determined reactions are computed without it.",
    ),
    "stiffness.not-enough": (
        "The stiffness given doesn't determine how redundant joints share the load. Still undetermined: {joints}.",
        "Give the stiffness of these joints too, and that of slides in tilting, or write stiffness: equal.",
    ),
    "stiffness.undetermined": (
        "{signal} isn't determined by statics, since the mechanism is redundant: redundant joints share the load "
        "according to their stiffness.",
        "Give the stiffness of the joints (stiffness: equal assumes that all are equally stiff), or use a sum that is "
        "determined: the warning on the redundant joints lists some.",
    ),
    "stiffness.friction": (
        "The friction of {name} depends on a reaction of {joint} that statics doesn't determine, since the mechanism "
        "is redundant.",
        "Give the stiffness of the joints (stiffness: equal assumes that all are equally stiff), or remove this "
        "friction.",
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
}
