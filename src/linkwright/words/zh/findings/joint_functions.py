"""Problems of joint functions."""

PROBLEMS: dict[str, tuple[str, str]] = {
    "functions.drives": (
        "运动副函数要求有且只有一个主动运动副；该机构有 {count} 个驱动：{names}。",
        "保留一个驱动，将其余驱动所连接的构件相互固定。",
    ),
    "functions.left-out": (
        "运动副 {joint} 列在 left_out 中，但它正是 {drive} 所驱动的运动副。",
        "将其从 left_out 中删除。",
    ),
    "functions.master-left-out": (
        "运动副 {joint} 列在 left_out 中，但它是主动运动副（master）：所有函数都以它为自变量。",
        "将其从 left_out 中删除，或将 master 改为其他运动副。",
    ),
    "functions.master-cam": (
        "运动副 {joint} 不能作为主动运动副（master）：从动件（{drives}）的函数以其驱动的运动副为自变量。",
        "删除 master，即以驱动的运动副为主动运动副。",
    ),
    "functions.master-still": (
        "运动副 {joint} 不能作为主动运动副（master）：它在该范围内不运动。",
        "指定一个会运动的运动副。在整个范围内单向运动的有：{others}。",
    ),
    "functions.master-zero": (
        "运动副 {joint} 不能作为主动运动副（master）：它在 {drive} = {at} {unit} 处有极限位置，运动方向在此反转，而零位就在该处。",
        "将 zero 设为远离该处的 {drive} 值，或将 master 改为其他运动副。在整个范围内单向运动的有：{others}。",
    ),
    "functions.master-turns": (
        "在该范围内，运动副 {joint} 不能作为主动运动副（master）：它在 {drive} = {at} {unit} 处有极限位置，运动方向在此反转，同一个值对应两个位姿。",
        "将 range 设在 [{low} {unit}, {high} {unit}] 之内，或将 master 改为其他运动副。在整个范围内单向运动的有：{others}。",
    ),
    "functions.master-cut": (
        "主动运动副 {joint} 在 {drive} = {at} {unit} 处有极限位置，运动方向在此反转。各函数仅在 {drive} 为 {low} 至 {high} {unit} 时有效。",
        "若该范围已够用，将 range 设在其中以确认；或将 master 改为其他运动副。在 {drive} 的整个范围内单向运动的有：{others}。",
    ),
    "functions.master-stops": (
        "主动运动副 {joint} 在两个限位之间有极限位置，运动方向在此反转。",
        "将 stops 设在 [{low} {unit}, {high} {unit}] 之内，即零位附近的可用范围。",
    ),
    "functions.master-structure": (
        "运动副 {joint} 不能作为主动运动副（master）：若以它代替 {drive} 作为驱动，机构将欠约束或过约束。",
        "在 {drive} 所带动的闭环中指定一个运动副。",
    ),
    "functions.no-dependent": (
        "没有随 {drive} 变化的运动副，因此没有可写的函数。",
        "使构件构成闭环，将某个运动副从 left_out 中删除，或删除该导出；直接驱动的运动副不需要函数。",
    ),
    "export.too-long": (
        "{joints} 的角度在 {duration} s 内无法连续跟踪。",
        "缩短 {name} 的 duration；最慢的驱动转几周即可。",
    ),
    "export.joint": (
        "{name} 不支持 {joint}（{kind}）这类运动副。",
        "不将该机构导出到该目标，或用构件、转动副和移动副代替该运动副。",
    ),
    "export.cannot-close-slides": (
        "{name} 无法表示由 {joints} 构成的只含移动副的闭环：闭环只能由转动副封闭。",
        "为其中一个构件单独设置滑块，并用转动副与之连接；或不导出该机构。",
    ),
    "functions.wedge": (
        "{links} 位于只含移动副的闭环中（移动副 {slides}），此类闭环不支持运动副函数。",
        "手工编写函数：此类闭环中各移动副的行程彼此成正比。",
    ),
    "functions.shared-pin": (
        "驱动 {drive} 使铰链 {pin} 上的两个构件相对运动，但该铰链上有其他构件排在它们之前；Process Simulate 的运动副将铰链上的第一个构件与其余各构件分别连接。",
        "改为使其中一个构件相对于铰链上的第一个构件运动，或为该驱动单独设置铰链。",
    ),
    "functions.too-many": (
        "连同辅助运动副，共需 {count} 个运动副；Process Simulate 的函数最多支持 {limit} 个。",
        "将使闭环封闭的运动副列入 left_out，允许更长的函数文本，或只导出机构的一部分。",
    ),
    "functions.name": (
        "在 Process Simulate 中，运动副 {joint} 不能命名为“{name}”。",
        "在 names 中为其命名，最多 60 个字符，只用字母 A 至 Z、数字和下划线，且不以数字开头；Process Simulate 是否接受其他名称尚不清楚。",
    ),
    "functions.same-name": (
        "有多个运动副名为“{name}”：{joints}。",
        "在 names 中分别为其命名。",
    ),
    "functions.mirror-names": (
        "两侧铰链的运动副名称相同。",
        "为两侧设置不同的后缀或前缀，例如 mirror: {{suffixes: [_l, _r]}}。",
    ),
    "functions.two-ranges": (
        "range 和 stops 同时限制了主动运动副。",
        "只保留一项：range 按驱动的值给出，stops 按运动副从零位起的值给出。",
    ),
    "functions.no-range": (
        "机构无法从 {drive} = {start} {unit} 处开始运动。",
        "将驱动的起点设在机构不处于死点的位置；limits 分析会列出其运动范围。",
    ),
    "functions.toggle": (
        "{of} 由 {from} 到 {to} {unit} 时，机构经过死点（构件共线；杆组 {groups}）：两种装配模式在此汇合，一个函数无法兼顾二者。",
        "将 {key} 设在 [{low} {unit}, {high} {unit}] 之内，即起始位姿附近的最大范围。",
    ),
    "functions.zero": (
        "在起始位姿与零位（{drive} = {zero} {unit}）之间，机构经过死点（构件共线；杆组 {groups}）：一个函数无法兼顾两种装配模式。",
        "将 zero 设在 [{low} {unit}, {high} {unit}] 之内，或将驱动的起点设在零位一侧。",
    ),
    "functions.still": (
        "以下运动副在整个范围内都不运动：{joints}。",
        "若它们应当运动，检查是否有两个铰链中心重合，或范围是否过小。",
    ),
    "functions.sweep": (
        "在该范围内，有一个方向相对于任何构件都要转过 {spread} deg（运动副 {joints}）；语法格式 {dialect} 只能覆盖 {most} deg。",
        "缩小范围；语法格式 seed 的反余弦无法覆盖的范围，改用 wizard 的 atan2 或许可行。",
    ),
    "functions.error": (
        "无论取多少位小数，在 {drive} = {at} {unit} 处函数误差都为 {error}（rad 或 mm）。",
        "使所取范围远离构件共线或铰链重合的位姿。",
    ),
    "functions.length": (
        "函数无法拆分为短于 {longest} 个字符的文本；最小为 {least}。",
        "将 longest 设为不小于 {least}。",
    ),
    "functions.no-closed-form": (
        "构件 {links} 只能同时装配（杆组 {group}），其运动副没有封闭形式的函数。",
        "设置 approximate，改用以 {drive} 的值为自变量的多项式；在该范围内，{degree} 次多项式的误差为 {error}（rad 或 mm），因此 "
        "approximate: {approximate} 即可。缩小范围可减小误差。",
    ),
}
