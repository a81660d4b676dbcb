"""Texts for elements that model files don't have, or that have another name."""

PROBLEMS: dict[str, tuple[str, str]] = {
    "element.belt": (
        "“{name}”：带和链传动在 joints 中以 belt 定义。",
        "例如“joints: {{drive: {{belt: [pulley, crank], centres: [O, A], radii: [50, 150], pretension: 300 N}}}}”；链和同步带给出 teeth 和 pitch。"
        "只关心传动比时可用联动：“{{coupling: [pulley2, frame], follows: motor.angle*r1/r2}}”。",
    ),
    "element.clearance": (
        "“{name}”：模型中的运动副没有间隙。",
        "在 accuracy 分析中给出间隙，例如“studies: {{accuracy: {{clearances: {{B: 0.02 mm}}, outputs: [...]}}}}”；"
        "见 docs/how-to/clearances.md。侧隙即齿轮副的间隙。",
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
        "“{name}”：转动副、移动副以及凸轮和销槽副接触处的摩擦在 friction 中定义。",
        "例如“friction: {{bearing_A: {{pin: A, radius: 10 mm, coefficient: 0.1}}, rail: {{slide: guide, length: 60 mm, "
        "coefficient: 0.12}}, seat: {{contact: valve, coefficient: 0.08}}}}”；contact 为凸轮或销槽副的名称。",
    ),
    "element.gear": (
        "“{name}”：齿轮副在 joints 中以 gears 定义。",
        "例如“joints: {{mesh: {{gears: [pinion, wheel], centres: [A, D], teeth: [20, 40], module: 2 mm}}}}”；行星轮用“carrier: arm”给出行星架，"
        "内齿圈用“internal: ring”给出。只关心传动比的减速器可用联动：“{{coupling: [gear2, frame], follows: -motor.angle*z1/z2}}”；差速器："
        "“{{differential: [cage, left, right], weights: [2, -1, -1]}}”。",
    ),
    "element.geneva": (
        "“{name}”：槽轮机构在 joints 中以 geneva 定义。",
        "例如“joints: {{indexing: {{geneva: [driver, wheel], centres: [O, Q], pins: [P], slots: 4, arc: 45 mm}}}}”，其中 P 是拨盘上的点。",
    ),
    "element.intermittent": (
        "“{name}”：linkwright 尚不支持棘轮、擒纵、星轮和内槽轮机构。",
        "外槽轮机构为运动副 geneva。其他带停歇的运动用驱动的运动规律表示，例如“laws: {{index: {{over: angle, of: angle, segments: "
        "[{{rise: 30 deg, over: 90 deg, law: cycloidal}}, {{dwell: 270 deg}}], beyond: advance}}}}”。",
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
        "“{name}”：齿条副在 joints 中以 rack 定义。",
        "例如“joints: {{mesh: {{rack: [pinion, slider], centre: M, pitch_line: G at 0 deg, radius: 25 mm}}}}”，其中 M 为小齿轮中心，G 为 slider 上节线的一点。",
    ),
    "element.rolling": (
        "“{name}”：滚动接触在 joints 中以 rolling 定义。",
        "例如“joints: {{ground: {{rolling: [wheel, frame], centre: C, radius: 60 mm, on_line: G at 0 deg}}}}”，或“on_circle: {{centre: M, radius: 80 mm}}”。"
        "由行星架保持中心距的摩擦轮，用压力角为 0 的齿轮副表示。",
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
