"""Problems of tolerances."""

PROBLEMS: dict[str, tuple[str, str]] = {
    "tolerance.unknown-class": (
        "“{given}”既不是公差等级，也不是文件中的参数。",
        "写数值、[下偏差, 上偏差] 或公差等级，例如 {known}。",
    ),
    "tolerance.class-or-parameter": (
        "{name} 既是公差等级，又是文件中的参数。",
        "将该参数改名；若指该参数，写“({name})”。",
    ),
    "tolerance.distribution": (
        "“{given}”不是公差的分布类型。",
        "改用以下之一：{known}。",
    ),
    "tolerance.cp-and-sigma": (
        "cp 和 sigma 均已给出，而二者都确定分布的宽度。",
        "只保留其中一项。",
    ),
    "tolerance.no-sigma": (
        "{name} 分布的宽度由极限偏差确定，不能使用 cp 和 sigma。",
        "将其删除，或写 distribution: normal 或 truncated。",
    ),
    "tolerance.cp": (
        "过程能力指数 cp = {cp} 不是正数。",
        "给出正数；cp 为 1 表示上、下极限偏差相距六倍标准差。",
    ),
    "tolerance.limits": (
        "{given} 不构成公差：下偏差必须小于上偏差。",
        "给出一个正数（对称公差 ±），或 [下偏差, 上偏差]；若偏差为定值，直接修改参数的值。",
    ),
    "tolerance.too-large": (
        "公差达到 {limit} {unit}，必须小于尺寸本身（{nominal} {unit}）。",
        "改正公差或其单位。可能为零的坐标，其值写为零。",
    ),
    "tolerance.derived": (
        "{name} 由其他参数计算得到（{text}），不能单独给出公差。",
        "为这些参数给出公差，或在表达式中加上一个误差参数，例如 {name}_error: 0。",
    ),
    "tolerance.size": (
        "{given} 中没有 {asked} {unit} 的公差：其范围为 {low} 至 {high} {unit}。",
        "改用其他等级，或直接给出极限偏差。",
    ),
    "tolerance.side": (
        "{given} 按短边长度确定角度公差，但未给出短边长度。",
        "与公差一起给出，例如 side: 60 mm；或以数值给出极限偏差。",
    ),
    "tolerance.class-dimension": (
        "{given} 只规定长度公差（一般公差等级还包括角度公差），而 {name} 不属于此类。",
        "以数值或 [下偏差, 上偏差] 的形式给出。",
    ),
    "tolerance.missing": (
        "{name} 被列为偏差，但没有公差，也没有适用于它的一般公差。",
        "在 parameters 中为其给出公差；或写 general: ISO 2768-m，该等级适用于长度以及给出短边长度（side）的角度。",
    ),
    "tolerance.named-twice": (
        "{name} 重复列出。",
        "每个参数只列一次。",
    ),
    "tolerance.none": (
        "未定义公差，也没有温度变化。",
        "在 parameters 中定义尺寸并给出公差，例如 AB: {{value: 155, tolerance: 0.05}}；或写 general: ISO 2768-m。",
    ),
    "tolerance.skipped": (
        "{general} 未规定 {names} 的公差（尺寸超出其范围），按无偏差处理。",
        "若存在偏差，单独给出公差。",
    ),
    "tolerance.no-derivative": (
        "{text} 在名义尺寸处没有导数，无法计算偏差的传递。",
        "将其改写为其他形式，或以数值给出该参数。",
    ),
    "tolerance.no-contributor": (
        "没有名为 {name} 的偏差。",
        "{near}改用带公差的参数或温度变化。",
    ),
    "tolerance.correlation-twice": (
        "{name} 在同一相关条目中重复列出。",
        "每个偏差只列一次；偏差与其自身的相关系数恒为 1。",
    ),
    "tolerance.correlation-pair": (
        "{names} 的相关系数已在前面的条目中给出。",
        "每对偏差只给出一次。",
    ),
    "tolerance.correlation-shape": (
        "{count} 个名称的相关系数矩阵应有 {count} 行，每行 {count} 个数。",
        "全部给出，包括对角线元素；或给出一个适用于各对的数值。",
    ),
    "tolerance.correlation-range": (
        "相关系数 {value} 超出 -1 至 1 的范围。",
        "在该范围内取值。",
    ),
    "tolerance.correlation-diagonal": (
        "相关系数矩阵的对角线元素必须为 1。",
        "将其写为 1：偏差与其自身的相关系数恒为 1。",
    ),
    "tolerance.correlation-symmetry": (
        "相关系数矩阵不对称。",
        "使每对偏差在两个对称位置上的系数相同。",
    ),
    "tolerance.correlation-indefinite": (
        "这组相关系数不可能成立：相关系数矩阵有特征值 {least}，而其特征值均不得为负。",
        "改正系数：若两个偏差都与第三个偏差密切相关，则二者彼此也相关。未给出的各对按 0 计。",
    ),
    "tolerance.material-or-expansion": (
        "温度变化必须在材料和线膨胀系数中给出且只给出一项。",
        "写 material: steel；或写 expansion: 11.5，单位为 1e-6/K。",
    ),
    "tolerance.material": (
        "“{given}”的线膨胀系数未知。",
        "{near}否则用 expansion 给出系数，单位为 1e-6/K。",
    ),
    "tolerance.thermal-name": (
        "该温度变化与某个参数同名。",
        "将二者之一改名。",
    ),
    "tolerance.no-length": (
        "没有可膨胀的量：文件中没有独立的（不由其他参数计算的）长度参数。",
        "在 parameters 中定义长度。",
    ),
    "tolerance.not-a-length": (
        "{name} 不是长度，不发生热膨胀。",
        "只列出长度。",
    ),
}
