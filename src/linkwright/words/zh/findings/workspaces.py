"""Problems of workspaces, their maps and trajectories."""

PROBLEMS: dict[str, tuple[str, str]] = {
    "workspace.drives": (
        "workspace 分析需要两个驱动（只有一个时，结果为曲线）；该机构有 {count} 个：{names}。",
        "将构件相互固定，使机构只剩两个驱动；或为机构添加一个驱动。",
    ),
    "workspace.cluster": (
        "workspace 分析只支持由二级杆组构成的机构；该机构含有须用牛顿法求解的杆组：{groups}。",
        "改用由二级杆组构成的机构；limits 分析可使该机构的一个驱动单独运动。",
    ),
    "workspace.fixed-point": (
        "工作点 {name} 在机架上，不能运动。",
        "{near}工作点必须属于活动构件。",
    ),
    "workspace.no-values": (
        "{name} 没有给出值。",
        "至少给出一个值，例如 [0, 60, 90]；或删除该参数。",
    ),
    "workspace.no-range": (
        "{drive} 是直线驱动，但未给出其范围。",
        "给出其范围，例如 drives: {{{drive}: [0 {unit}, 100 {unit}]}}；若为缸，也可给出缸的长度。",
    ),
    "workspace.too-many": (
        "将有 {count} 个区域，超过上限 {limit}。",
        "减少取值，或写 modes: own。",
    ),
    "workspace.unbounded": (
        "点 {name} 的区域无界：在 {at} 附近，两条导轨相互平行。",
        "将驱动限制在两条导轨不平行的范围内。",
    ),
    "workspace.pins-meet": (
        "在 {at} 处，某个杆组的外接铰链重合，该处是驱动范围的端点，或属于由此类驱动值构成的一整条曲线；此时该杆组的构件可取任意方向，区域在该处被分割。",
        "使驱动的范围避开这些值；或使该杆组各构件的长度略有不同。",
    ),
    "workspace.incomplete": (
        "区域（模式：{mode}）不完整：{share} % 的随机样本位于区域之外。",
        "改变 chord 的值，或只取驱动范围的一部分；所得面积只是下界。",
    ),
    "workspace.doubt-area": (
        "面积（模式：{mode}）未通过验证：所绘区域的面积超出由全部位姿的区间包络所证明的上下界 {size}。",
        "减小 chord 的值，或只取驱动范围的一部分。图形在 {at} 附近不可靠。",
    ),
    "workspace.doubt-open": (
        "面积（模式：{mode}）未通过验证：其中 {size} 无法判定，超过百分之一，大部分位于 {at} 附近。",
        "区域在该处很窄，或其边界几乎相接。面积只取上下界一致的各位数字。",
    ),
    "workspace.doubt-left-out": (
        "区域（模式：{mode}）未通过验证：有 {size} 确定可达的面积位于区域之外，其中一部分在 {at} 附近。",
        "改变 chord 的值，或只取驱动范围的一部分；面积只以其上下界为准。",
    ),
    "workspace.doubt-too-much": (
        "区域（模式：{mode}）未通过验证：其中有 {size} 确定不可达，一部分在 {at} 附近。",
        "改变 chord 的值，或只取驱动范围的一部分；面积只以其上下界为准。",
    ),
    "workspace.doubt-edge": (
        "边界（模式：{mode}）未通过验证：在 {size} 个边界顶点处（其中一个在 {at}），边界穿过确定位于区域内部或外部的点。",
        "改变 chord 的值，或只取驱动范围的一部分；面积只以其上下界为准。",
    ),
    "workspace.doubt-count": (
        "图形（模式：{mode}）未通过验证：有 {size} 的曲线（一部分在 {at} 附近），其两侧位姿数的变化不符合要求。",
        "该处的曲线可能缺失或有误：面积及其上下界不受影响，但图形和保证可达区域可能受影响。改变 chord 的值，或只取驱动范围的一部分。",
    ),
    "workspace.doubt-back": (
        "区域（模式：{mode}）未通过验证：{size} 的检验位置（其中一个在 {at}）不能由其驱动值复现。",
        "这是 linkwright 的缺陷，应连同文件一起报告。",
    ),
    "workspace.doubt-unsettled": (
        "区域（模式：{mode}）未通过验证：最后一次细化网格时，其面积仍变化了 {size}。",
        "只取驱动范围的一部分，以便在该范围内使网格更细。",
    ),
    "workspace.doubt-cut": (
        "区域（模式：{mode}）未通过验证：在 {at} 附近，有 {size} 的曲线两侧属于同一个面。",
        "该处可能缺失曲线。改变 chord 的值，或只取驱动范围的一部分。",
    ),
    "workspace.doubt-dangle": (
        "区域（模式：{mode}）未通过验证：在 {at} 附近，有 {size} 的曲线端点未与其他曲线相接。",
        "该处可能缺失曲线。改变 chord 的值，或只取驱动范围的一部分。",
    ),
    "workspace.doubt-ring": (
        "区域（模式：{mode}）未通过验证：在 {at} 附近，有 {size} 的曲线自相交。",
        "改变 chord 的值，或只取驱动范围的一部分。",
    ),
    "workspace.doubt-rough": (
        "区域（模式：{mode}）未通过验证，也未绘制：有 {size} 段曲线无法跟踪，其中一段在 {at} 附近。",
        "某个杆组的两个运动副在该处可能有许多位置重合，使其构件可取任意方向。略微改变一个长度，或只取驱动范围的一部分。",
    ),
    "workspace.doubt-nowhere": (
        "区域（模式：{mode}）未通过验证：在 {at} 附近，有 {size} 段曲线无法定位。",
        "改变 chord 的值，或只取驱动范围的一部分。",
    ),
    "workspace.stopped": (
        "已中断：共 {total} 个区域，已完成 {done} 个。已完成的区域予以保留，但可能缺少其他要求的结果。",
        "再次运行该分析。使用同一结果文件夹时，分析将继续进行，已完成的区域不再计算。",
    ),
    "workspace.part-damaged": (
        "文件 {file} 保存着已中断分析的一个区域，但已损坏或无法读取；该区域已重新计算。",
        "无需修改。若再次出现，检查磁盘。",
    ),
    "workspace.no-area": (
        "点 {name} 只沿曲线运动或不运动，没有区域{values}。",
        "改用由两个驱动共同带动的点，或扩大驱动的范围。",
    ),
    "workspace.never-closes": (
        "各构件在任何位姿都不能装配{values}：最接近可装配时为 {at}，此时 {links} 的 {joints} 相距 {distance} {unit}，{short}。",
        "{lengths}；或扩大驱动的范围。",
    ),
    "workspace.two-drives": (
        "{section} 需要两个驱动；只有一个驱动时，点沿曲线运动。",
        "删除 {section}，或为机构添加一个驱动。",
    ),
    "workspace.map-name": (
        "此处没有名为“{name}”的分布图。",
        "改用以下之一：{known}。",
    ),
    "workspace.map-task": (
        "分布图“{name}”需要 {key}。",
        "添加 {key}，或改用其他分布图。",
    ),
    "workspace.limit-missing": (
        "{key} 中缺少 {drives} 的值。",
        "为两个驱动分别给出一个值。",
    ),
    "workspace.limit-positive": (
        "{what}不是正数：{given}。",
        "给出正值，或将其删除。",
    ),
    "workspace.hold-steps": (
        "轨迹的步数和步长只能给出其中之一，但二者均已给出。",
        "写 steps，例如 steps: 36；或写 every，例如 every: 10 deg。",
    ),
    "workspace.hold-many": (
        "{drive} 的范围内有 {count} 个这样的步长；最多计算 {limit} 条轨迹。",
        "增大 every 的步长。",
    ),
}
