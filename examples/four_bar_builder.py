"""A four-bar crank-rocker by the builder: the model of four_bar.yaml in short, run for three crank lengths.

Run it with: python examples/four_bar_builder.py
"""

import linkwright as lw


def four_bar(crank: float) -> lw.Document:
    """A crank-rocker with a crank of so many millimetres, at 120 rpm."""
    return (
        lw.Builder("Four-bar crank-rocker", length="mm", angle="deg", mass="kg", torque="N*m")
        .parameter("a", crank)
        .parameter("b", 120)
        .parameter("c", 80)
        .frame(O2=[0, 0], O4=[100, 0])
        .link("crank", O2=[0, 0], A=["a", 0], mass=0.2, shape="rod O2-A")
        .link("coupler", A=[0, 0], B=["b", 0], P="70 at 30 deg", mass=0.5, shape="rod A-B")
        .link("rocker", O4=[0, 0], B=["c", 0], mass=0.3, shape="rod O4-B")
        .assembly("B", "open")
        .drive("motor", turns="crank", speed="120 rpm", start="40 deg")
        .gravity(0, "-9.80665 m/s^2")
        .load("cutting", "coupler", at="P", force=[0, -20])
        .measure("swing", span="rocker.angle")
        .measure("torque", extremes="motor.torque")
        .measure("pin_force", max="hypot(force(coupler, rocker).x, force(coupler, rocker).y)")
        .require("swing", ">= 70 deg")
        .study("cycle", turns="1 motor", samples=360)
        .build()
    )


def main() -> None:
    for crank in (30, 38, 40):
        outcome = lw.run(four_bar(crank)).cycle
        print(f"crank {crank} mm")
        for measure in outcome.measures:
            figures = ", ".join(f"{found.value / measure.size:.4g}" for found in measure.found)
            verdict = {True: "passed", False: "failed", None: ""}[measure.verdict]
            print(f"  {measure.name:10} {figures} {measure.unit} {verdict}".rstrip())
        print(f"  certificate sound: {outcome.result.certificate.sound()}")


if __name__ == "__main__":
    main()
