"""docs/zh/papers/index.md: the largest deviations from what the papers print, out of the tables of the pages."""

from __future__ import annotations

from validation.papers import Rows, Tables, cam, feeder


def largest(rows: Rows, column: int) -> str:
    """Of deviations in percent, whatever their sign."""
    return f"{max(abs(float(row[column].removesuffix(' %'))) for row in rows):.2f} %"


def tables() -> Tables:
    forces = [*feeder.forces("return"), *feeder.forces("feed")]
    limits = {row[0]: row[2] for row in feeder.motion()}
    return {
        "summary": [
            [f"{max(float(row[2]) for row in feeder.points()):.4f} mm"],
            [f"{limits['680.26']} mm"],
            [f"{limits['1204.41']} mm/s"],
            [largest(forces, 2)],
            [largest(forces, 4)],
            [cam.expressions()[0][1].replace(" °", "°")],
            [cam.curvature()[0][2]],
            [cam.curvature()[1][2]],
        ]
    }
