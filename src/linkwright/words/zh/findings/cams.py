"""Problems of cams in a model file."""

PROBLEMS: dict[str, tuple[str, str]] = {
    "cam.contact": (
        "从动件与凸轮的接触方式定义不明确；已给出：{given}。",
        "给出 roller 和 at（滚子中心），或 knife（从动件上的一点），或 face（从动件上的一条直线）。",
    ),
    "cam.second": (
        "给出了与副凸轮的接触，但该凸轮的封闭方式为 closed: {closed}。",
        "改为 closed: conjugate，或删除 second。",
    ),
    "cam.second-twice": (
        "副凸轮由 base、at 和 face 中的一项以上重复定义：{given}。",
        "只给出一项：从动件第二接触的位置，或副凸轮的基圆。",
    ),
    "cam.second-other": (
        "共轭凸轮的主、副凸轮必须采用同一种接触方式；主凸轮为 {first}，副凸轮为 {given}。",
        "使副凸轮采用同一种接触方式：滚子用 at 给出，尖底只给出 at，平底用 face 给出。",
    ),
    "cam.same-link": (
        "凸轮、从动件和支承构件必须是三个不同的构件：{cam}、{follower}、{on}。",
        "分别指定带凸轮的构件、从动构件，以及为二者导向的构件。",
    ),
    "cam.no-shaft": (
        "凸轮构件 {cam} 未用转动副与 {on} 连接。",
        "在凸轮轴轴线上为两个构件各定义一个同名的点，或在 on 中指定其他构件。",
    ),
    "cam.no-motor": (
        "没有使 {cam} 相对于 {on} 转动且具有自身运动规律的驱动。",
        "添加一个使 {cam} 相对于 {on} 转动的驱动，不带 output；凸轮运动规律按其转角求值。",
    ),
    "cam.no-guide": (
        "从动件 {follower} 既未用转动副与 {on} 连接，也未用移动副在其上导向。",
        "为两个构件各定义一个同名的点，或在二者之间添加移动副。",
    ),
    "cam.law": (
        "运动规律 {law} 与从动件不符（{given}）。",
        "改用 over: angle、of: {of}、beyond: repeat 的运动规律。",
    ),
    "cam.period": (
        "运动规律 {law} 的周期为 {period} {unit}；凸轮的周期必须为一整周，或一整周的整数分之一。",
        "使各区段之和为一整周，例如加入休止段。",
    ),
    "cam.side": (
        "从动件位于哪一侧不明确：{given}。",
        "例如写“side: {meant}”。",
    ),
    "cam.askew": (
        "平底与移动方向不垂直，偏差为 {angle} {unit}。",
        "改正平底的角度；只支持与移动方向垂直的平底。",
    ),
    "cam.offset": (
        "从动件 {follower} 相对于凸轮轴的偏距为 {offset} {unit}，而基圆与滚子半径之和只有 {limit} {unit}。",
        "增大基圆，或减小从动件的偏距。",
    ),
    "cam.second-side": (
        "在整个推程中，{follower} 的第二接触必须始终位于凸轮轴与摆动中心连线的另一侧：其摆杆或平底与该连线的夹角为 {low} 至 "
        "{high} {unit}，允许范围为 {least} 至 {most} {unit}。",
        "移动第二接触点或第二平底，或修改副凸轮的基圆。",
    ),
    "cam.second-height": (
        "{follower} 的第二接触必须始终在凸轮轴的另一侧；从动件位移最大时，它仍在第一接触一侧，距凸轮轴 {height} {unit}。",
        "使第二接触点或第二平底远离第一接触。",
    ),
    "cam.second-base": (
        "{follower} 的第二接触位置使副凸轮的基圆半径只有 {base} {unit}。",
        "使第二接触远离凸轮轴，或减小第二个滚子。",
    ),
    "joint.locks": (
        "由 {joint}（{kind}）带动的构件在 t = {time} s（{drive} = {value} {unit}）时卡死：{why}。",
        "减小升距，或将推程分布到更大的范围上，使压力角始终小于 90 deg。",
    ),
    "cam.lifts-off": (
        "凸轮 {joint} 的从动件脱离：在 t = {time} s（{drive} = {value} {unit}）时，需要 {force} {of} 的拉力才能保持接触。",
        "添加弹簧或改用更强的弹簧，降低转速；若从动件为形封闭，则改为 closed: groove（或 conjugate、yoke）。",
    ),
    "cam.locks": (
        "凸轮 {joint} 的从动件在 t = {time} s（{drive} = {value} {unit}）时卡死：{why}。",
        "减小升距，或将推程分布到更大的凸轮转角上；或修改摆动中心、摆杆长度或基圆，使压力角始终小于 90 deg。",
    ),
    "cam.loose": (
        "凸轮 {cam} 的框形从动件最大间隙为 {play}；力按无间隙计算。",
        "改用相隔半周的两处位移之和恒定的运动规律，或采用副凸轮，即 closed: conjugate。",
    ),
    "cam.reach": (
        "{follower} 的摆杆与基圆不匹配，长度过长或过短 {by} {unit}：摆杆长度为 {arm} {unit}、中心距为 {distance} {unit} "
        "时，滚子中心到凸轮轴的距离为 {low} {unit} 至 {high} {unit}，而基圆与滚子半径之和为 {pitch} {unit}。",
        "修改基圆、摆杆长度或中心距，使所需距离落在该范围内。",
    ),
    "cam.face": (
        "{follower} 的平底无法与基圆接触：基圆半径 {base} {unit} 减去平底偏距 {face} {unit}，其差必须小于中心距 {distance} {unit}。",
        "修改基圆、平底偏距或中心距。",
    ),
    "cam.no-distance": (
        "从动件 {follower} 的摆动中心与凸轮轴重合。",
        "将两个铰链分开。",
    ),
    "cam.no-arm": (
        "点 {point} 位于从动件的摆动中心上。",
        "改为从动件上不在摆动中心处的点。",
    ),
    "study.cams": (
        "分析 {study} 使各驱动独立运动，而从动件（{names}）随其驱动运动。",
        "删除该分析，或将各从动件改为驱动。",
    ),
    "study.paths": (
        "分析 limits 逐个移动驱动，而 {drives} 共同沿轨迹（{names}）运动。",
        "从本文件中删除该分析；或在副本中用各驱动自身的运动规律代替轨迹。",
    ),
    "study.follower": (
        "{name} 是从动件：它随驱动 {motor} 运动，不能独立运动。",
        "将驱动改为 {motor}，其从动件随之运动。",
    ),
    "motion.cylinder-length": (
        "在 {time} s 时（{drive} 为 {value} {unit}），缸 {name} 两铰链间的长度需为 {length} {length_unit}，比极限长度 {limit} "
        "{length_unit} {end} {by} {length_unit}。",
        "限制驱动的行程，移动缸的一个端点，或改用其他行程的缸。",
    ),
    "drive.law": (
        "驱动的运动定义不明确。",
        "给出 speed 和 start（必要时加 acceleration），或以 t 的表达式给出 position。",
    ),
    "drive.start": (
        "speed 和 start 必须同时给出。",
        "给出 speed（恒定速度）和 start（t = 0 时的值）。若草图已确定驱动的值，可省略 start。",
    ),
    "drive.acceleration": (
        "仅有加速度不能确定运动。",
        "添加 speed 和 start，即 t = 0 时的速度和值。",
    ),
    "drive.twice": (
        "{a} 相对于 {b} 的运动已由 {other} 规定。",
        "两个驱动只保留一个。",
    ),
    "drive.output": (
        "“{name}”不能作为驱动的输出：它既不是移动副，也不是本模型的构件或轨迹。",
        "{near}输出应为移动副、其相对机架的角度按规律变化的构件，或两个驱动的轨迹（paths）。",
    ),
    "path.shape": (
        "轨迹只能有一种形状：直线、圆弧，或 x 和 y；此处给出的是：{given}。",
        "给出其中一种，例如 'line: [[0, 0], [100 mm, 0]]'、'arc: {{centre: [50, 80], radius: 20 mm}}'，或以 t 的表达式给出两个坐标："
        "'x: 50 mm*cos(90 deg*t/(1 s)), y: 80 mm'。",
    ),
    "path.law": (
        "坐标 x 和 y 已完整给定沿轨迹的运动，不能再给出 {given}。",
        "将其删除；或改用 line 或 arc，由运动规律给定离起点的距离。",
    ),
    "path.no-length": (
        "轨迹直线的起点和终点是同一位置。",
        "给出两个不同的位置：第二个位置确定方向。",
    ),
    "path.drives": (
        "必须恰好由两个驱动使该点沿轨迹 {name} 运动；给出 'output: {name}' 的驱动：{count} 个 {drives}。",
        "令两个驱动以其为输出，且不给出自身的运动规律，例如 'left: {{turns: crank1, on: frame, output: {name}}}'。",
    ),
    "path.two-laws": (
        "驱动 {drive} 的运动由轨迹 {path} 求出，不能有自身的运动规律。",
        "删除其 speed、start、acceleration 或 position；或删除 output。",
    ),
    "drive.output-own": (
        "{link} 和 {on} 是驱动自身的构件，“{name}”不能作为其输出。",
        "删除 output，运动规律即作用于驱动本身。",
    ),
    "drive.signal": (
        "驱动的运动规律不能依赖“{name}”，因为它是运动的结果。",
        "用 t、参数和表表示运动规律。跟随某个驱动的构件用 joints 中的联动定义，例如“gearbox: {{coupling: [drum, frame], follows: 2*motor.angle + 30 deg}}”。",
    ),
    "drive.linear-table": (
        "表 {table} 采用线性插值，驱动的速度会在每个数据点处突变。",
        "在表中写 between: cubic 或 between: quintic。",
    ),
    "drive.not-finite": (
        "驱动 {drive} 的{what}在 t = {time:.6g} s 时不是有限值，或绝对值不小于 1e40。",
        "检查其 position 是否有除以零、负数开方或在零点处开方。",
    ),
    "joint.not-finite": (
        "跟随 {motor} 的 {name} 的{what}在 t = {time:.6g} s 时不是有限值，或绝对值不小于 1e40。",
        "检查其表达式是否有除以零、负数开方或在零点处开方。",
    ),
    "drive.outside-table": (
        "驱动 {drive} 在 {at:.6g} 处取表的值，超出其范围 {low:.6g} 至 {high:.6g}（SI 单位：s、m、rad）。",
        "扩展该表，或为其给出周期。",
    ),
    "load.empty": (
        "该载荷既没有力，也没有力矩。",
        "给出其中一项。",
    ),
    "load.at": (
        "缺少力的作用点。",
        "添加 at：构件上的一点，或构件自身坐标系中的 [x, y]。",
    ),
    "load.direction": (
        "力为两个数 [Fx, Fy]，或沿移动副的一个数。",
        "写 force: [Fx, Fy] 且不写 along，或写一个数并加 along: JOINT。",
    ),
    "load.in": (
        "沿移动副的力以移动副方向为方向，此处的“in”没有意义。",
        "删除“in”。",
    ),
    "joint.slides-tilted": (
        "移动副 {joint} 不能使移动副 {loop} 组成的闭环封闭：其两条直线的方向之差与其他移动副所要求的相差 {angle} {unit}。",
        "改正 line 中的角度，使闭环中各方向相互一致。",
    ),
    "load.against-itself": (
        "载荷作用于 {name}，其反作用也作用于 {name} 自身：两力相互抵消。",
        "在 against 中指定其他构件；若载荷来自机构外部，则删除 against。",
    ),
    "load.signal": (
        "载荷依赖“{name}”，而后者本身是由力计算得到的。",
        "使其只依赖时间、运动、表和参数。",
    ),
    "load.outside-table": (
        "在 t = {time} s（{drive} = {value} {unit}）时，在 {at} {of} 处取表 {table} 的值，超出其范围 {low} 至 {high} {of}。",
        "扩展该表，为其给出周期，或将载荷限制在一个时间窗内。",
    ),
    "load.table-at-rest": (
        "静止时在 {at} {of} 处取表 {table} 的值，超出其范围 {low} 至 {high} {of}：使机构从静止开始运动所需的力（矩）未知。",
        "将该表扩展到静止状态。",
    ),
    "load.not-finite": (
        "载荷或弹簧在 t = {time} s（{drive} = {value} {unit}）时不是有限值。",
        "检查是否有除以零或负数开方；气弹簧的压缩量可能超出其气柱长度。",
    ),
}
