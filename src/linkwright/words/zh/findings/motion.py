"""Problems of assembly and motion."""

PROBLEMS: dict[str, tuple[str, str]] = {
    "assembly.slides-parallel": (
        "{link} 的移动副 {joints} 相互平行，其沿移动方向的位置不确定。",
        "改正 line 中的角度，或驱动 {link}。",
    ),
    "assembly.missing": (
        "{links} 有两种装配模式，但未选择其中一种。",
        "在 assembly 中添加：{options}；或在草图中给出该点的位置：[x, y]。",
    ),
    "assembly.contradiction": (
        "以下规则同时选择了同一对构件的两种装配模式：{rules}。",
        "只保留其中一条。",
    ),
    "assembly.unused": (
        "{point} 的规则不适用于任何有两种装配模式的一对构件。",
        "删除该规则，或改为这样一对构件的中间铰链。",
    ),
    "assembly.wrong-pins": (
        "{point} 的规则未指明其所在构件对的外接运动副。",
        "改为 {options}。",
    ),
    "assembly.not-four-bar": (
        "“open”和“crossed”仅适用于铰链四杆机构，而 {point} 不是铰链四杆机构的铰链。",
        "改为 {options}。",
    ),
    "assembly.ambiguous": (
        "在起始位姿，{point} 的规则不能区分两种装配模式。",
        "改为 {options}；或从其他位姿开始。",
    ),
    "assembly.cannot-close": (
        "{links} 在起始位姿不能装配：{joints} 相距 {distance} {unit}，{short}。",
        "{lengths}；或从其他位姿开始。",
    ),
    "assembly.degenerate": (
        "{links} 在起始时的位姿不唯一：其运动副 {joints} 重合，或其直线相互平行。",
        "改正这些构件的点和直线，或从其他位姿开始。",
    ),
    "assembly.no-sketch": (
        "{links} 只能联立求解装配，且有多种装配模式，但未选择其中一种。",
        "运行“linkwright modes FILE”，其结果列出各装配模式及可直接复制的行；或在 assembly 中按“{first}: [x, y]”的形式给出铰链 "
        "{pins} 在起始位姿附近的位置。",
    ),
    "assembly.not-found": (
        "在{where}附近，未找到 {links} 在起始位姿的装配。",
        "检查各长度，并将草图中的铰链画在运动起始时的位置。",
    ),
    "assembly.singular-start": (
        "起始时，{links} 在{where}附近能够闭合，但处于奇异位形：两种装配模式在此重合，速度和力均无定义。",
        "从其他位姿开始。若各构件始终处于该位形，则更改长度或更换其中一个运动副，使构件不再与其导路共线。",
    ),
    "assembly.out-of-reach": (
        "点 {point} 在起始位姿不可达：给定位置距铰链 {pin} 为 {distance}，而 {links} {short}。",
        "修改起始时的给定位置，移动铰链 {pin}，或修改杆长。",
    ),
    "assembly.no-mode": (
        "驱动处于该位置时，各构件没有装配模式。",
        "检查各长度，或改用其他位姿：修改驱动的 start 或 studies.modes.at。",
    ),
    "motion.stuck": (
        "在 t = {time} s（{drive} = {value} {unit}）时，杆组 {group} 到达奇异位形，运动无法继续跟踪。",
        "修改长度，或使运动避开该位置。",
    ),
    "motion.cannot-assemble": (
        "{drive} 在 {from} 至 {to} {unit} 之间时，{links} 不能装配：{joints} 相距 {distance} {length_unit}，{short}。",
        "{lengths}；或使 {drive} 避开该范围。",
    ),
    "motion.out-of-reach": (
        "从 t = {time} s 到 {until} s，{drive} 不能按其运动规律运动：运动规律要求达到 {worst} {unit}，而构件将运动限制在 "
        "{from} {unit}（该时段结束时为 {to} {unit}）。若达到，则 {links} 的 {joints} 将相距 {distance} {length_unit}，{short}。",
        "{lengths}；或将 {drive} 的运动规律限制在该极限以内。",
    ),
    "motion.dead-centre": (
        "在 t = {time} s（{drive} = {value} {unit}）时，{motors} 相对 {drive} 处于死点：{drive} 运动而 {motors} "
        "不动，其力或力矩在该处不能驱动或保持 {drive}。",
        "将 {drive} 的运动规律限制在 {value} {unit} 的一侧，或使驱动作用于其他运动副。",
    ),
    "motion.singular": (
        "在 t = {time} s（{drive} = {value} {unit}）时，杆组 {group} 到达奇异位形，即变点或死点（行列式为 {determinant}）："
        "运动可沿两种方式继续，速度和力在该处没有定义。",
        "若运动应平滑通过（例如平行四边形机构保持为平行四边形），在 studies: cycle 中写 through: keep；否则用第三个曲柄或驱动引导构件，"
        "修改长度，或使运动避开该位置。",
    ),
    "motion.singular-throughout": (
        "杆组 {group} 在运动的所有位姿都处于奇异位形：其两种装配模式处处重合，速度和力没有定义。",
        "修改某个长度或运动副的间距，使构件不始终处于极限状态；或将其中一个运动副改为固连，并让另一处可滑动。",
    ),
    "motion.redundant-joints": (
        "计算运动时未计入 {joints} 的冗余约束。该奇异位形只属于其余的约束：有 {joints} 时，机构可能可以通过此位置。",
        "使运动在此位置之前结束，或在 studies: cycle 中写 through: keep。",
    ),
    "motion.cannot-carry": (
        "在 t = {time} s（{drive} = {value} {unit}）时，杆组 {group} 处于奇异位形，运动无法通过该处继续：由邻近位姿不能确定其极限。",
        "使驱动平滑地通过该位置，不停顿且加速度不突变；载荷在该处也应平滑，不出现时间窗的端点或表的折点。或改变长度或驱动的范围，避开该位置。",
    ),
    "motion.starts-at-change-point": (
        "运动从杆组 {group} 的变点开始（t = {time} s，{drive} = {value} {unit}），该处两种装配模式重合。规则“{rules}”选定了运动继续时的装配模式。",
        "对照图样检查这是否为所需的运动，或从其他位姿开始。",
    ),
    "motion.unbounded-forces": (
        "在 t = {time} s（{drive} = {value} {unit}）时，杆组 {group} 位于变点，此时任一构件都不能带动另一构件转动，以下各力（矩）无限增大："
        "{signals}。它们在该时刻没有值。",
        "用其他方式传递载荷：与这两个曲柄不共线的第三个曲柄、飞轮或齿轮可使平行四边形机构通过变点。",
    ),
    "motion.near-change-point": (
        "在 t = {time} s（{drive} = {value} {unit}）时，杆组 {group} 的运动经过变点附近（行列式为 {determinant}）："
        "微小的长度误差或间隙就会决定运动以哪种装配模式继续。",
        "若所需的是平行四边形等机构，使各长度精确匹配（并写 through: keep）；否则使运动远离该位置。",
    ),
    "motion.unproven": (
        "验证未通过：{check}的相对误差为 {figure}（限值 1e-9）。",
        "检查是否存在数量级相差悬殊的尺寸、距离很远的点或接近奇异位形的位置；详情见报告中的“验证”部分。若均不存在，则为 linkwright 的缺陷，应连同模型一起报告。",
    ),
    "motion.unknown-value": (
        "验证未通过：在 t = {time}（{drive} = {value} {unit}）时，{signal} 不是有限值，因此无法检验：{checks}。",
        "检查计算该量所用的数值是否有单位或数量级错误；或使运动远离该位置。",
    ),
    "motion.unknown-between": (
        "验证未通过：在两个采样点之间有信号不是有限值，因此无法检验：{checks}。",
        "增加采样点数以找出该处；检查表、系数和载荷是否有未定义的值。",
    ),
    "motion.small-margin": (
        "在 t = {time} s（{drive} = {value} {unit}）时，杆组 {group} 接近奇异位形（裕度为 {margin}；1 为最佳，0 为奇异）："
        "此处的力很大，微小的长度误差会使构件产生很大的位移。",
        "使运动远离该位置，或更改各长度。",
    ),
    "motion.check-fails": (
        "验证未通过：{check}为 {figure}（要求：{required}）。",
        "检查是否存在数量级相差悬殊的尺寸或接近奇异位形的位置；详情见报告中的“验证”部分。若均不存在，则为 linkwright 的缺陷，应连同模型一起报告。",
    ),
    "motion.not-periodic": (
        "运动不是周期性的：经过 {period} 后，点 {element} 与其起始位置相距 {distance} {unit}。",
        "改正 period，或用 duration 代替 period。",
    ),
}
