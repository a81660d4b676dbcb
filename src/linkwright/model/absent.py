"""Elements of machines that a model file doesn't have under the name by which they are looked for.

The catalogue says of each, by its code, whether linkwright lacks it or calls it otherwise, and what can be written.
"""

from __future__ import annotations

from typing import Any

_WORDS = {
    "element.belt": "belt belts belt_drive chain chains chain_drive pulley pulleys sprocket sprockets",
    "element.clearance": "clearance clearances play backlash",
    "element.contact": "contact contacts collision stop stops impact",
    "element.damper": "damper dampers dashpot dashpots shock_absorber",
    "element.friction": "friction frictions mu friction_coefficient coefficient_of_friction",
    "element.gear": "gear gears gearing gear_pair gearbox pinion gear_ratio differentials planetary",
    "element.geneva": "geneva geneva_drive geneva_wheel maltese maltese_cross",
    "element.intermittent": "ratchet ratchets pawl pawls escapement escapements star_wheel star_wheels internal_geneva",
    "element.limits": "limit limits stroke range joint_limits",
    "element.motor": "motor motors actuator actuators motion motions driver drivers",
    "element.pin": "pin pins hinge hinges pivot pivots",
    "element.rack": "rack racks rack_and_pinion rack_pinion",
    "element.rolling": "rolling roll rolls rolling_contact no_slip",
    "element.rope": "rope ropes cable cables tendon tendons",
    "element.screw": "screw screws spindle spindles helical",
    "element.slide": "slide slides slider sliders guide guides translational",
    "element.slot": "slot slots pin_slot slotted",
    "element.weld": "weld welds welded fixed fix rigid glued",
}
CODES = {word: code for code, words in _WORDS.items() for word in words.split()}
"""The code of each word; a word of two codes would be a mistake here."""
assert len(CODES) == sum(len(words.split()) for words in _WORDS.values())
SAYS_KIND = ("type", "kind", "joint", "类型", "种类")
"""Keys by which other programs name the kind of an element."""


def absent(key: Any, value: Any = None) -> tuple[str, str] | None:
    """The code of an element that is looked for by a key, or as the value of ``type``, and the word; else ``None``."""
    for word in (value, key) if key in SAYS_KIND else (key,):
        plain = word.strip().lower().replace(" ", "_").replace("-", "_") if isinstance(word, str) else ""
        if plain in CODES:
            return CODES[plain], str(word)[:60]
    return None
