"""Problems of tolerances from targets and dimensions from measurements."""

PROBLEMS: dict[str, tuple[str, str]] = {
    "accuracy.cost": (
        "成本函数 {law} 的系数无效：{given}。",
        "给出有限的数值：若有多个系数，第一个可以为 0，其余必须为正；表中的成本可以为 0。",
    ),
    "accuracy.no-contributor": (
        "{name} 不是本分析的误差源：不能为其分配公差，也不能估计其偏差。",
        "{near}否则为该参数给出公差（或用 general 给出一般公差），并将其列入 parameters。",
    ),
    "accuracy.no-target": (
        "“{name}”不是本分析的结果。",
        "{near}信号在某一位置的输出写作“E.x at POSITION”。",
    ),
    "accuracy.target": (
        "目标半宽 {text} 不是正数，或过大。",
        "给出单侧允许的偏差，例如 0.5。",
    ),
    "accuracy.half-widths": (
        "公差带半宽必须为正且递增：{low}，{high}。",
        "给出 between: [最小值, 最大值]，单位与参数相同。",
    ),
    "accuracy.no-grade": (
        "ISO 286 中没有适用于 {name} 的 {grades} 半宽：其标准公差等级只适用于不超过 3150 mm 的长度。",
        "给出以 {unit} 为单位的半宽表：table: [[半宽, 成本], ...]；或写 grades: false。",
    ),
    "accuracy.no-grade-between": (
        "{name} 在 {low} 与 {high} {unit} 之间没有标准公差等级。",
        "扩大 between 的范围，或写 grades: false。",
    ),
    "accuracy.target-unreachable": (
        "{name} 不能保持在 ±{wanted} {unit} 以内：取允许的最小公差时为 ±{best} {unit}。",
        "允许更小的半宽（between），为更多参数给出成本函数，或收紧没有成本函数的参数的公差。",
    ),
    "accuracy.targets-loose": (
        "取允许的最大公差即可满足全部目标，目标不起作用。",
        "收紧目标，或允许更大的半宽（between）。",
    ),
    "accuracy.no-choice": (
        "连续取值的半宽可以满足目标，但没有任何标准公差等级或工艺的组合能满足。",
        "允许更高的精度：扩大 between 的范围，或在表中增加工艺。",
    ),
    "accuracy.not-optimal": (
        "未能求得成本最低的公差：最优性条件的残差为成本的 {off} 倍。",
        "缩小半宽的范围（between），或缩放成本和目标，使其数量级相近。",
    ),
    "accuracy.measured-source": (
        "测量数据必须由文件或 points 之一给出。",
        "写 file: measured.csv，或 points: [{{t: 0.1 s, E.x: 712.3}}, ...]。",
    ),
    "accuracy.no-place": (
        "没有给出输出测量位置的列；现有的列：{given}。",
        "添加以下之一，或用 at 指定：{known}。",
    ),
    "accuracy.measured-unit": (
        "单位 {unit} 不适用于 {name}。",
        "使用 {usual} 之类的单位。",
    ),
    "accuracy.measured-number": (
        "测量数据第 {row} 行中，{name} 不是数值。",
        "写数值，小数点用“.”；只有输出的单元格可以为空。",
    ),
    "accuracy.nothing-measured": (
        "没有测量的输出。",
        "每个输出添加一列，每个位置添加一行。",
    ),
    "accuracy.empty-column": (
        "{name} 列没有数值。",
        "填写数值，或删除该列。",
    ),
    "accuracy.no-pose": (
        "第 {row} 行在 {name} = {value} {unit} 处测量，而运动未到达该处。",
        "改正该行，或修改 studies.cycle，使运动经过该处。",
    ),
    "accuracy.several-poses": (
        "第 {row} 行的测量位置不唯一：{name} 多次取该值，且位姿不同，分别在 {times}。",
        "改为给出各行的时间 t，或将 studies.cycle 限制为单向运动。",
    ),
    "accuracy.sigma": (
        "测量的标准差 {sigma} 不是正数。",
        "给出正值，单位与输出相同；或将其删除，由残差估计。",
    ),
    "accuracy.not-measured": (
        "{name} 没有测量数据；有测量数据的输出：{known}。",
        "只为有测量数据的输出给出 sigma。",
    ),
    "accuracy.few-measurements": (
        "有 {count} 个测量值和 {parameters} 个待估计的偏差；至少需要 {least} 个测量值。",
        "在更多位置测量，减少 parameters 中所列的偏差，给出 sigma，或写 prior: true。",
    ),
    "accuracy.sigma-open": (
        "{name} 的测量值不足以同时估计其标准差。",
        "在 sigma 中给出标准差，或在更多位置测量。",
    ),
    "accuracy.measured-without-value": (
        "在名义运动的某个测量位置，某个输出没有有限的值或导数。",
        "删除死点等奇异位形附近的行。",
    ),
    "accuracy.scale-open": (
        "由测量数据不能辨识机构的尺寸比例：{names} 可以同时按同一比例增大或减小。",
        "再测量一个长度，或从 parameters 中删除其中之一；此时只能估计它们的比值。",
    ),
    "accuracy.not-identifiable": (
        "{names} 不能分别辨识：它们的偏差在所有测量的输出中可以相互抵消。",
        "测量其他输出或在其他位置测量，或从 parameters 中删除其中之一。",
    ),
    "accuracy.no-effect": (
        "{name} 不可辨识：它对测量的输出没有影响，或影响过小。",
        "测量其他输出或在其他位置测量，或将其从 parameters 中删除。",
    ),
    "accuracy.poor-fit": (
        "残差超出所给 sigma 能够解释的程度：卡方值为其自由度的 {ratio} 倍，偶然出现这种情况的概率为 {share}。",
        "检查是否有异常值，或是否有偏差未列入 parameters；或增大 sigma。",
    ),
    "accuracy.outliers": (
        "有 {count} 个测量值的残差超出随机误差能够解释的程度；所在行：{rows}。",
        "检查这些行，并删除有误的行。",
    ),
    "accuracy.not-settled": (
        "估计尚未收敛：再迭代一步，估计值的变化为公差标准差的 {step} 倍。",
        "在更多位置测量，或减少 parameters 中所列的偏差。",
    ),
}
