"""Short forms with a fault: what is told of them, and that it isn't told again wherever they are named."""

from __future__ import annotations

import linkwright as lw
from helpers.cams import pair


def test_the_signals_of_a_faulty_cam_are_known() -> None:
    data = pair("swinging", "roller")
    (name,) = data["cams"]
    data["measures"] = {"most": {"max": f"{name}.force"}, "none": {"max": "ridder.force"}}
    assert [f.code for f in lw.check(lw.Document.model_validate(data))] == ["name.unknown-element"]
    data["cams"][name]["cam"] = "disk"
    found = lw.check(lw.Document.model_validate(data))
    assert [(f.code, f.element) for f in found] == [
        ("name.unknown", f"cams.{name}.cam"),
        ("name.unknown-element", "measures.none.max"),
    ]
