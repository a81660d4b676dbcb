"""Problems of motion laws."""

PROBLEMS: dict[str, tuple[str, str]] = {
    "law.unknown": (
        "没有名为“{name}”的运动规律。",
        "{near}也可用 fractions、powers 或 formula 代替 law。",
    ),
    "law.segment": (
        "区段的类型不明确；已给出：{given}。",
        "在 {known} 中只给出一项。",
    ),
    "law.keys": (
        "该类区段（{head}）中不能使用 {given}。",
        "将其删除，或放入单独的区段。",
    ),
    "law.no-over": (
        "缺少区段沿自变量轴的长度。",
        "添加 over，例如 over: 90 deg。",
    ),
    "law.way": (
        "区段的曲线形式必须且只能定义一次；已给出：{given}。",
        "在 {known} 中只给出一项；match、from、to、via 和 spline 可以组合使用。",
    ),
    "law.argument-taken": (
        "在公式中，{name} 在区段内由 0 变到 1，但有一个参数也名为 {name}。",
        "修改参数名。",
    ),
    "law.formula": (
        "运动规律的公式中不能使用“{name}”。",
        "使用 u（在区段内由 0 变到 1）、参数和函数。",
    ),
    "law.place": (
        "在驱动的 position 以外调用了运动规律“{name}”。",
        "在驱动的 position 或凸轮分析的载荷中调用；在模型的测量项和载荷中，改用驱动的值。",
    ),
    "law.over": (
        "区段沿自变量轴的长度不是正数，或超出范围。",
        "将长度设为 1e-12 至 1e12 s 或 rad。",
    ),
    "law.via": (
        "via 中的各点必须按递增顺序排列且互不重合，并位于区段起点与终点之间。",
        "将其排序；各点位置从区段起点量起。",
    ),
    "law.conditions": (
        "一个多项式需要满足 {count} 个条件，上限为 {limit} 个。",
        "减少点数，添加 spline: quintic，或将区段拆分。",
    ),
    "law.end-rates": (
        "{degree} 次样条的每一端需要 {wanted} 个导数。",
        "在 from 和 to 中给出相应个数，或使 match: velocity 与 spline: cubic、match: acceleration 与 spline: quintic 配合使用。",
    ),
    "law.not-normal": (
        "公式在 u = 0 处为 {start}，在 u = 1 处为 {end}；应分别为 0 和 1。",
        "减去其在 u = 0 处的值，再除以总增量。",
    ),
    "law.not-smooth": (
        "公式或其一阶、二阶导数在 u = 0 与 u = 1 之间某处不是有限值。",
        "检查是否有除以零，或在零点处开方。",
    ),
    "law.powers": (
        "有一个幂次重复给出。",
        "每个幂次只给出一次。",
    ),
    "law.fractions": (
        "{count} 个 fractions 之和为 {sum}；运动规律需要四个 [b, c, d, z] 或七个，每个为 0 或不小于 1e-6，总和为 1，且前后两侧都有加速度不为零的部分。",
        "改正这些数值：[0.25, 0, 0.75, 0] 为修正正弦规律。",
    ),
    "law.skew": (
        "该运动规律的最大速度不能位于区段的 {share} 处。",
        "skew 取 0.001 至 0.999，且只能用于对称的运动规律。",
    ),
    "law.control": (
        "B 样条有 {given} 个控制值；按其次数至少需要 {wanted} 个。",
        "增加控制值，或降低次数。",
    ),
    "law.period": (
        "各区段之和为 {sum} {unit}，而周期为 {period} {unit}。",
        "改正区段长度，添加休止段，或给出周期。",
    ),
    "law.not-closed": (
        "运动规律始于 {start} {unit}，终于 {end} {unit}，因此不能循环重复。",
        "使各区段最终回到起点，或写 beyond: advance（从终点处继续）或 beyond: hold（停留在终点）。",
    ),
    "law.values": (
        "取这些值时 {law} 无效：某段没有长度、各段与周期不符、不回到起点，或其数值或速度有跳变。",
        "请同时修改相关的数值，或用这些值运行文件以查看具体位置。",
    ),
    "law.open-end": (
        "区段{side}处的导数取自区段 {other}，而该区段也未给出导数。",
        "在二者之一中用 from 或 to 给出。",
    ),
    "law.end-acceleration": (
        "运动规律 {law} 终点的加速度不为零，而相邻区段没有以相同的加速度继续。",
        "紧接其后添加它的镜像，即采用相同规律、高度和长度的回程；或改用终点加速度为零的运动规律。",
    ),
    "drive.law-jumps": (
        "运动规律 {law} 的{what}在 {at} 处突变 {jump}；任何驱动都无法实现。",
        "在该处改用其他运动规律，或采用与相邻区段速度衔接的过渡：{{rise: ..., over: ..., match: acceleration}}。",
    ),
}
