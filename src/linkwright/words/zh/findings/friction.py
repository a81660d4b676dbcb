"""Problems of springs."""

PROBLEMS: dict[str, tuple[str, str]] = {
    "friction.place": (
        "摩擦的位置不明确。",
        "给出 pin（转动副名称）或 slide（移动副名称），二者之一。",
    ),
    "friction.stray": (
        "此类摩擦不允许使用这些键：{keys}。",
        "将其删除：转动副使用 radius，需要时加 in；移动副使用 length。",
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
        "无法计算移动副 {joint} 中的摩擦：它位于移动副的环中，其力矩不能由静力学确定。",
        "将摩擦放在其他运动副中，或将大小已知的力作为载荷施加。",
    ),
    "friction.second-contact": (
        "摩擦无法与 {name} 一起计算：其从动件在两侧接触。",
        "去掉摩擦，或使从动件只在一侧接触。",
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
}
