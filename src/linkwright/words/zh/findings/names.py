"""Problems of names."""

PROBLEMS: dict[str, tuple[str, str]] = {
    "name.unused-parameter": (
        "参数 {name} 未被使用：其数值不产生任何影响。",
        "{mend}",
    ),
    "name.unknown": (
        "本机构中没有名为“{name}”的{kind}。",
        "{near}",
    ),
    "name.unknown-point": (
        "构件 {link} 上没有名为“{name}”的点。",
        "{near}否则为该构件添加此点。",
    ),
    "name.unknown-element": (
        "本机构中没有名为“{name}”的元素。",
        "{near}",
    ),
    "name.unknown-kernel": (
        "没有名为“{name}”的计算内核。",
        "{near}",
    ),
    "name.unknown-parameter": (
        "没有名为“{name}”的参数。",
        "{near}否则在 parameters 中定义它。",
    ),
    "name.taken": (
        "“{name}”既是{first}的名称，又是{second}的名称，“{name}.x”之类的信号会有歧义。",
        "将二者之一改名。",
    ),
    "signal.no-attribute": (
        "“{attribute}”不是 {name} 的信号。",
        "{near}",
    ),
    "signal.indeterminate": (
        "移动副 {joint} 的 {attribute} 为静不定：移动副 {loop} 的方向相互约束，力矩可在其间循环传递。",
        "改用力的“.x”、“.y”或“.normal”，或为其中一个构件单独设置滑块，并用转动副与之连接。",
    ),
    "signal.no-joint": (
        "{a} 与 {b} 之间没有运动副，因此也没有相互作用力。",
        "改用以下之一：{options}。若三个构件共用一个铰链，以该铰链的名称作为第二个参数。",
    ),
    "signal.several-joints": (
        "{a} 与 {b} 由多个运动副连接：{joints}。",
        "以运动副的名称作为第三个参数：force({a}, {b}, JOINT)。",
    ),
    "signal.several-elements": (
        "“{name}”是多个驱动、载荷、弹簧或摩擦的名称，其功率有歧义。",
        "只保留其中一个名称，其余改名。",
    ),
    "signal.no-mass": (
        "“{name}”不是有质量的构件，因此没有质心。",
        "为该构件定义质量，或改用其上的点。",
    ),
    "signal.same-link": (
        "“{name}”相对于自身没有瞬心。",
        "指定两个不同的构件：pole({name}, frame).x。",
    ),
    "signal.unknown": (
        "“{name}”不是信号。",
        "{hint}",
    ),
    "signal.element": (
        "“{name}”是{kind}，而此处应为它的信号。",
        "改用以下之一：{signals}。",
    ),
}
