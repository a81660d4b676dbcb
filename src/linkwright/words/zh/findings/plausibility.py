"""Texts for inputs that look like a mistake: gravity, starts, lengths, masses, speeds, modes; and for travel."""

PROBLEMS: dict[str, tuple[str, str]] = {
    "gravity.no-direction": (
        "重力没有方向：两个分量均为零。",
        "写明方向，例如“gravity: earth along [0, -1]”；若无重力，删除 gravity。",
    ),
    "gravity.size": (
        "重力加速度被读作 {given} = {si}，为地球重力加速度（9.80665 m/s²）的 {times} 倍。",
        "若指地球重力，写“gravity: {earth}”。",
    ),
    "sketch.other-start": (
        "驱动 {name} 的起始值为 {start}，而草图所示为 {drawn}：二者相差 {off}。",
        "删除“start”，即从草图所示位置开始。若本意如此，写“start: {apart}”。",
    ),
    "sketch.other-position": (
        "驱动 {name} 的起始值为 {start}，而草图所示为 {drawn}：二者相差 {off}。",
        "以草图所示位置为起点写运动规律：“position: sketch + ...”。若本意如此，以“{apart}”开头。",
    ),
    "plausible.lengths": (
        "长度之比达 {ratio}：{short} 为 {low}，{long} 为 {high}。",
        "检查二者的单位。若长度无误，则无需修改。",
    ),
    "plausible.masses": (
        "质量之比达 {ratio}：{light} 为 {low}，{heavy} 为 {high}。",
        "检查二者的单位。若质量无误，则无需修改。",
    ),
    "plausible.speed": (
        "驱动 {name} 的转速为 {speed} = {rpm} rpm：转一圈需要 {period}。",
        "检查转速及其单位：此处不带单位的数值按 {unit} 读取。例如写“speed: {example}”。",
    ),
    "plausible.unloaded": (
        "各构件均无质量，机构也不受任何作用力：所有力和力矩均为零，测量项 {names} 也为零。",
        "为构件给出质量及其分布（mass、shape），或添加载荷、弹簧或摩擦。若只关心运动，则无需修改。",
    ),
    "plausible.mirrored": (
        "规则“{rule}”为 {links} 选定的装配模式与草图呈镜像关系（点 {point}）。",
        "若草图正确，删除该规则，或改写为“{other}”；若规则正确，则改正草图。",
    ),
    "plausible.coincident": (
        "在整个运动过程中，点 {first} 和 {second} 始终重合，但二者没有连接。",
        "若非本意，选择另一装配模式；“linkwright modes FILE”可列出各装配模式。若二者属于两个构件共用的铰链，则在两个构件上取同一名称。",
    ),
    "plausible.antiparallelogram": (
        "四杆机构 {links} 的对边相等（{lengths}），但按反平行四边形（交叉）运动。",
        "若应为平行四边形机构，选择另一装配模式{rule}。",
    ),
    "joint.travel": (
        "“travel”只适用于移动副；此处为转动副。",
        "删除 travel。",
    ),
    "motion.travel": (
        "移动副 {name} 在 t = {leaves} s（{drive} = {leaves_value} {unit}）时超出其行程（{low} 至 {high} {length_unit}）；超出量在 t = {time} "
        "s（{drive} = {value} {unit}）时最大：此时位移为 {travel} {length_unit}，{end}限值，超出 {by} {length_unit}。",
        "限制驱动的范围，修改尺寸，或增大移动副的行程。",
    ),
}

TERMS: dict[str, str] = {
    "gravity": "earth、“earth along [x, y]”，或 [gx, gy]，例如 [0, -9.81 m/s^2]",
    "below": "低于",
    "above": "高于",
    "or-rule": "：写“{rule}”",
}
