"""Problems of friction."""

PROBLEMS: dict[str, tuple[str, str]] = {
    "friction.place": (
        "It isn't clear where the friction is.",
        "Give exactly one of pin (the name of a pin), slide (the name of a prismatic joint) and contact (that of a cam or of a "
        "pin in a slot).",
    ),
    "friction.stray": (
        "These keys aren't allowed in friction of this kind: {keys}.",
        "Remove them: a pin has radius and, if needed, in; a slide has length; a contact has radius if it has a roller.",
    ),
    "friction.law": (
        "The friction has no law.",
        "Add coefficient for Coulomb friction, viscous, or both.",
    ),
    "friction.size": (
        "A coefficient of friction needs the {key} of the joint.",
        "Add radius (where the pin rubs in its bearing), or length (of the slide's guide).",
    ),
    "friction.pin-links": (
        "More than two links share the pin {pin}: {links}. It isn't clear which of them rubs on which.",
        "Add in: [LINK, LINK WITH THE PIN], one friction for each link that rotates on the pin.",
    ),
    "friction.not-on-pin": (
        "A link given under in isn't on the pin {pin}.",
        "The links on this pin are {links}.",
    ),
    "friction.same-link": (
        "Both links of the friction are {name}, so it has no effect.",
        "Name two different links.",
    ),
    "friction.loop": (
        "The slide {joint} is in a loop of slides, whose moments statics doesn't determine, so its friction can't depend on the "
        "length of a guide.",
        "Remove length: the slide then rubs by its normal force alone, as wedges do.",
    ),
    "friction.twice": (
        "The friction of {joint} is given by {other} already.",
        "Remove one of both, or combine them: one entry can have a coefficient, a static coefficient and viscous "
        "friction.",
    ),
    "friction.second-contact": (
        "Friction in the contact of {name} can't be computed, because its follower has contact on two sides.",
        "Remove this friction, or give the follower one contact. Pins, slides and other contacts may have friction.",
    ),
    "friction.roller": (
        "The contact {name} has a roller, which rubs at its pin, so the friction needs the radius of that pin.",
        "Add radius, that of the roller's pin.",
    ),
    "friction.no-roller": (
        "The contact {name} has no roller, so its friction has no radius.",
        "Remove radius.",
    ),
    "friction.gives": (
        "At t = {time} s ({drive} = {value} {unit}) the coefficient of friction is negative: the friction would drive.",
        "Write it as a function of the magnitude of the speed, such as abs(NAME.omega), that stays above zero.",
    ),
    "friction.still": (
        "Friction in a structure without a drive isn't determined: nothing moves.",
        "Remove it, or add the drive that moves the mechanism.",
    ),
    "friction.unsolved": (
        "At t = {time} s ({drive} = {value} {unit}) the friction forces couldn't be computed to full accuracy: the "
        "mechanism is close to jamming, or its joints influence each other too much.",
        "Reduce the coefficients or radii, use a longer guide, or avoid this part of the motion.",
    ),
    "friction.jams": (
        "At t = {time} s ({drive} = {value} {unit}) the mechanism jams: at {share} of the friction coefficients the "
        "friction has grown beyond any effort of the drives.",
        "Reduce the coefficients or radii, use a longer guide, or avoid this part of the motion.",
    ),
    "friction.jams-meeting": (
        "At t = {time} s ({drive} = {value} {unit}) the mechanism jams: at {share} of the friction coefficients two possible "
        "equilibria meet, and beyond there is none in which it moves as prescribed.",
        "Reduce the coefficients or radii, use a longer guide, or avoid this part of the motion.",
    ),
    "friction.several": (
        "From t = {time} s ({drive} = {value} {unit}) on, in {share} % of the motion, the friction forces aren't unique: other "
        "forces, such as those of a wedged mechanism, obey the same laws. Reported are those to which friction grows from zero.",
        "Reduce the coefficients or radii, or use a longer guide, if the mechanism might wedge.",
    ),
    "friction.static": (
        "A static coefficient alone isn't enough: it only says when motion starts, not how joints rub in motion.",
        "Add coefficient, the one of motion, e.g. 'coefficient: 0.1, static: 0.15'.",
    ),
    "friction.static-less": (
        "The static coefficient {static} is smaller than the coefficient of motion {coefficient}.",
        "Exchange the two: joints resist more at standstill than in motion.",
    ),
    "friction.cannot-start": (
        "At t = {time} s ({drive} = {value} {unit}) no effort of {name} starts the mechanism from standstill towards {sense} values: "
        "with the static coefficients it jams there.",
        "Don't stop there, or reduce the static coefficients, the radii of pins, or the offset of forces from the guides.",
    ),
    "friction.rests": (
        "At standstill the mechanism stays where it is with {name} released from t = {start} s to t = {stop} s ({drive} = {low} to "
        "{high} {unit}), although the loads would move it without friction. Such intervals: {count}, together {share} % of the "
        "run.",
        "No change is needed if it is to hold without a brake; otherwise use a brake, or smaller static coefficients.",
    ),
    "friction.self-locking": (
        "The mechanism is self-locking from t = {start} s to t = {stop} s ({drive} = {low} to {high} {unit}): the loads would "
        "drive it against {name}, but friction holds it, so that {name} has to push. Such intervals: {count}, together "
        "{share} % of the run.",
        "No change is needed if it is to hold without a brake; otherwise reduce the coefficients or radii.",
    ),
}
