"""Problems of the structure of a mechanism."""

PROBLEMS: dict[str, tuple[str, str]] = {
    "structure.drive-no-joint": (
        "{link} 与 {on} 之间没有{joint}，驱动无法作用于二者之间。",
        "指定沿直线连接（slides）的两个构件，或给定某点沿直线的位置，例如 "
        "'{{moves: {link}, at: P, on: {on}, along: O at 0 deg, ...}}'。",
    ),
    "structure.drive-angle-fixed": (
        "{link} 相对 {on} 的角度已由移动副或其他驱动确定。",
        "删除该驱动，或令其驱动其他构件。",
    ),
    "structure.drive-two-joints": (
        "{link} 与 {on} 由多个运动副（{joints}）连接，无法确定驱动作用于哪一个。",
        "两个构件之间只保留一个运动副。",
    ),
    "structure.drive-too-many": (
        "{link} 和 {on} 已由运动副或其他驱动完全约束；该驱动使其过约束。",
        "删除该驱动或一个运动副。",
    ),
    "structure.output-apart": (
        "{output} 的运动与 {link} 和 {on} 无关，作用于二者之间的驱动不能使其运动。",
        "使驱动作用于与该输出相连的构件，或指定其他输出。",
    ),
    "structure.loose": (
        "欠约束的构件：{links}（剩余自由度：{freedom}）。",
        "将其与已约束的构件连接，检查共用点的名称拼写，或添加驱动。{hint}",
    ),
    "structure.loose-many": (
        "有 {count} 个构件欠约束（剩余自由度：{freedom}）；其中与已约束构件相邻的有：{links}。",
        "将其与已约束的构件连接，检查共用点的名称拼写，或添加驱动。{hint}",
    ),
    "structure.unpinned": (
        "{link} 的点 {point} 与 {on} 的点 {other} 名称相近，但各自只在一个构件上，不构成铰链。欠约束的构件：{links}（剩余自由度：{freedom}）。",
        "若二者是同一铰链，改为同一名称；否则将这些构件与已约束的构件连接，或添加驱动。",
    ),
    "structure.unpinned-joint": (
        "{link} 的点 {point} 不在其他任何构件上，但其名称与运动副 {other} 相近。欠约束的构件：{links}（剩余自由度：{freedom}）。",
        "若该点位于此铰链上，将其改名为 {other}；否则将这些构件与已约束的构件连接，或添加驱动。",
    ),
    "structure.overconstrained": (
        "过约束的构件：{links}（多余约束数：{excess}）。",
        "删除一个运动副或驱动，或添加两个铰链之间缺少的构件。",
    ),
    "structure.redundant-movable": (
        "{part} 是冗余的（虚约束）：在现有尺寸下，机构仍能运动（{constraints} 个约束的秩为 {rank}，按 Grübler 公式自由度为 {gruebler}，实际自由度为 "
        "{mobility}），但它所分担的力无法确定。",
        "从模型中删除 {part}：运动不变。它所承受的力取决于间隙和刚度。",
    ),
    "structure.nearly-redundant": (
        "{part} 近似冗余（虚约束），几乎可随机构一起运动，但其运动副的封闭误差达 {miss} {unit}。",
        "改正其尺寸，或将其从模型中删除。",
    ),
    "structure.moments-indeterminate": (
        "移动副 {joints} 的方向相互约束：其约束反力可以确定，但力矩无法确定，因此不给出其力矩和力臂。",
        "无需修改。若需要力矩，将其中一个构件由导轨导向改为用转动副与滑块连接。",
    ),
    "structure.loop-of-slides": (
        "构件 {links} 不能依次装配：它们只由移动副构成环路，linkwright 无法对其联立求解。",
        "驱动其他构件，或用转动副加滑块代替其中一个移动副。",
    ),
    "structure.redundant": (
        "{links} 之间的运动副 {joint} 是冗余的：其约束已由其他运动副提供，因此其约束反力无法确定。",
        "删除该运动副，或删除重复的构件。",
    ),
}
