"""Numbers of a file as a page names them: in English by their places in the file."""

TEXTS: dict[str, str] = {
    "number.point.frame": "机架（{link}）点 {point}：{part}",
    "number.point.link": "{link} 的点 {point}：{part}",
    "number.sketch": "草图点 {point}：{part}",
    "number.com": "{link} 的质心：{part}",
    "number.line.0": "{joint} 的第 1 条直线：方向角",
    "number.line.1": "{joint} 的第 2 条直线：方向角",
    "number.window.0": "时间窗 {window}：起点",
    "number.window.1": "时间窗 {window}：终点",
    "number.of.mass": "{name} 的质量",
    "number.of.inertia": "{name} 的转动惯量",
    "number.of.speed": "{name} 的速度",
    "number.of.start": "{name} 的初始值",
    "number.of.stiffness": "{name} 的刚度",
    "number.of.free": "{name} 的自由长度",
    "number.of.damping": "{name} 的阻尼系数",
    "number.of.radius": "{name} 的半径",
    "number.of.base": "{name} 的基圆半径",
    "number.of.roller": "{name} 的滚子半径",
}
