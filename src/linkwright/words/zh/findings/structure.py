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
    "structure.redundant-joints": (
        "机构存在冗余约束（虚约束）：{joints} 的约束可由其余运动副导出（约束 {constraints} 个，秩 {rank}，"
        "自由度公式计算值 {gruebler}，实际自由度 {mobility}）。尺寸严格如此时机构仍可运动，运动和驱动力（矩）与 {joints} "
        "无关。{reactions}",
        "无需修改。实际机构中，尺寸偏差须由间隙或弹性变形补偿。",
    ),
    "structure.redundant-study": (
        "含冗余约束的机构不能进行 {name}：{joints} 的约束可由其余运动副导出。",
        "在模型的副本中删除 {joints}：运动和驱动力（矩）不变。",
    ),
    "structure.nearly-redundant": (
        "{joint} 可作为冗余运动副，但按现有尺寸其封闭误差达 {miss} {unit}：间隙和弹性变形若不能容纳该误差，机构将卡死。",
        "修正尺寸，使该运动副在所有位置都能封闭；或将其从模型中删除。",
    ),
    "stiffness.value": (
        "刚度不明确：value 与 equal 必须且只能给出一个。",
        "写成其中一种：50 kN/mm，或 equal。",
    ),
    "stiffness.mixed": (
        "{name} 的刚度为 equal，而其余刚度为数值：无法比较二者的大小。",
        "所有刚度都给出数值，或都写 equal。",
    ),
    "stiffness.link": (
        "{link} 不能有刚度：只有恰好带两个运动副、且均为转动副的构件，才有沿两者连线的刚度。",
        "删除该刚度，或改为给出 {link} 上各运动副的刚度。",
    ),
    "stiffness.loaded": (
        "{link} 不能有刚度：{name} 作用于该构件，变形量取决于作用位置。",
        "使 {name} 作用于同一销轴上的另一构件，或改为给出 {link} 上各运动副的刚度。",
    ),
    "stiffness.tilt": (
        "{name} 不是移动副，没有倾转刚度。",
        "删除 tilt。",
    ),
    "stiffness.no-effect": (
        "机构没有冗余约束：约束反力与刚度无关。",
        "若模型中没有遗漏冗余运动副，请删除 stiffness。",
    ),
    "stiffness.separating": (
        "不能按刚度计算 {joints} 如何分担载荷：齿轮啮合还产生径向分离力，与齿面切向力的大小成比例。",
        "删除 stiffness：不给出刚度也能算出运动、驱动力（矩）和所有可以确定的约束反力。",
    ),
    "stiffness.not-enough": (
        "给出的刚度不足以确定冗余运动副如何分担载荷。仍不能确定：{joints}。",
        "补充这些运动副的刚度以及移动副的倾转刚度，或写 stiffness: equal。",
    ),
    "stiffness.undetermined": (
        "{signal} 不能由静力学确定：机构存在冗余约束，各冗余运动副按刚度分担载荷。",
        "给出运动副的刚度（stiffness: equal 表示假定各处刚度相等），或改用可以确定的和：冗余运动副的警告中列有若干。",
    ),
    "stiffness.friction": (
        "{name} 的摩擦取决于 {joint} 的约束反力，而机构存在冗余约束，该反力不能由静力学确定。",
        "给出运动副的刚度（stiffness: equal 表示假定各处刚度相等），或删除该摩擦。",
    ),
    "structure.moments-indeterminate": (
        "移动副 {joints} 的方向相互约束：其约束反力可以确定，但力矩无法确定，因此不给出其力矩和力臂。",
        "无需修改。若需要力矩，将其中一个构件由导轨导向改为用转动副与滑块连接。",
    ),
    "structure.loop-of-slides": (
        "构件 {links} 不能依次装配：它们构成只含移动副的闭环，linkwright 无法对其联立求解。",
        "驱动其他构件，或用转动副加滑块代替其中一个移动副。",
    ),
    "structure.redundant": (
        "{links} 之间的运动副 {joint} 是冗余的：其约束已由其他运动副提供，因此其约束反力无法确定。",
        "删除该运动副，或删除重复的构件。",
    ),
}
