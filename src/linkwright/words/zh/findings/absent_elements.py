"""Texts for elements that model files don't have, or that have another name."""

PROBLEMS: dict[str, tuple[str, str]] = {
    "element.belt": (
        "“{name}”：linkwright 尚不支持带传动和链传动。",
        "带传动使两个构件按半径之比转动。若其中一个由驱动带动，在 joints 中使另一个与之联动：“belt: {{coupling: [pulley2, frame], follows: "
        "motor.angle*r1/r2}}”。联动的力矩即为带所传递的力矩；带两侧的拉力不作计算。",
    ),
    "element.clearance": (
        "“{name}”：模型中的运动副没有间隙。",
        "在 accuracy 分析中给出间隙，例如“studies: {{accuracy: {{clearances: {{B: 0.02 mm}}, outputs: [...]}}}}”；"
        "见 docs/how-to/clearances.md。",
    ),
    "element.contact": (
        "“{name}”：linkwright 尚不支持接触和限位。",
        "凸轮的接触在 cams 中定义。移动副的范围用“travel”限制，缸的范围用“length”限制；其他范围用测量项和要求来检查。",
    ),
    "element.damper": (
        "“{name}”：阻尼器在 springs 中定义。",
        "例如“springs: {{damper: {{from: A, to: B, damping: 200 N*s/m}}}}”。",
    ),
    "element.friction": (
        "“{name}”：转动副和移动副的摩擦在 friction 中定义。",
        "例如“friction: {{bearing_A: {{pin: A, radius: 10 mm, coefficient: 0.1}}, rail: {{slide: guide, length: 60 mm, "
        "coefficient: 0.12}}}}”。linkwright 尚不支持凸轮和销槽副的摩擦。",
    ),
    "element.gear": (
        "“{name}”：linkwright 尚不支持齿轮。",
        "一对齿轮使两个构件按固定传动比转动。若其中一个由驱动带动，在 joints 中使另一个与之联动：“mesh: {{coupling: [gear2, frame], follows: "
        "-motor.angle*z1/z2}}”。联动的力矩即为齿轮所传递的力矩；齿面力不作计算。",
    ),
    "element.geneva": (
        "“{name}”：linkwright 尚不支持槽轮机构。",
        "销在槽内的阶段，用拨盘与槽轮之间的销槽副（pin_in_slot）建模，槽长用“travel”给出。也可用带休止段的运动规律驱动槽轮。",
    ),
    "element.limits": (
        "“{name}”：运动副的范围不以此名称给出。",
        "移动副的范围为“travel: [LOW, HIGH]”，缸的范围为“length: [LOW, HIGH]”。转动副的角度用测量项和要求来检查：“measures: {{swing: "
        "{{extremes: LINK.angle}}}}”、“require: {{swing: 10 deg .. 80 deg}}”。",
    ),
    "element.motor": (
        "“{name}”：电机和执行器在 drives 中定义。",
        "例如“drives: {{motor: {{turns: crank, on: frame, speed: 60 rpm, start: 0 deg}}}}”；两点之间的直线执行器定义为缸，并设置使其伸缩的驱动。",
    ),
    "element.pin": (
        "“{name}”：转动副无需列出，由点的名称自动生成。",
        "在两个构件上为该点取同一名称。若两点名称不同：“joints: {{B: {{revolute: [crank, rod], at: [B1, B2]}}}}”。",
    ),
    "element.rack": (
        "“{name}”：linkwright 尚不支持齿轮齿条。",
        "齿条的位移与小齿轮的转角成固定比例。若其中一个的运动规律已知，为二者分别设置驱动，齿条的位移等于小齿轮的半径与转角之积：“b: {{slides: rack, on: frame, "
        "position: r*(小齿轮的运动规律)}}”。",
    ),
    "element.rolling": (
        "“{name}”：linkwright 尚不支持滚动接触。",
        "无滑动的滚动使两个运动成固定比例。若其中一个的运动规律已知，按该比例为另一个单独设置驱动，例如半径为 r 的轮的转角：“position: -(位移)/r”。",
    ),
    "element.rope": (
        "“{name}”：linkwright 尚不支持绳索和钢丝绳。",
        "两点之间始终张紧的绳索，可用等长的构件建模；由其铰链约束反力的正负可判断绳索是否始终张紧。弹性绳索用弹簧建模。",
    ),
    "element.screw": (
        "“{name}”：linkwright 尚不支持螺旋副。",
        "直接驱动螺母：设置移动副（或两点之间的缸），其速度为导程乘以转速，例如“speed: 5 mm*4/(1 s)”。力矩等于驱动力与导程之积除以 2*pi。",
    ),
    "element.slide": (
        "“{name}”：移动副在 joints 中以 prismatic 定义。",
        "例如“joints: {{guide: {{prismatic: [frame, slider], line: [F at 0 deg, C at 0 deg]}}}}”；沿两点连线的移动副定义为缸。",
    ),
    "element.slot": (
        "“{name}”：销槽副在 joints 中以 pin_in_slot 定义。",
        "例如“joints: {{slot: {{pin_in_slot: [crank, lever], pin: B, straight: C at 0 deg}}}}”，其中 B 为 crank 上的点，C 为 lever 上的点。",
    ),
    "element.weld": (
        "“{name}”：焊接在 joints 中用 weld 表示。",
        "例如“joints: {{seam: {{weld: [bracket, rod], angle: 30 deg}}}}”，两个构件要有一个同名的点。若不需要该截面的内力，"
        "可把所有的点写在同一个构件上。完全不动的零件属于机架。",
    ),
}
