"""Texts for elements that model files don't have, or that have another name."""

PROBLEMS: dict[str, tuple[str, str]] = {
    "element.belt": (
        "'{name}': belts and chains are written under joints, as belt.",
        "For example 'joints: {{drive: {{belt: [pulley, crank], centres: [O, A], radii: [50, 150], pretension: 300 N}}}}'; a chain "
        "or toothed belt has teeth and pitch. Where only the ratio matters: '{{coupling: [pulley2, frame], follows: "
        "motor.angle*r1/r2}}'.",
    ),
    "element.clearance": (
        "'{name}': the joints of a model have no clearance.",
        "Give clearances in the accuracy study, for example 'studies: {{accuracy: {{clearances: {{B: 0.02 mm}}, "
        "outputs: [...]}}}}'; see docs/how-to/clearances.md. Backlash is the clearance of gears.",
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
        "'{name}': friction of pins, of slides and of the contacts of cams and pins in slots is written under friction.",
        "For example 'friction: {{bearing_A: {{pin: A, radius: 10 mm, coefficient: 0.1}}, rail: {{slide: guide, length: "
        "60 mm, coefficient: 0.12}}, seat: {{contact: valve, coefficient: 0.08}}}}'; contact is the name of a cam or of a "
        "pin in a slot.",
    ),
    "element.gear": (
        "'{name}': gears are written under joints, as gears.",
        "For example 'joints: {{mesh: {{gears: [pinion, wheel], centres: [A, D], teeth: [20, 40], module: 2 mm}}}}'; a planet "
        "gear names its carrier, 'carrier: arm', and a ring 'internal: ring'. Of a gearbox of which only the ratio matters: "
        "'{{coupling: [gear2, frame], follows: -motor.angle*z1/z2}}'; of a differential '{{differential: [cage, left, right], "
        "weights: [2, -1, -1]}}'.",
    ),
    "element.geneva": (
        "'{name}': Geneva drives are written under joints, as geneva.",
        "For example 'joints: {{indexing: {{geneva: [driver, wheel], centres: [O, Q], pins: [P], slots: 4, arc: 45 mm}}}}', with "
        "P a point of the driver.",
    ),
    "element.intermittent": (
        "'{name}': linkwright has no ratchets, escapements, star wheels and internal Geneva drives yet.",
        "An external Geneva drive is the joint geneva. Any other motion with dwells is a motion law of a drive, for example "
        "'laws: {{index: {{over: angle, of: angle, segments: [{{rise: 30 deg, over: 90 deg, law: cycloidal}}, {{dwell: 270 deg}}], "
        "beyond: advance}}}}'.",
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
        "'{name}': a rack is written under joints, as rack.",
        "For example 'joints: {{mesh: {{rack: [pinion, slider], centre: M, pitch_line: G at 0 deg, radius: 25 mm}}}}', with M the "
        "pinion's centre and G a point of the slider on the pitch line.",
    ),
    "element.rolling": (
        "'{name}': rolling contact is written under joints, as rolling.",
        "For example 'joints: {{ground: {{rolling: [wheel, frame], centre: C, radius: 60 mm, on_line: G at 0 deg}}}}', or "
        "'on_circle: {{centre: M, radius: 80 mm}}'. Wheels that a carrier holds at their distance are gears with the pressure "
        "angle 0.",
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
