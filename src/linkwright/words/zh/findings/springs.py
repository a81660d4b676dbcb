"""Problems of springs."""

PROBLEMS: dict[str, tuple[str, str]] = {
    "spring.ends": (
        "弹簧的两端定义不明确。",
        "给出 from 和 to（两个点）；扭簧给出 turns 和 on（两个构件）。",
    ),
    "spring.law": (
        "弹簧必须给出且只给出一种力学特性（可另加阻尼）；已给出：{given}。",
        "在 stiffness、force（扭簧为 torque）和 gas 中只给出一项，或只给出 damping。",
    ),
    "spring.stray": (
        "此类弹簧不能使用这些键：{keys}。",
        "将其删除；可搭配使用的键见 docs/file-format.md。",
    ),
    "spring.free": (
        "缺少弹簧的自由长度。",
        "添加 free，即弹簧的力等于预紧力（无预紧力时为零）时的长度；扭簧为角度。",
    ),
    "spring.gas": (
        "仅有最大长度时的力不能确定气弹簧：缺少力随压缩增大的比率。",
        "添加 progression（最小长度时的力与最大长度时的力之比）和 length: [最小长度, 最大长度]。",
    ),
    "spring.progression": (
        "气弹簧的 progression 必须大于 1：压缩时其力增大。",
        "给出最小长度时的力与最大长度时的力之比，通常为 1.2 至 1.5。",
    ),
    "spring.same-link": (
        "弹簧两端都在构件 {name} 上，弹簧不起作用。",
        "将一端改到其他点或构件上；若多个构件共用一个点，在 in: [LINK, LINK] 中给出构件。",
    ),
    "spring.no-direction": (
        "在 t = {time} s（{drive} = {value} {unit}）时，弹簧两端重合，其力的方向无法确定。",
        "移动其中一个端点。",
    ),
    "spring.outside-length": (
        "在 t = {time} s（{drive} = {value} {unit}）时，弹簧长度为 {length} {of}；允许范围为 {low} 至 {high} {of}。",
        "改用其他行程的弹簧，或移动其端点。超出该范围时，弹簧特性按外推计算。",
    ),
}
