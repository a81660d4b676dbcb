"""Problems of sweeps."""

PROBLEMS: dict[str, tuple[str, str]] = {
    "study.needs-cycle": (
        "{study} 分析使用文件中 cycle 分析的运动，但文件中没有 cycle。",
        "在与其同级的位置添加，例如 cycle: {{turns: 1 motor, samples: 360}}。",
    ),
    "study.one-value": (
        "只有 {count} 个值，参数没有变化。",
        "至少给出两个值；不变动的参数不列出。",
    ),
    "study.sigma": (
        "标准差 {sigma} 不是正数。",
        "给出正值，单位与参数相同。",
    ),
    "study.cut-distribution": (
        "分布的截断范围内所含的概率小于 {share:g}。",
        "扩大 low 至 high 的范围，或移动均值。",
    ),
    "study.triangle": (
        "三角分布的下限、最可能值和上限必须递增：{values}。",
        "按此顺序给出；最可能值可以等于上限或下限。",
    ),
    "study.plan": (
        "{name} 按分布变动，而采样方案 {plan} 不支持分布。",
        "改为等分点或列表，或改用其他采样方案：latin、sobol、random。",
    ),
    "study.grid-samples": (
        "采样方案 {plan} 计算所有组合，不能设置样本数。",
        "删除 samples，或改用其他采样方案：latin、sobol、random。",
    ),
    "study.too-many-samples": (
        "样本数为 {count}，超过采样方案 {plan} 的上限 {limit}。",
        "减少取值或样本；对于分布，采样方案 random 允许的样本数最多。",
    ),
    "study.no-output": (
        "“{text}”既不是文件中的测量项，也不是信号的表达式。",
        "{near}输出可以是测量项、信号（例如 E.x）或信号的表达式。",
    ),
    "study.no-outputs": (
        "参数扫描没有输出：文件中没有测量项。",
        "添加测量项，或在 outputs 中列出信号。",
    ),
    "study.varied-span": (
        "分析时段的长度与 {name} 有关，而该参数在各样本中取值不同。",
        "以常数给出时长，例如 cycle: {{duration: 1.5 s}}；或不变动该参数。",
    ),
    "study.no-folder": (
        "需要在内存中保存的数值超过 {limit} 个。",
        "用 --out 或“out=...”给出保存数值的文件夹；或设置 keep: reduced。",
    ),
    "study.too-many-values": (
        "该分析需要保存 {rows} 行、每行 {columns} 个数值，约需 {needed} GB 内存；最多使用 {allowed} GB，即可用内存的 1/{share}。",
        "将 {key} 设为不超过 {most}；或在内存更大的计算机上运行。",
    ),
    "study.no-value": (
        "{samples} 个样本中有 {count} 个，其运动可以跟踪，但某个测量项或信号没有有限值；第一个为样本 {sample}。",
        "检查是否有奇异位形、凸轮卡死从动件、除以零，或运动未进入时间窗；或缩小参数的范围。",
    ),
    "study.never-a-value": (
        "{samples} 个样本的运动都可以跟踪，但每个样本都有某个测量项或信号没有有限值。",
        "先在名义值下检查各测量项：是否有奇异位形、凸轮卡死从动件、除以零，或运动未进入时间窗。",
    ),
    "study.alone": (
        "{study} 分析用于没有驱动的结构，而 {name} 需要运动。",
        "将 {name} 移到另一个带驱动的文件中。",
    ),
    "reactions.drives": (
        "机构由 {names} 驱动，而 reactions 分析用于没有驱动的结构。",
        "若需求解运动中的力，写 studies: {{cycle: ...}}；否则删除驱动。",
    ),
    "reactions.time": (
        "时间“{text}”既不是零，也不是正数。",
        "给出一个时间，例如 at: 0.5 s。",
    ),
    "reactions.several-poses": (
        "各构件至少有 {count} 种装配模式，但未选择其中一种。",
        "在 sketch 中给出点的位置，或在 assembly 中指定所在的一侧。",
    ),
    "reactions.not-closed": (
        "结构的运动副不能同时封闭：在所找到的最佳位姿下，封闭误差为 {miss} {unit}。",
        "改正长度，或在 sketch 中给出点的位置。",
    ),
    "reactions.phased": (
        "各构件只能联立求解装配，此时无法得知 {name}（{kind}）应按草图位姿保持的相对位置。",
        "在 sketch 或 assembly 中给出点的位置，使各构件可以依次装配。",
    ),
    "reactions.not-finite": (
        "{links} 上的载荷没有有限值。",
        "检查表的取值是否超出其范围，或是否除以零；载荷所取的时刻由选项 at 设置。",
    ),
    "reactions.moves": (
        "结构不平衡：其运动副允许 {links} 运动，且载荷在该运动上做功。",
        "添加约束这些构件的支座或杆，或改正尺寸。",
    ),
    "reactions.indeterminate": (
        "结构为 {degree} 次静不定：{joints} 的约束反力取决于各部分的刚度，在此没有值。",
        "无需修改。若需要全部约束反力，给出各运动副的刚度（stiffness），或放松支座（例如使一端可以滑动），直至结构静定。",
    ),
    "reactions.shared": (
        "结构为 {degree} 次静不定。{sharing}",
        "无需修改。",
    ),
    "reactions.neutral": (
        "运动副允许 {motions} 种独立的运动，载荷在这些运动上不做功：结构仅在当前载荷下平衡。",
        "若还须承受其他载荷，添加支座或杆。",
    ),
    "reactions.no-load": (
        "结构上没有载荷，所有约束反力均为零。",
        "添加载荷、弹簧，或重力和质量。",
    ),
    "reactions.unproven": (
        "验证未通过：相对封闭误差或平衡残差为 {residual}（限值 1e-9）。",
        "检查是否有接近共线的构件：在该处，微小的长度误差会引起很大的力。",
    ),
    "reactions.measures": (
        "reactions 分析不计算测量项：{names}。",
        "在其结果表中查看约束反力，或删除测量项。",
    ),
    "study.none": (
        "文件中没有分析。",
        "添加分析，例如 studies: {{cycle: {{period: 1.5 s, samples: 200}}}}。",
    ),
}
