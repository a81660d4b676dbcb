"""Problems of friction."""

PROBLEMS: dict[str, tuple[str, str]] = {
    "friction.place": (
        "摩擦的位置不明确。",
        "给出 pin（转动副名称）、slide（移动副名称）或 contact（凸轮或槽中销的名称），只给出其中一个。",
    ),
    "friction.stray": (
        "此类摩擦不允许使用这些键：{keys}。",
        "将其删除：转动副使用 radius，需要时加 in；移动副使用 length；接触仅在有滚子时使用 radius。",
    ),
    "friction.law": (
        "没有给出摩擦的规律。",
        "加上 coefficient（库仑摩擦）、viscous，或二者。",
    ),
    "friction.size": (
        "摩擦系数需要运动副的 {key}。",
        "加上 radius（销轴在轴承中的摩擦半径）或 length（导轨长度）。",
    ),
    "friction.pin-links": (
        "两个以上构件共用销轴 {pin}：{links}。不清楚哪个构件在哪个构件上摩擦。",
        "加上 in: [构件, 带销轴的构件]，每个在销轴上转动的构件各用一项摩擦。",
    ),
    "friction.not-on-pin": (
        "in 中的构件不在销轴 {pin} 上。",
        "该销轴上的构件为 {links}。",
    ),
    "friction.same-link": (
        "摩擦的两个构件都是 {name}，因此不起作用。",
        "给出两个不同的构件。",
    ),
    "friction.loop": (
        "移动副 {joint} 位于只含移动副的闭环中，其力矩不能由静力学确定，因此其摩擦不能取决于导轨长度。",
        "删除 length：该移动副的摩擦只由法向力决定，如同斜楔。",
    ),
    "friction.twice": (
        "{joint} 的摩擦已由 {other} 给出。",
        "删除其中之一，或合并为一个条目：一个条目可同时含摩擦系数、静摩擦系数和粘性摩擦。",
    ),
    "friction.second-contact": (
        "无法计算 {name} 接触处的摩擦：其从动件在两侧接触。",
        "去掉该摩擦，或使从动件只在一侧接触。铰链、移动副和其他接触可以有摩擦。",
    ),
    "friction.roller": (
        "接触 {name} 有滚子，摩擦发生在滚子的销轴上，因此需要该销轴的半径。",
        "加上 radius，即滚子销轴的半径。",
    ),
    "friction.no-roller": (
        "接触 {name} 没有滚子，其摩擦没有半径。",
        "删除 radius。",
    ),
    "friction.gives": (
        "在 t = {time} s（{drive} = {value} {unit}）摩擦系数为负：摩擦将成为驱动。",
        "将其写为速度大小的函数，例如“abs(NAME.omega)”的函数，且始终不小于零。",
    ),
    "friction.still": (
        "没有驱动的结构中，摩擦不能确定：没有构件运动。",
        "将其去掉，或加上使机构运动的驱动。",
    ),
    "friction.unsolved": (
        "在 t = {time} s（{drive} = {value} {unit}）无法完全精确地求出摩擦力：机构接近卡死，或各运动副相互影响过大。",
        "减小摩擦系数或半径，加长导轨，或避开这段运动。",
    ),
    "friction.jams": (
        "在 t = {time} s（{drive} = {value} {unit}）机构卡死：摩擦系数达到给定值的 {share} 时，摩擦已超过驱动的任何作用力。",
        "减小摩擦系数或半径，加长导轨，或避开这段运动。",
    ),
    "friction.jams-meeting": (
        "在 t = {time} s（{drive} = {value} {unit}）机构卡死：摩擦系数达到给定值的 {share} 时，两种可能的平衡状态重合，此后不存在使机构按此运动的平衡状态。",
        "减小摩擦系数或半径，加长导轨，或避开这段运动。",
    ),
    "friction.several": (
        "从 t = {time} s（{drive} = {value} {unit}）起，在 {share} % 的运动中摩擦力不唯一：其他的力（例如机构楔紧时的力）也满足同样的规律。"
        "给出的是摩擦从零逐渐增大时所达到的力。",
        "若机构可能楔紧，应减小摩擦系数或半径，或加长导轨。",
    ),
    "friction.static": (
        "只给静摩擦系数不够：它只说明何时起动，不说明运动中的摩擦。",
        "再给出运动时的 coefficient，例如 'coefficient: 0.1, static: 0.15'。",
    ),
    "friction.static-less": (
        "静摩擦系数 {static} 小于动摩擦系数 {coefficient}。",
        "将二者互换：静止时的摩擦不小于运动时的摩擦。",
    ),
    "friction.cannot-start": (
        "在 t = {time} s（{drive} = {value} {unit}）处，{name} 无论多大的驱动力（矩）都不能使机构从静止向{sense}的方向起动：按静摩擦系数机构在该处卡死。",
        "不要在该处停止；或减小静摩擦系数、铰链半径，或减小力相对导轨的偏距。",
    ),
    "friction.rests": (
        "从 t = {start} s 到 t = {stop} s（{drive} = {low} 至 {high} {unit}），松开 {name} 后静止的机构保持不动，而没有摩擦时载荷会使其运动。"
        "此类区间共 {count} 个，合计占运行时间的 {share} %。",
        "若要求机构不用制动器即能保持，则无需修改；否则使用制动器，或减小静摩擦系数。",
    ),
    "friction.self-locking": (
        "从 t = {start} s 到 t = {stop} s（{drive} = {low} 至 {high} {unit}）机构自锁：载荷本会反过来驱动 {name}，但被摩擦阻止，"
        "因此 {name} 必须推动机构。此类区间共 {count} 个，合计占运行时间的 {share} %。",
        "若要求机构不用制动器即能保持，则无需修改；否则减小摩擦系数或半径。",
    ),
}
