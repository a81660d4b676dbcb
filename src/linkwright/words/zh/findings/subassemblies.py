"""Problems of sub-assemblies and their copies."""

PROBLEMS: dict[str, tuple[str, str]] = {
    "subassembly.unused": (
        "子装配 {name} 没有副本，因此其内容既未检查，也未计算。",
        "在 copies 中放置一个副本：{{{name}_1: {{of: {name}}}}}；或删除该子装配。",
    ),
    "subassembly.circular": (
        "子装配 {name} 包含了自身：{circle}。",
        "删除其中一个副本。",
    ),
    "subassembly.sketch": (
        "子装配 {name} 的草图有三个坐标。",
        "改为机构平面内的位置 [x, y]。车辆坐标系中的草图只能用于整个文件。",
    ),
    "subassembly.port-twice": (
        "接口 {name} 重复列出。",
        "每个接口只列一次。",
    ),
    "subassembly.port-own": (
        "{name} 是接口，但子装配自身又定义了同名元素。",
        "将二者之一改名。接口是每个副本在 join 中给定的点、构件或其他元素。",
    ),
    "subassembly.port-unused": (
        "子装配中没有任何元素用到接口 {name}。",
        "将其用作构件上的点或元素的名称，或从 ports 中删除。",
    ),
    "subassembly.port-given": (
        "构件 {link} 上的点 {point} 是接口，其位置由副本所连接的点决定。",
        "在此处删除该点；或从 ports 中删除它，使每个副本有自己的点。",
    ),
    "subassembly.mass": (
        "构件 {name} 不属于子装配自身：副本只在其上添加点。",
        "在定义该构件的位置给出质量，或在其上添加配重。",
    ),
    "subassembly.no-port": (
        "“{name}”不是子装配 {of} 的接口。",
        "{near}否则将其加入该子装配的 ports。",
    ),
    "subassembly.unjoined": (
        "副本未连接子装配 {of} 的全部接口，缺少：{ports}。",
        "给出每个接口在机构中对应的名称。示例：join: {{{example}: NAME}}",
    ),
    "subassembly.no-parameter": (
        "子装配 {of} 没有名为“{name}”的参数。",
        "{near}否则在该子装配的 parameters 中定义它。",
    ),
    "subassembly.tolerance": (
        "参数 {name} 在子装配中有公差，而此处的值取决于其他参数，还会随这些参数的偏差而变。",
        "若只有这些参数有偏差，写成 {{value: {value}, tolerance: none}}；若应有独立的偏差，用数值代替表达式。",
    ),
    "subassembly.mirrored": (
        "该副本无法镜像：子装配 {of} 的 {section} 中，“{name}”的镜像没有定义。",
        "只有作用于子装配的构件和机架、且表达式仅取决于其运动的元素可以镜像；由表格给出的扭簧不能镜像。在子装配之外定义该元素，或另写一个子装配。",
    ),
    "subassembly.same-point": (
        "构件 {link} 的两个接口连接到同一点（{points}）。",
        "将同一构件的各接口连接到不同的点。",
    ),
    "subassembly.taken": (
        "副本要在 {section} 中添加 {name}，但该名称已存在。",
        "将副本或另一元素改名。",
    ),
    "subassembly.long-name": (
        "加上副本名称后，{name} 超过 {limit} 个字符。",
        "缩短副本或元素的名称。",
    ),
    "subassembly.deep": (
        "子装配的副本嵌套超过 {limit} 层。",
        "将内层各级合并为一个子装配的构件和运动副。",
    ),
    "subassembly.too-many": (
        "加上此副本后，{section} 中将有 {count} 个条目，最多允许 {limit} 个。",
        "减少副本，或拆分模型。",
    ),
}
