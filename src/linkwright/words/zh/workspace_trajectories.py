"""The words of trajectories at constant values of a drive."""

TEXTS: dict[str, str] = {
    "trajectories.sentence": "{held} 取 {count} 个定值、{moving} 走完其范围时 {point} 的轨迹。轨迹与输出极限位置的曲线相切，区域在该处折叠。",
    "trajectories.picture": "{held} 为定值时 {point} 的轨迹，模式：{mode}{values}",
    "trajectories.scale": "{held} 的定值（{moving} 运动时锁定）",
    "trajectories.table.trajectories": "各区域的轨迹",
    "trajectories.column.mode": "模式",
    "trajectories.column.held": "锁定的驱动",
    "trajectories.column.values": "数值",
    "trajectories.column.drive-unit": "单位",
    "trajectories.column.assembled": "可装配数",
    "trajectories.column.whole": "{moving} 走完全程数",
    "trajectories.column.stretches": "段数",
    "trajectories.column.length": "长度",
    "trajectories.column.unit": "单位",
}
