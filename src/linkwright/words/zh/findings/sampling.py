"""Problems of many parameter sets of one mechanism."""

PROBLEMS: dict[str, tuple[str, str]] = {
    "varied.slides": (
        "移动副 {loop} 的方向只在 {name} 取给定值时相容：取其他值时，它们所在的闭环不能装配。",
        "将各移动副的两条直线都用 {name} 表示，或不变动该参数。",
    ),
    "varied.passage": (
        "运动通过变点继续（through: keep），而 {names} 取其他值会使该变点移动。",
        "只有运动不经过变点时，才能变动其参数。",
    ),
    "varied.table": (
        "表 {table} 的 x 值或周期与变动的参数 {names} 有关。",
        "直接写出这些数值，或不变动相关参数；表中的 y 值可以变动。",
    ),
    "varied.second": (
        "运动规律 {law} 决定 {name} 的第二接触的位置，而其中的 {names} 是变动的；该位置只按名义值计算一次。",
        "在 second 中给出第二接触的位置，或不变动该运动规律。",
    ),
    "varied.locked": (
        "{where} 按文件中 {name} 的值确定，报告页面不重新计算。",
        "在文件中修改 {name}，然后重新运行。",
    ),
    "varied.drawn": (
        "{name} 还会改变 {joint} 的装配位置（轮齿的啮合位置、接触的起点），报告页面不重新计算该位置。",
        "在文件中修改 {name}，然后重新运行。",
    ),
    "varied.whole": (
        "{where} 是整数，滑块不能改变 {name}。",
        "在文件中修改 {name}，然后重新运行。",
    ),
    "varied.values": (
        "{samples} 个样本中有 {count} 个的取值在模型中无效；第一个为样本 {sample}：{what}",
        "缩小变动参数的范围，或将相关的尺寸定义为变动参数的表达式。",
    ),
    "varied.drive": (
        "{samples} 个样本中有 {count} 个，其 {drive} 的运动规律没有有限值；首个为样本 {sample}，发生在 t = {time} s 时。",
        "缩小其位置表达式中参数的范围，或修改运动规律。",
    ),
    "varied.cannot-assemble": (
        "{samples} 个样本中有 {count} 个不能装配；第一个为样本 {sample}：在 t = {time} s 时，{links} 的 {joints} 相距 "
        "{distance} {unit}，{short}。",
        "缩小变动长度的范围，或只使用其余样本。",
    ),
    "varied.stuck": (
        "{samples} 个样本中有 {count} 个的运动无法跟踪；第一个为样本 {sample}，杆组 {group} 无法跟踪到 t = {time} s："
        "从名义尺寸变到该样本的尺寸时，它经过奇异位形。",
        "缩小变动参数的范围，或只使用其余样本。",
    ),
    "accuracy.position": (
        "“{text}”不能确定一个位置。",
        "写“max E.x”或“min E.x”（信号），“start of W”或“end of W”（时间窗），或一个时间。",
    ),
    "accuracy.no-derivative": (
        "取值方式 {reduction} 没有导数，公差无法传递到测量项 {name}。",
        "在该分析中指定其他输出。",
    ),
    "accuracy.outside-run": (
        "位置“{text}”不在 0 至 {stop} {unit} 的分析时段内。",
        "给出分析时段内的时间。",
    ),
    "accuracy.correlation-limit": (
        "{names} 的偏差的相关系数不可能为 {stated}：二者的分布不同，其极限为 {limit}。",
        "减小相关系数，或使二者的分布相同。",
    ),
    "accuracy.correlation-adjusted": (
        "在这些分布下，所给的相关系数不能同时成立；样本采用与之最接近的可行值（正态得分的相关系数最多改变 {change}）。",
        "减小相关系数，或采用正态分布。",
    ),
    "accuracy.samples-fail": (
        "公差范围内的 {samples} 个随机样本中，有 {count} 个至少缺少一项输出的数值：{share} %（全部产品的 95 % 置信区间为 "
        "{low} 至 {high} %）。每项输出的结果只使用有该数值的样本。",
        "收紧公差，或修改尺寸，使机构在公差范围内的任意尺寸下都能装配。",
    ),
    "accuracy.points-fail": (
        "公差范围内的 {samples} 个样本中，有 {count} 个至少缺少一项输出的数值：{share} %。每项输出的结果只使用有该数值的样本。",
        "收紧公差，或修改尺寸，使机构在公差范围内的任意尺寸下都能装配。若需要该比例的置信区间，采用采样方案 random 或 latin。",
    ),
    "accuracy.law": (
        "若只有 {names} 存在偏差，运动规律 {law} 的各段之和不再等于其周期，或不再首尾相接，或不再连续。",
        "使运动规律中的其他数值随之变化：例如除 {{rise: h, over: w}} 外，写 {{dwell: 360 deg - w}}，且回程采用相同的 h。",
    ),
    "accuracy.table": (
        "若只有 {names} 存在偏差，表 {table} 在一个周期内不再首尾相接。",
        "将首末两点的值写成同一表达式。",
    ),
    "accuracy.vertices-fail": (
        "在极值的搜索中，公差范围内的 {looked} 个点有 {lost} 个不能装配或跟踪：所得极值只覆盖可以装配和跟踪的点。",
        "收紧公差，或修改尺寸，使机构在公差范围内的任意尺寸下都能装配。",
    ),
}
