"""The words of the reactions study."""

TEXTS: dict[str, str] = {
    "report.reactions": "约束反力",
    "reactions.table.joints": "运动副约束反力：第一个构件对第二个构件的作用力",
    "reactions.table.bars": "二力杆（两端铰接、无载荷）：拉力为正",
    "reactions.table.proof": "验证",
    "reactions.column.joint": "运动副",
    "reactions.column.reaction": "约束反力",
    "reactions.column.value": "数值",
    "reactions.column.unit": "单位",
    "reactions.column.bar": "二力杆",
    "reactions.column.kind": "受力类型",
    "reactions.column.check": "检查",
    "reactions.column.residual": "残差",
    "reactions.open": "静不定",
    "reactions.direction": "方向 {angle} {unit}",
    "reactions.bar": "{link} 的拉力",
    "reactions.tension": "受拉",
    "reactions.compression": "受压",
    "reactions.unloaded": "不受力",
    "reactions.closure": "运动副均封闭（最大封闭误差与机构尺寸之比）",
    "reactions.equilibrium": "各构件均平衡（最大残差与最大力之比）",
}
