"""Problems of required paths and shapes in a workspace."""

PROBLEMS: dict[str, tuple[str, str]] = {
    "workspace.path-source": (
        "给定轨迹必须有且只有一个来源；已给出：{given}。",
        "写 points、file 或 drawing，或将 x 和 y 写成 u 的公式。",
    ),
    "workspace.path-pace": (
        "给定轨迹按电机的恒定速度跟踪，或按给定的时间跟踪，二者只取其一。",
        "写 speed（例如 speed: 30 rpm）或 duration（例如 duration: 2 s），不能同时写。",
    ),
    "workspace.path-key": (
        "{key} 只能与 {of} 一起使用。",
        "将其删除，或添加与其配合使用的项。",
    ),
    "workspace.path-still": (
        "电机的速度为零，不能跟踪轨迹。",
        "给出速度，例如 30 rpm；负值表示反向。",
    ),
    "workspace.path-none": (
        "给定轨迹 {name} 在 {count} 个区域中都不能跟踪。最接近可行的是模式为 {mode} 的区域（取值：{values}），其不能跟踪的原因另行列出。",
        "查看这些原因；汇总中列出了所有尝试，以及轨迹中不能跟踪的区段。",
    ),
    "workspace.section-drives": (
        "工作空间中的轨迹和形状需要两个驱动；该机构有 {count} 个。",
        "删除该段，或改变机构的驱动，使其有两个驱动。",
    ),
    "workspace.not-positive": (
        "{key}: {text} 不是正数。",
        "给出正值。",
    ),
    "workspace.fit-kind": (
        "形状必须在 circle、rectangle 和 largest 中给出且只给出一项；已给出：{given}。",
        "例如写 circle: 10 mm、rectangle: [20 mm, 10 mm] 或 largest: circle。",
    ),
    "workspace.fit-none": (
        "任何区域都不能容纳 {name}。在最接近的区域（模式：{mode}；取值：{values}）中，其面积的 {share} % 位于区域之外，最远超出 "
        "{by}；缩放到原尺寸的 {scale} 倍时可以容纳。",
        "缩小或移动该形状，或修改机构；largest: circle 可给出能容纳的最大圆。",
    ),
    "workspace.path-short": (
        "给定轨迹有 {given} 个互不重合的点；其曲线至少需要 {wanted} 个点。",
        "增加点，或采用直线段（between: linear）。",
    ),
    "workspace.path-unit": (
        "给定轨迹的“{column}”列不是长度。",
        "在方括号中注明单位，例如“x [mm]”。",
    ),
    "workspace.path-drawing": (
        "图形文件 {file} 中有 {count} 条曲线；给定轨迹必须是单条曲线。",
        "将其合并为一条多段线，或指定只含该轨迹的图层。",
    ),
    "drawing.unreadable": (
        "无法将图形文件 {file} 作为 DXF 读取：{reason}。",
        "在创建该图形的软件中重新存为 DXF。",
    ),
    "drawing.code": (
        "图形文件 {file} 中有“{given}”（{place}），该处应为组码。",
        "在创建该图形的软件中重新存为 DXF。",
    ),
    "drawing.number": (
        "图形文件 {file} 中，组码为 {code} 的组的值为“{given}”（{place}），应为绝对值小于 1e40 的有限数值。",
        "改正该数值，或重画该曲线；然后将图形重新存为 DXF。",
    ),
    "drawing.entity": (
        "图形文件 {file} 中句柄为 {handle} 的 {kind} 图元不能用作轨迹：{reason}。",
        "重画该图元，最好画成原点附近的一条多段线。",
    ),
    "workspace.path-name": (
        "给定轨迹的公式中不能使用“{name}”。",
        "用 u（从 0 变到 1）、参数和函数表示 x 和 y。",
    ),
    "workspace.path-value": (
        "给定轨迹的公式在 u = {u:.6g} 处没有值。",
        "检查是否除以零或对负数开方。",
    ),
    "workspace.path-rests": (
        "按给定轨迹的公式，点在 u = {u:.6g} 处停止，而电机在该处不能停止。",
        "修改 x 和 y 的公式，使点随 u 增大不断移动；或按时间给出轨迹（duration）。",
    ),
    "workspace.path-corner": (
        "给定轨迹有 {count} 个尖角，第一个在 u = {u:.6g} 处：驱动的速度在该处突变。",
        "将尖角倒圆，或用光滑曲线通过各点（between: cubic）。",
    ),
    "workspace.path-outside": (
        "在 u = {start} 至 {stop} 之间，{point} 不能到达给定轨迹：轨迹最远超出区域 {by}。",
        "移动或缩小轨迹，或选择其他装配模式；最大圆和最大矩形可显示能容纳的大小。",
    ),
    "workspace.path-singular": (
        "在 u = {start} 至 {stop} 之间，给定轨迹不能跟踪：它遇到第一类奇异位形，{point} 在该处的某个方向上不能运动"
        "（d(x, y)/d(drives) 的行列式为零）。",
        "使轨迹避开图中所示的奇异曲线，或从其他位置开始。",
    ),
    "workspace.path-modes": (
        "在 u = {start} 至 {stop} 之间，给定轨迹不能跟踪：两种装配模式在第二类奇异位形重合（某个封闭方程的行列式为零）。",
        "使轨迹避开该装配模式的边界，或选择其他装配模式。",
    ),
    "workspace.path-limit": (
        "在 u = {start} 至 {stop} 之间，给定轨迹不能跟踪：{drive} 到达其范围的极限。",
        "扩大 {drive} 的范围，或移动轨迹。",
    ),
    "workspace.path-turns": (
        "在 u = {start} 至 {stop} 之间，给定轨迹不能以恒定速度跟踪：{drive} 必须换向。",
        "使轨迹在该处结束，或按时间给出轨迹（duration），由两个驱动共同跟踪。",
    ),
    "workspace.path-dead": (
        "给定轨迹经过 {count} 个第一类奇异位形，第一个在 t = {time:.6g} s 时：{point} 在该处只能沿一个方向运动，驱动的误差与轨迹误差的平方根成正比。",
        "确保驱动精确地按其运动规律运动；若有避开奇异曲线的轨迹可用，则 {point} 的运动更易保证。",
    ),
    "workspace.servo-reverses": (
        "沿给定轨迹，{servo} 换向 {count} 次，第一次在 t = {time:.6g} s 时，但设置了 never_reverse。",
        "改用其他轨迹、电机速度或起点；或允许换向。",
    ),
}
