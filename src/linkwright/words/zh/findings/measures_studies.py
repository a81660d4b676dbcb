"""Problems of windows, measures and studies."""

PROBLEMS: dict[str, tuple[str, str]] = {
    "window.one-signal": (
        "时间窗必须给出且只给出一个信号；已给出：{count} 个。",
        "写 {{SIGNAL: [low, high]}}，其中只含一个信号。",
    ),
    "window.signal": (
        "“{given}”不是 motor.angle 之类的信号。",
        "写 {{SIGNAL: [low, high]}}，例如 {{motor.angle: [0 deg, 90 deg]}}。",
    ),
    "window.outside": (
        "时间窗 {name} 位于分析时段之外。",
        "改正时间窗，或延长分析时段。",
    ),
    "measure.reduction": (
        "测量项必须给出且只给出信号的一种取值方式；已给出：{given}。",
        "在以下各项中只给出一项：{known}。",
    ),
    "measure.where": (
        "“value”必须与“where”同时使用，其他情况下不能使用“where”。",
        "同时写 value 和 where：{{value: crank.angle, where: max E.x}}。",
    ),
    "measure.within": (
        "“dwell”必须与“within”同时使用，其他情况下不能使用“within”。",
        "同时写 dwell 和 within：{{dwell: E.x, within: 0.5 mm}}。",
    ),
    "measure.useful": (
        "“useful”只能与“share”一起给出，且必须给出。",
        "将 share 和 useful 写在一起：{{share: [bearing_A], useful: [press]}}；求效率则写 {{efficiency: [press]}}。",
    ),
    "measure.bad-where": (
        "“{given}”不能确定一个时刻。",
        "写以下之一：max SIGNAL、min SIGNAL、SIGNAL = VALUE（例如 motor.angle = 24 deg）、start、end。",
    ),
    "measure.unit": (
        "该值的单位为 {wanted}，不能换算为 {unit}。",
        "使用与 {wanted} 量纲相同的单位，或删除单位。",
    ),
    "measure.table": (
        "表“{name}”不能用于测量项。",
        "表只用于驱动、载荷和弹簧；测量项用信号、t 和参数表示。",
    ),
    "measure.nothing": (
        "测量项 {name} 没有值：运动未进入其时间窗。",
        "改正时间窗，或延长分析时段。",
    ),
    "measure.not-finite": (
        "测量项 {name} 的值不是有限值。",
        "检查其表达式是否有除以零或负数开方。其他可能的原因：奇异位形，或瞬心位于无穷远处、因无相对运动而不存在。",
    ),
    "motion.too-many-turns": (
        "“{name}”在该分析时段内转过的圈数过多，无法连续跟踪其角度。",
        "缩短分析时段；若唯一的驱动为匀速转动，则没有此限制。",
    ),
    "motion.angle-too-large": (
        "“{name}”在该分析时段内达到 {turns} 圈；双精度数只能分辨 {limit} 圈以内的角度。",
        "检查其转速、规律或系数的单位和数量级；若无误，请缩短分析时段。",
    ),
    "measure.unbounded": (
        "测量项 {name} 无界：{signal} 在 t = {time} 附近无限增大。",
        "选用不含该时刻的时间窗，或分别测量分子和分母。",
    ),
    "measure.diverges": (
        "测量项 {name} 没有值：{signal} 的积分在 t = {time} 处发散。",
        "选用不含该时刻的时间窗。",
    ),
    "measure.undecided": (
        "{signal} 在 t = {time} 附近可能无界；因舍入误差无法判定，测量项 {name} 没有值。",
        "选用不含该时刻的时间窗，或改写表达式，减少相互抵消的项。",
    ),
    "measure.two-values": (
        "测量项 {name} 有两个值：{signal} 恰在取值时刻 t = {time} 发生突变。",
        "将取值时刻略微提前或推后。",
    ),
    "measure.no-instant": (
        "测量项 {name} 没有值：运动始终未到达“where”所定义的时刻。",
        "改正“where”或时间窗，或延长分析时段。",
    ),
    "measure.useless": (
        "测量项 {name} 没有值：有用载荷在该运行或时间窗内不做功，因此不存在效率。",
        "指定做有用功的载荷，或选用其做功的时间窗；若载荷在一周内所做的功相互抵消，应为其工作行程设置时间窗。",
    ),
    "measure.energy-from-others": (
        "测量项 {name} 没有值：未列为有用的其他载荷输入的能量多于损失的能量，因此驱动提供的能量不是全部输入。",
        "将这些载荷也列为有用载荷，或将驱动机构的载荷改为驱动。",
    ),
    "measure.unsettled": (
        "对 {name} 的搜索在最细的网格（{width}）上仍未收敛：末几位数字可能不准，或遗漏了窄峰。",
        "将该测量项限制在时间窗内，或缩短分析时段。",
    ),
    "study.unknown": (
        "没有名为“{name}”的分析。",
        "{near}",
    ),
    "study.missing": (
        "文件中没有 {name} 分析。已有的分析：{has}。",
        "将其添加到文件中，例如“studies: {{{name}: {example}}}”。",
    ),
    "study.options": (
        "分析 {study} 的选项 {key} 无效：{reason}。",
        "改正该选项；各分析的选项见 docs/file-format.md。",
    ),
    "study.choice": (
        "分析 {study} 的选项 {key} 不能为 {given}。",
        "{near}",
    ),
    "study.not-in-sweep": (
        "“{name}”不能用于 limits 分析：该分析使一个驱动以单位速度遍历其范围，不计算力。",
        "使用位置、角度、位移及其导数；力和时间用于 cycle 分析的测量项。",
    ),
    "study.cylinder-length": (
        "{drive} 不能达到其全部范围：在 {value} {unit} 处，缸 {name} 两铰链间的长度需为 {length} {length_unit}，比极限长度 {limit} "
        "{length_unit} {end} {by} {length_unit}。",
        "查看所得范围时应考虑这一点；可在 studies.limits.ranges 中设置较小的范围。",
    ),
    "study.wide-range": (
        "{drive} 的范围超过 {limit} {unit}。",
        "缩小范围。",
    ),
    "motion.more-gaps": (
        "还有更多的运动区间不能实现；此处只列出前 {count} 个。",
        "先修正第一个：其余各项通常是它在每一圈中的重复。",
    ),
    "study.long-motion": (
        "在 cycle 分析的运动中，{drive} 的运动量达 {travel} {unit}，而运动的极限位置、最大值和最小值只在 {limit} {unit} 以内搜索。"
        "各驱动单独运动的结果是完整的。",
        "减小 studies.cycle 的圈数或时长。",
    ),
}
