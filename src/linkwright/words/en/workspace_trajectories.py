"""The words of trajectories at constant values of a drive."""

TEXTS: dict[str, str] = {
    "trajectories.sentence": "Trajectories of {point} at {count} constant values of {held}, while {moving} moves through its range. They are tangent to the limit positions of the output, where the region folds.",
    "trajectories.picture": "Trajectories of {point} at constant {held}, in mode {mode}{values}",
    "trajectories.scale": "{held}, locked at constant values while {moving} moves",
    "trajectories.table.trajectories": "Trajectories by region",
    "trajectories.column.mode": "Mode",
    "trajectories.column.held": "Locked drive",
    "trajectories.column.values": "Values",
    "trajectories.column.drive-unit": "Unit",
    "trajectories.column.assembled": "Assembled at",
    "trajectories.column.whole": "Full range of {moving} at",
    "trajectories.column.stretches": "Segments",
    "trajectories.column.length": "Length",
    "trajectories.column.unit": "Unit",
}
