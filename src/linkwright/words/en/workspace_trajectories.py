"""The words of trajectories at constant values of a drive."""

WORKSPACE_TRAJECTORIES: dict[str, str] = {
    "trajectories.sentence": "Trajectories of {point} at {count} constant values of {held}, while {moving} goes through its range. They touch along dead positions of the output, where the region folds.",
    "trajectories.picture": "Trajectories of {point} at constant {held}, in the mode {mode}{values}",
    "trajectories.scale": "{held}, held at constant values while {moving} moves",
    "trajectories.table": "Trajectories by region",
    "trajectories.column.mode": "Mode",
    "trajectories.column.held": "Held drive",
    "trajectories.column.values": "Values",
    "trajectories.column.drive-unit": "Unit",
    "trajectories.column.assembled": "Assembled at",
    "trajectories.column.whole": "Full range of {moving} at",
    "trajectories.column.stretches": "Stretches",
    "trajectories.column.length": "Length",
    "trajectories.column.unit": "Unit",
}
