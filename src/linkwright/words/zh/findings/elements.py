"""Problems of links, joints, drives and loads."""

PROBLEMS: dict[str, tuple[str, str]] = {
    "model.no-frame": (
        "没有名为“frame”的构件，因此没有机架。现有构件：{links}。",
        "{hint}",
    ),
    "model.frame-mass": (
        "给出了机架的质量，但机架不运动，其质量不起作用。",
        "删除该质量。",
    ),
    "model.no-moving-link": (
        "除机架外没有其他构件。",
        "添加活动构件。",
    ),
    "model.no-points": (
        "构件 {name} 上没有点，无法与其他构件连接。",
        "为其添加点，例如 points: {{A: [0, 0], B: [100, 0]}}。",
    ),
    "model.no-freedom": (
        "机构没有驱动，也不能运动：按 Grübler 公式，其自由度为 {mobility}。",
        "若要求解结构的约束反力，写 studies: {{reactions: {{}}}}。若要使其运动，删除一个运动副或拆分一个构件，并添加驱动。",
    ),
    "model.no-drive": (
        "没有驱动，运动不确定。",
        "添加一个驱动，例如 drives: {{motor: {{turns: crank, on: frame, speed: 60 rpm, start: 0 deg}}}}。",
    ),
    "mass.shape-and-com": (
        "shape 已确定质量分布，但又给出了 {given}。",
        "只保留 shape，或只保留 com 和 inertia。",
    ),
    "mass.missing": (
        "给出了 {given}，但没有给出质量。",
        "添加质量。",
    ),
    "mass.incomplete": (
        "构件有质量，但质心和转动惯量没有全部给出（缺少：{missing}）。",
        "添加 com 和 inertia，或添加 shape，例如“rod A-B”。",
    ),
    "joint.kind": (
        "未指明该运动副是移动副还是转动副。",
        "移动副给出 prismatic 和 line，转动副给出 revolute 和 at。",
    ),
    "joint.line": (
        "移动副需要在两个构件上各给出一条直线，不需要其他定义。",
        "写 line: [H at 0 deg, G at 0 deg]：对每个构件给出一点和直线的方向。",
    ),
    "joint.at": (
        "转动副需要在两个构件上各给出一点，不需要其他定义。",
        "写 at: [P, Q]：第一个构件上的一点和第二个构件上的一点。",
    ),
    "joint.slot": (
        "销槽副必须在 straight、arc 和 curve 中给出且只给出一项；已给出：{given}。",
        "例如 straight: C at 0 deg，arc: {{centre: C, radius: 40}}，或 curve: {{along: C at 0 deg, through: [[0, 0], "
        "[30, 8], [60, 0]]}}。",
    ),
    "joint.slot-places": (
        "曲线槽需要 2 至 {most} 个点；已给出：{count}。",
        "写 through: [[0, 0], [30, 8], [60, 0]]，各点沿直线依次排列。",
    ),
    "joint.slot-order": (
        "曲线槽的各点必须沿其直线按递增顺序排列（第 {row} 点）。",
        "按第一个坐标排序，并删除重复的点。",
    ),
    "joint.lifts-off": (
        "{joint}（{kind}）的两个构件脱离：在 t = {time} s（{drive} = {value} {unit}）时，需要 {force} {of} 的拉力才能保持接触。",
        "用弹簧或重物预紧；销槽副也可设为销在槽的两侧均可接触（flank: both）。",
    ),
    "joint.same-link": (
        "两个构件都是 {name}，但运动副或驱动需要两个不同的构件。",
        "指定另一个构件。",
    ),
    "joint.pin-twice": (
        "构件 {link} 上有多个点（{points}）将位于同一铰链 {pin} 上。",
        "将这些点改名，或删除将它们连接起来的运动副。",
    ),
    "drive.kind": (
        "驱动未指明所驱动的构件或缸。",
        "在 turns、slides 或 moves 中给出构件名，或在 extends 中给出缸或移动副的名称。",
    ),
    "drive.on": (
        "使用 turns、slides 或 moves 的驱动必须用 on 给出另一个构件；使用 extends 的驱动不能有 on。",
        "与 turns、slides 和 moves 一起给出 on（通常为 on: frame）；使用 extends 时将其删除。",
    ),
    "drive.point": (
        "moves、at 和 along 必须同时给出：某构件的一个点，以及度量其位置的直线。",
        "三者都给出，例如 '{{moves: coupler, at: P, on: frame, along: O at 90 deg, ...}}'，其中 O 是 on 所指构件的点；"
        "或改用 turns、slides，并去掉 at 和 along。",
    ),
    "sketch.missing-point": (
        "构件 {link} 的点 {name} 取草图中的位置，但草图中没有该点。",
        "{near}否则在 sketch 中给出该点的位置，或给出其在构件自身坐标系中的坐标。",
    ),
    "sketch.unused": (
        "没有构件使用草图点 {name}。",
        "将其添加到某个构件的 points 中，或从草图中删除。",
    ),
    "sketch.no-value": (
        "{name} 的值不能由草图确定。",
        "直接给出数值。草图只能确定以下各量：前两个点均已画出的构件之间的夹角、草图点之间的缸的长度，以及机架上移动副的位移。",
    ),
    "sketch.mixed": (
        "部分草图点有三个坐标（{three}），其余只有两个（{two}）。",
        "统一给出车辆坐标系中的三个坐标，或统一给出机构平面内的两个坐标。",
    ),
    "sketch.in-line": (
        "草图点共线（或少于三个），不能确定机构平面。",
        "给出平面，例如 plane: xz 或 plane: {{normal: [0, 1, 0.02]}}，或改画另一位姿的草图。",
    ),
    "triangle.two": (
        "点由其到同一构件上另外两点的距离确定；此处给出了 {count} 个距离。",
        "例如 P: {{from: {{A: 80 mm, B: 60 mm}}, side: left of A-B}}。",
    ),
    "triangle.side": (
        "side 的“{given}”与距离所用的点不一致，距离是从 {first} 和 {second} 量起的。",
        "写成 side: {text}（从 {first} 向 {second} 看），或从 side 的两点给出距离。",
    ),
    "triangle.circular": (
        "无法确定构件 {link} 上点 {point} 的位置：按所给距离，它由自身推出。",
        "用坐标给出构件的两个点，其余各点用到已给出的点的距离来确定。",
    ),
    "triangle.impossible": (
        "构件 {link} 上的点 {point} 没有位置：以下三边不构成三角形：{sides}。任意两边之和必须大于第三边；此处差值为 "
        "{value} {unit}，必须为正。",
        "更正两个距离之一，或更正量取距离的点。若该点位于另外两点的连线上，改用坐标给出。",
    ),
    "sketch.coincident": (
        "构件 {link} 的点 {a} 和 {b} 在机构平面内重合。",
        "检查两点的坐标和平面：两点之间的距离不能为零。",
    ),
    "sketch.no-plane": (
        "该机构不是平面机构：{name} 与法向为（{normal}）的平面相距 {off} {unit}，允许值为 {limit} {unit}。",
        "检查坐标。若各铰链沿自身轴线的位置不同，给出平面（plane: xz，或其法向）；plane: {{within: LENGTH}} 可修改允许值。",
    ),
    "sketch.off-plane": (
        "{name} 与各铰链点的拟合平面（法向：{normal}）相距 {off} {unit}。",
        "检查其坐标，或给出平面；plane: {{within: LENGTH}} 可设置允许的偏差。",
    ),
    "sketch.plane-unused": (
        "给出了平面，但没有草图点具有三个坐标。",
        "以车辆坐标系中的 [x, y, z] 给出草图点，或删除该平面。",
    ),
    "sketch.plane-twice": (
        "平面同时给出了 axes 和 normal。",
        "由车辆坐标系的两个坐标轴构成的平面用 axes 给出，其他平面用 normal 给出。",
    ),
    "cylinder.same-point": (
        "缸的两端都在 {point} 处。",
        "指定两个不同的点，例如机架上的一点和活动构件上的一点。",
    ),
}
