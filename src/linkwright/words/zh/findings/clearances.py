"""Problems of clearances."""

PROBLEMS: dict[str, tuple[str, str]] = {
    "clearance.cam": (
        "{name} 处的间隙会使凸轮 {cam} 的接触点移动，而该凸轮两侧接触（closed: {closed}）；linkwright 不计算实际接触的是哪一侧。",
        "在间隙中删除该运动副，改以中心距的公差给出此间隙。",
    ),
    "clearance.no-joint": (
        "{name} 不是运动副，没有间隙。",
        "{near}由 revolute 运动副构成的铰链，以该运动副的名称命名。",
    ),
    "clearance.one-link": (
        "点 {name} 只在构件 {link} 上，该处没有可带间隙的运动副。",
        "在另一构件上添加同名的点，或删除该间隙。",
    ),
    "clearance.not-positive": (
        "长度 {text} 不是正数。",
        "给出正的长度；没有间隙的运动副不列出。",
    ),
    "clearance.indeterminate": (
        "计算 {name} 的间隙需要其约束力矩，但该力矩无法确定：移动副 {loop} 的方向相互约束。",
        "删除该间隙，或将其中一个构件用转动副与滑块连接。",
    ),
    "clearance.no-length": (
        "未给出导轨 {name} 的导向长度，而滑块的倾斜量由它决定。",
        "与间隙一起给出，例如 length: 60。",
    ),
    "clearance.centre": (
        "{name} 不是构成该导轨的两个构件 {links} 上的点。",
        "指定其中一个构件上位于导向长度中点的点。",
    ),
    "clearance.short-guide": (
        "{name} 的间隙不小于其导向长度的一半，滑块得不到导向。",
        "检查这两个数值及其单位。",
    ),
    "clearance.no-key": (
        "{name}（{kind}）的间隙没有 {key} 这一项。",
        "删除 {key}。",
    ),
    "clearance.no-play": (
        "不能计算 {name} 的间隙：此类运动副（{kind}）没有定义接触点。",
        "将其删除，或将该间隙作为某个尺寸的公差给出。",
    ),
    "clearance.not-on-pin": (
        "构件 {link} 不在铰链 {name} 上，销轴不能固定在其中。",
        "指定该铰链上的构件之一：{links}。",
    ),
    "clearance.too-large": (
        "{name} 的间隙不小于构件 {link} 的尺寸（从该处算起为 {length}）。",
        "检查数值及其单位：应为径向间隙，即直径差的一半。",
    ),
    "clearance.roller": (
        "{name} 的间隙不小于该处滚子的半径 {radius}。",
        "检查数值及其单位：应为径向间隙，即直径差的一半。",
    ),
    "clearance.no-force": (
        "{links} 的运动副 {name} 在整个运动中不传递力，无法得知其接触侧：其间隙只计入界限。",
        "添加质量、载荷或弹簧，使该运动副受力；或使用界限。",
    ),
    "clearance.undetermined": (
        "{links} 的运动副 {name} 的约束反力在运动中某处没有有限值：其间隙只计入界限。",
        "检查该处是否有奇异位形，或载荷是否没有值。",
    ),
    "clearance.no-figure": (
        "未计算间隙对 {names} 的影响：{why}。",
        "使用位置、角度或长度，取 max、min、extremes、span、value、mean 或 rms。",
    ),
}
