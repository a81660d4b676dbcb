"""The words of the reactions study."""

TEXTS: dict[str, str] = {
    "report.reactions": "Reactions",
    "reactions.table.joints": "Joint reactions: force of the first link on the second",
    "reactions.table.bars": "Two-force bars (pinned at two points, not loaded): tension is positive",
    "reactions.table.proof": "Verification",
    "reactions.column.joint": "Joint",
    "reactions.column.reaction": "Reaction",
    "reactions.column.value": "Value",
    "reactions.column.unit": "Unit",
    "reactions.column.bar": "Bar",
    "reactions.column.kind": "Kind",
    "reactions.column.check": "Check",
    "reactions.column.residual": "Residual",
    "reactions.open": "indeterminate",
    "reactions.direction": "at {angle} {unit}",
    "reactions.bar": "tension of {link}",
    "reactions.tension": "tension",
    "reactions.compression": "compression",
    "reactions.unloaded": "zero",
    "reactions.closure": "Joints close (largest closure error relative to the size)",
    "reactions.equilibrium": "Every link is in equilibrium (largest residual relative to the largest force)",
}
