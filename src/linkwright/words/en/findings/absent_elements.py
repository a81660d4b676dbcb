"""Texts for elements that model files don't have, or that have another name."""

PROBLEMS: dict[str, tuple[str, str]] = {
    "element.belt": (
        "'{name}': linkwright has no belts and chains yet.",
        "A belt turns two links in the ratio of their radii. If one is driven, couple the other to it under joints: 'belt: "
        "{{coupling: [pulley2, frame], follows: motor.angle*r1/r2}}'. The torque of the coupling is what the belt "
        "transmits; the forces of its strands aren't computed.",
    ),
    "element.clearance": (
        "'{name}': the joints of a model have no clearance.",
        "Give clearances in the accuracy study, for example 'studies: {{accuracy: {{clearances: {{B: 0.02 mm}}, "
        "outputs: [...]}}}}'; see docs/how-to/clearances.md.",
    ),
    "element.contact": (
        "'{name}': linkwright has no contacts and stops yet.",
        "The contact of a cam is written under cams. Limit a slide with 'travel' and a cylinder with 'length'; for "
        "any other range, use a measure with a requirement.",
    ),
    "element.damper": (
        "'{name}': dampers are written under springs.",
        "For example 'springs: {{damper: {{from: A, to: B, damping: 200 N*s/m}}}}'.",
    ),
    "element.friction": (
        "'{name}': friction of pins and slides is written under friction.",
        "For example 'friction: {{bearing_A: {{pin: A, radius: 10 mm, coefficient: 0.1}}, rail: {{slide: guide, length: "
        "60 mm, coefficient: 0.12}}}}'. linkwright has no friction of cams and pins in slots yet.",
    ),
    "element.gear": (
        "'{name}': linkwright has no gears yet.",
        "A pair of gears turns two links in a fixed ratio. If one is driven, couple the other to it under joints: 'mesh: "
        "{{coupling: [gear2, frame], follows: -motor.angle*z1/z2}}'. The torque of the coupling is what the gears "
        "transmit; the forces of the teeth aren't computed.",
    ),
    "element.geneva": (
        "'{name}': linkwright has no Geneva drives yet.",
        "While the pin is in the slot, model it as a joint pin_in_slot between crank and wheel, with 'travel' for the "
        "slot's length. Or drive the wheel by a motion law with dwells.",
    ),
    "element.limits": (
        "'{name}': limits of a joint are not written under this name.",
        "The range of a slide is 'travel: [LOW, HIGH]', that of a cylinder 'length: [LOW, HIGH]'. For the angle of a "
        "pin, use a measure with a requirement: 'measures: {{swing: {{extremes: LINK.angle}}}}', 'require: {{swing: "
        "10 deg .. 80 deg}}'.",
    ),
    "element.motor": (
        "'{name}': motors and actuators are written under drives.",
        "For example 'drives: {{motor: {{turns: crank, on: frame, speed: 60 rpm, start: 0 deg}}}}'; a linear actuator "
        "between two points is a cylinder, with a drive that extends it.",
    ),
    "element.pin": (
        "'{name}': pins aren't listed; they follow from the names of points.",
        "Give the point the same name on both links. For points of different names: 'joints: {{B: {{revolute: [crank, "
        "rod], at: [B1, B2]}}}}'.",
    ),
    "element.rack": (
        "'{name}': linkwright has no rack and pinion yet.",
        "A rack travels in a fixed ratio to its pinion's angle. If the law of one is known, give each a drive of its "
        "own, the rack's travel being the pinion's radius times its angle: 'b: {{slides: rack, on: frame, position: "
        "r*(LAW OF THE PINION)}}'.",
    ),
    "element.rolling": (
        "'{name}': linkwright has no rolling contact yet.",
        "Rolling without slip is a fixed ratio between two motions. If the law of one is known, give the other a "
        "drive of its own in that ratio, for example 'position: -(TRAVEL)/r' for the angle of a wheel of radius r.",
    ),
    "element.rope": (
        "'{name}': linkwright has no ropes and cables yet.",
        "Model a rope that stays taut between two points as a link of its length; the sign of the force in its pins "
        "shows whether it stays taut. An elastic one is a spring.",
    ),
    "element.screw": (
        "'{name}': linkwright has no screws yet.",
        "Drive the nut directly: a slide (or a cylinder between two points) with the speed lead times rotational speed, "
        "for example 'speed: 5 mm*4/(1 s)'. The torque is the drive's force times lead/(2*pi).",
    ),
    "element.slide": (
        "'{name}': slides are written under joints, as prismatic.",
        "For example 'joints: {{guide: {{prismatic: [frame, slider], line: [F at 0 deg, C at 0 deg]}}}}'; a slide along a "
        "line between two points is a cylinder.",
    ),
    "element.slot": (
        "'{name}': a pin in a slot is written under joints, as pin_in_slot.",
        "For example 'joints: {{slot: {{pin_in_slot: [crank, lever], pin: B, straight: C at 0 deg}}}}', with B a point of the "
        "crank and C one of the lever.",
    ),
    "element.weld": (
        "'{name}': a welded joint is written under joints, as weld.",
        "For example 'joints: {{seam: {{weld: [bracket, rod], angle: 30 deg}}}}', with a point that both links share. If "
        "you don't need the forces in the section, put all points on one link. Parts that don't move at all belong to the frame.",
    ),
}
