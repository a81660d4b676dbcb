"""Problems of gears, racks, belts and rolling."""

PROBLEMS: dict[str, tuple[str, str]] = {
    "joint.carrier": (
        "The carrier '{carrier}' isn't pinned to {wheel} at {centre}, so nothing keeps the centre distance.",
        "Name the link that is pinned to both wheels at their centres, for example 'carrier: arm'; without carrier it is "
        "the frame. Links that are: {able}.",
    ),
    "differential.count": (
        "The differential has {shafts} shafts, but {weights} weights.",
        "Give one weight for each shaft in the order of differential, e.g. "
        "'{{differential: [cage, left, right], weights: [2, -1, -1]}}'.",
    ),
    "differential.weight": (
        "The weight of the shaft {link} is 0, so that the differential doesn't move it.",
        "Give a number other than 0, or remove the shaft. Planetary gear sets have [z_sun, z_ring, -(z_sun + z_ring)] for "
        "sun, ring and arm.",
    ),
    "gears.size": (
        "Gears need either teeth or pitch radii; given: {given}.",
        "For example teeth: [20, 40] for the two gears in the order of gears (with module, if it is known), or "
        "radii: [30, 60].",
    ),
    "gears.module": (
        "A module is given, but no numbers of teeth.",
        "Write teeth: [20, 40] instead of radii, or remove module.",
    ),
    "gears.internal": (
        "The internal gear (ring) '{name}' isn't one of the two gears {gears}.",
        "Write the link of the ring: for example gears: [planet, ring], internal: ring.",
    ),
    "gears.ring": (
        "The ring {ring} isn't larger than the gear inside it.",
        "Give the ring more teeth, or the larger radius, in the order of gears: gears: [planet, ring], teeth: [20, 80]. For "
        "external gears remove internal.",
    ),
    "gears.whole": (
        "A number of teeth isn't a whole number.",
        "Write whole numbers, for example teeth: [20, 40]; a ratio of any value is given by radii.",
    ),
    "gears.pressure": (
        "The pressure angle isn't between 0 and 90 deg.",
        "Write the pressure angle of the teeth, mostly 20 deg; without module 0 deg for wheels without a separating force.",
    ),
    "gears.concentric": (
        "The centres of both gears are at the same place of {carrier}.",
        "Give the carrier two points at the centre distance of the gears. For wheels on one shaft, put both on one link.",
    ),
    "gears.distance": (
        "The gears don't fit: their pitch radii give a centre distance of {radii}, but on {carrier} it is {distance}.",
        "Change radii or the points of {carrier}; or give teeth instead, so that the pitch radii follow from the distance.",
    ),
    "gears.shift": (
        "The gears don't fit: with this module their centre distance is {reference}, but on {carrier} it is {distance}.",
        "Change module, teeth, or the points of {carrier}. Profile shift may change the distance by at most one module, "
        "and the working pressure angle must exist: distance > reference distance times cos(pressure angle).",
    ),
    "gears.pinion": (
        "A rack needs either the pitch radius of its pinion, or teeth and module; given: {given}.",
        "For example radius: 25 mm, or teeth: 20 with module: 2.5 mm.",
    ),
    "gears.guide": (
        "The carrier '{carrier}' doesn't keep the distance of {pinion} and {rack}: it must be pinned to the pinion at its centre, "
        "and the rack must slide on it.",
        "Name the link with both joints, for example 'carrier: housing'; without carrier it is the frame. Links that have both: "
        "{able}.",
    ),
    "gears.rack-line": (
        "The line of the rack {rack} isn't parallel to the guide in which the rack slides.",
        "Give the line the direction of the prismatic joint's line on that link.",
    ),
    "gears.path": (
        "A disc rolls on exactly one of on_line and on_circle; given: {given}.",
        "For example on_line: G at 0 deg, or on_circle: {{centre: M, radius: 80}}, with inside: true for a disc in a ring.",
    ),
    "gears.same-radius": (
        "The disc fills the circle inside which it is to roll.",
        "Give the circle another radius than the disc; without inside the disc rolls on the outside of the circle.",
    ),
    "gears.rack-distance": (
        "The rack doesn't fit: its line is {distance} from the pinion's centre, but the pitch radius is {radius}.",
        "Change the radius (teeth, module), or the points of the line, of the guide and of the centre. With a module, profile "
        "shift may change the distance by at most one module.",
    ),
    "belt.size": (
        "A belt needs either the pitch radii of both wheels, or their teeth and the pitch; given: {given}.",
        "For example radii: [30, 60], or for a toothed belt or a chain teeth: [20, 40] with pitch: 5 mm.",
    ),
    "belt.friction": (
        "A coefficient of friction is given, but no pretension.",
        "Add pretension, the force of each strand at standstill, for example 200 N; or remove friction.",
    ),
    "belt.distance": (
        "The wheels overlap: their centre distance is {distance}, the sum of their radii {radii}.",
        "Change radii (teeth, pitch) or the carrier's points at the centres.",
    ),
    "belt.slack": (
        "A strand of {joint} ({kind}) becomes slack: it would have to push with {force} {of} at t = {time} s ({drive} = {value} "
        "{unit}). From there on the forces aren't those of a belt.",
        "Increase pretension; of a chain or toothed belt whose loose strand hangs, remove pretension.",
    ),
    "belt.slips": (
        "The belt {joint} ({kind}) slips: it lacks {force} {of} of tangential force at t = {time} s ({drive} = {value} {unit}), "
        "by Eytelwein's limit of both strands.",
        "Increase pretension, or the angle of wrap, or use a belt with more friction.",
    ),
    "geneva.motor": (
        "No drive turns the driver '{driver}' of this Geneva drive against '{carrier}', so the wheel has no law.",
        "Give the driver a drive of its own, for example 'drives: {{motor: {{turns: {driver}, on: {carrier}, speed: 60 rpm, start: "
        "0 deg}}}}'; a drive whose law is that of an output doesn't count.",
    ),
    "geneva.frame": (
        "The frame is driver or wheel of this Geneva drive, and it can't be the link that carries both too.",
        "Name the link that is pinned to driver and wheel at their centres, for example 'carrier: arm'.",
    ),
    "geneva.slots": (
        "The number of slots isn't a whole number from {fewest} to {most}.",
        "For example slots: 4, or 6 for a smaller peak acceleration.",
    ),
    "geneva.concentric": (
        "The centres of driver and wheel are at the same place of {carrier}.",
        "Give {carrier} two points at the centre distance of the Geneva drive.",
    ),
    "geneva.entry": (
        "The pin {pin} would enter its slot with a shock: it is {radius} from {centre}, but for a centre distance of {distance} "
        "and these slots it must be {wanted}.",
        "Give the pin the radius sin(180 deg/slots) times the centre distance, for example by a parameter 'r: c*sin(180 deg/4)'.",
    ),
    "geneva.pins": (
        "The pins {first} and {second} would be in slots at the same time.",
        "Place pins at least 180 deg - 360 deg/slots apart: for example two pins opposite each other; or remove one.",
    ),
    "geneva.arc": (
        "The locking arc doesn't fit: its radius is {radius}, but it must be larger than {low} to reach the wheel's rim, and "
        "smaller than {high} to leave the pin room.",
        "Give arc a radius between the two, mostly that of the pin's circle less the pin's diameter.",
    ),
    "geneva.horn": (
        "The locking disc of {joint} is cut out where it would have to hold the wheel: at t = {time} s the force of {force} is stated at "
        "a horn of the wheel's arc that the disc doesn't reach there, but its edge bears, with a larger force.",
        "Within {span} of the driver before a pin enters and after it leaves, the disc holds the wheel in one direction only. "
        "Balance the wheel or brake it, so that no moment acts there in the other direction; the stated forces have the arm "
        "{arm}, which is right elsewhere.",
    ),
}
