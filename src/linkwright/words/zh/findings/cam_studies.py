"""Texts of the problems of the cam study and of NC code."""

PROBLEMS: dict[str, tuple[str, str]] = {
    "cam.which": (
        "文件中有 {count} 个凸轮，而分析未指明针对哪一个：{names}。",
        "在 cam 中指定一个。",
    ),
    "cam.none": (
        "文件中没有凸轮。",
        "添加凸轮及其运动规律，例如“cams: {{seal: {{cam: disc, follower: lever, on: frame, base: 40 mm, law: lift, roller: "
        "15 mm, at: R}}}}”和“laws: {{lift: {{over: angle, of: angle, beyond: repeat, segments: [...]}}}}”；参见 "
        "docs/zh/how-to/cams.md。",
    ),
    "cam.together": (
        "以下各键必须同时给出：{keys}。",
        "全部给出，或全部删除。",
    ),
    "cam.not-positive": (
        "{key} 为 {text}，必须{least}。",
        "改正该数值。",
    ),
    "cam.keyway": (
        "键槽宽度大于轴孔直径。",
        "减小键槽宽度，或加大轴孔；轴孔和轮毂均以半径给出。",
    ),
    "cam.hub": (
        "轮毂过小，轴孔和键槽周围没有壁厚。",
        "加大轮毂，或减小轴孔；二者均以半径给出。",
    ),
    "cam.groove-blank": (
        "只有沟槽凸轮才单独给出毛坯盘的半径；该凸轮的封闭方式为 closed: {closed}。",
        "当 closed: groove 时，给出 radius（毛坯盘半径）和 groove（槽深）；否则删除这两项。",
    ),
    "cam.groove-deep": (
        "沟槽深度不小于毛坯盘厚度。",
        "增大毛坯盘厚度，或减小槽深。",
    ),
    "cam.plate": (
        "沟槽外侧面到中心的最大距离为 {most} {unit}，超出毛坯盘边缘。",
        "将 radius 增大到该值以上。",
    ),
    "cam.blank": (
        "轮毂、轴孔或键槽到中心的最大距离为 {reach} {unit}，而{profile}的最小向径只有 {least} {unit}。",
        "减小这些尺寸（均以半径给出），或增大基圆。",
    ),
    "cam.no-base": (
        "在 {low} {unit} 至 {high} {unit} 范围内，没有满足限值的基圆。",
        "扩大范围，或放宽限值。",
    ),
    "cam.passes": (
        "该深度需要分 {count} 层铣削，上限为 {most} 层。",
        "增大 step，或减小凸轮厚度。",
    ),
    "cam.undercut": (
        "{disc}发生运动失真：凸轮转角 {theta} 处{name}为 {value} {unit}，必须大于 {limit} {unit}。任何实际廓线都不能使从动件实现该运动。",
        "增大基圆（最小：{base}），或将推程分布到更大的凸轮转角上{roller}。",
    ),
    "cam.rough": (
        "凸轮转角 {theta} 处，从动件的{rate}发生突变。",
        "改用在该处连续的运动规律，或放宽限值 continuity。",
    ),
    "cam.hollow": (
        "{profile}在凸轮转角 {theta} 处内凹，曲率半径为 {value} {unit}，小于刀具半径 {limit} {unit}。",
        "改用较小的刀具，或增大基圆（最小：{base}）。",
    ),
    "cam.limit": (
        "{name}在凸轮转角 {theta} 处为 {value} {unit}，限值为 {limit} {unit}。",
        "修改基圆、摆杆长度、偏距或运动规律，或修改限值；size 可求出满足限值的最小基圆。",
    ),
    "cam.required": (
        "{name} 为 {value} {unit}，要求为 {wanted}。",
        "修改凸轮，或修改要求。",
    ),
    "cam.sharp": (
        "凸轮转角 {theta} 处轮廓曲率过大，无法在公差 {tolerance} 内逼近。",
        "增大基圆，改用更平滑的运动规律，或放宽公差。",
    ),
    "cam.knife": (
        "尖底没有半径，其接触应力无定义。",
        "为从动件添加滚子，或删除 width。",
    ),
    "cam.no-roller": (
        "该从动件没有滚子，因此没有滚子转速。",
        "为从动件添加滚子。",
    ),
    "cam.no-speed": (
        "凸轮转速未知：驱动 {motor} 不是匀速驱动。",
        "在 forces 或驱动中给出 speed。",
    ),
    "cam.poisson": (
        "泊松比为 {text}；各向同性材料的泊松比不超过 0.5。",
        "给出 0 至 0.5 之间的数值，例如钢为 0.3。",
    ),
    "cam.no-figure": (
        "{name} 不是本分析的结果。",
        "添加 forces；赫兹接触应力还需要 width，形封闭时，弹簧和脱离转速的结果还需要 spring。只有滚子才有转速；只有平底才有 face_near 和 "
        "face_far，而平底没有理论廓线，也没有内凹曲率半径。副凸轮的结果需要 closed: conjugate，宽度和间隙的结果需要 closed: "
        "yoke。",
    ),
    "cam.load-name": (
        "“{name}”是参数名，但在凸轮载荷中，它同时表示凸轮的 {name}。",
        "修改参数名。",
    ),
    "cam.load-signal": (
        "凸轮载荷中不能使用“{name}”。",
        "使用 angle（凸轮转角）、lift（从动件位移）、参数、表和运动规律。",
    ),
    "cam.load-outside": (
        "凸轮转角 {theta} 处，载荷在 {at} {of} 处取表 {table} 的值，超出其范围 {low} 至 {high} {of}。",
        "扩展该表，或为其给出周期。",
    ),
    "cam.load-not-finite": (
        "凸轮转角 {theta} 处，载荷不是有限值。",
        "检查是否有除以零或负数开方。",
    ),
    "cam.spring": (
        "从动件脱离：转速为 {speed} 时，接触力在凸轮转角 {theta} 处降至 {force}，至少应为 {least}。",
        "将从动件位移为零时的弹簧预紧力设为 {preload}{rate}。",
    ),
    "cam.hertz": (
        "赫兹接触应力在凸轮转角 {theta} 处为 {value}，限值为 {limit}。",
        "将接触宽度增大到 {width}，或增大基圆、加大滚子或改用较弱的弹簧。",
    ),
    "cam.torque": (
        "凸轮轴力矩在凸轮转角 {theta} 处为 {value}，限值为 {limit}。",
        "改用较弱的弹簧，减轻从动件，或将推程分布到更大的凸轮转角上。",
    ),
    "cam.shock": (
        "从动件速度发生突变，该处的力将为无穷大。",
        "改用速度连续的运动规律。",
    ),
    "cam.locked": (
        "从动件卡死：压力角达到 90 deg。",
        "增大基圆，或改变从动件的导向方式。",
    ),
    "cam.groove": (
        "只有滚子能在沟槽中运动。",
        "为从动件添加滚子。",
    ),
    "cam.yoke": (
        "只有直动从动件才能做成框形。",
        "摆动从动件改用沟槽或副凸轮实现形封闭。",
    ),
    "cam.play": (
        "框形从动件的最大间隙为 {play}：凸轮在从动件移动方向上的宽度，在凸轮转角 {at_min} 处为 {yoke_span_min}，在 {at_max} "
        "处为 {yoke_span_max}。",
        "改用相隔半周的两处位移之和恒定的运动规律，例如回程与推程采用同一规律且相隔半周；或采用副凸轮，即 closed: conjugate。",
    ),
    "nc.no-post": (
        "要求生成数控代码，但未指定数控系统。",
        "在 post 中指定 {known} 之一，或删除 nc。",
    ),
    "nc.undercut": (
        "凸轮在 {theta} deg 处发生运动失真：理论廓线曲率半径为 {radius} mm，滚子半径为 {roller} mm。",
        "增大基圆，或减小滚子。",
    ),
    "nc.concave": (
        "实际廓线在 {theta} deg 处内凹，曲率半径为 {radius} mm，小于刀具半径 {cutter} mm。",
        "改用较小的刀具，或增大基圆。",
    ),
    "nc.small-cutter": (
        "刀具半径 {cutter} mm 过小；在当前小数位数下，最小为 {smallest} mm。",
        "检查刀具半径的单位，或增加小数位数。",
    ),
    "nc.wide-cutter": (
        "半径 {cutter} mm 的刀具无法进入滚子半径为 {roller} mm 的沟槽。",
        "改用不大于滚子的刀具。",
    ),
    "nc.undercut-outer": (
        "沟槽外侧面在 {theta} deg 处发生运动失真：理论廓线内凹，曲率半径为 {radius} mm，滚子半径为 {roller} mm。",
        "增大基圆，或减小滚子。",
    ),
    "nc.allowance": (
        "沟槽中心线两侧的走刀给精加工留下 {allowance} mm 余量，大于刀具半径 {cutter} mm。",
        "减小余量。",
    ),
    "nc.groove-lead": (
        "使用刀具半径补偿时，切入和切出圆弧半径必须大于刀具半径 {cutter} mm；这样的圆弧在滚子半径为 {roller} mm 的沟槽中放不下。",
        "改用较小的刀具（略小于滚子半径的三分之二，余量还要更小），或删除 compensation。",
    ),
    "nc.no-compensation": (
        "数控系统 {post} 不支持刀具半径补偿。",
        "删除 compensation，此时按刀具中心轨迹编程。",
    ),
    "nc.short-lead": (
        "使用刀具半径补偿时，切入和切出圆弧半径 {lead} mm 必须大于刀具半径 {cutter} mm。",
        "增大 lead。",
    ),
    "nc.decimals": (
        "数控系统 {post} 最多接受 {most} 位小数。",
        "减少小数位数。",
    ),
    "nc.fine": (
        "位移公差允许的轨迹误差为 {allowed} mm，而仅舍入误差就达 {rounding} mm。",
        "增加小数位数，或放宽公差。",
    ),
    "nc.no-dwell": (
        "刀具在 {theta} deg 处切入，而此时从动件正在运动：留下的刀痕会影响从动件的运动。",
        "将 start 设在休止段内；没有休止段的凸轮无法避免刀痕。",
    ),
    "nc.sharp": (
        "凸轮转角 {theta} deg 处，刀具轨迹无法在公差内逼近。",
        "增加小数位数或放宽公差；曲率过大处可增大基圆。",
    ),
    "nc.off": (
        "回读 {post} 的文件，所得位移的偏差为公差的 {share} 倍，并且对实际廓线过切 {gouge} mm。该文件未写入。",
        "增加小数位数或步数；若误差仍然存在，将其作为 linkwright 的缺陷报告。",
    ),
    "nc.depth": (
        "回读 {post} 的文件，铣削深度为 {depth} mm，而要求为 {wanted} mm。该文件未写入。",
        "检查其中的深度；若误差仍然存在，将其作为 linkwright 的缺陷报告。",
    ),
    "nc.island": (
        "回读 {post} 的文件，沟槽中 X{x} Y{y} 附近有残留。",
        "检查理论廓线两侧的走刀；若误差仍然存在，将其作为 linkwright 的缺陷报告。",
    ),
    "nc.stray": (
        "回读 {post} 的文件，凸轮在刀具轨迹以外的 X{x} Y{y} 附近被过切。",
        "检查各次走刀的起点；若误差仍然存在，将其作为 linkwright 的缺陷报告。",
    ),
    "nc.long-line": (
        "{post} 的文件中有一行长达 {length} 个字符，而该数控系统最多接受 {most} 个。该文件未写入。",
        "减少小数位数，或缩短名称。",
    ),
    "nc.nothing-left": (
        "回读 {post} 的文件，整个凸轮都被切除，或刀具未绕凸轮一周。",
        "对照基圆检查切入、切出圆弧和刀具。",
    ),
    "nc.tight": (
        "{post} 的文件第 {line} 行：补偿后的圆弧小于刀具。",
        "改用较小的刀具，或删除 compensation。",
    ),
    "nc.after-end": (
        "{post} 的文件第 {line} 行位于程序结束之后：{text}。",
        "删除 M2 或 M30 之后的内容。",
    ),
    "nc.unreadable": (
        "{post} 的文件第 {line} 行无法读取：{text}。",
        "每个程序字由一个字母和一个数组成。",
    ),
    "nc.no-end": (
        "{post} 的文件缺少程序结束指令。",
        "在末尾添加 M2 或 M30。",
    ),
    "nc.unknown": (
        "{post} 的文件第 {line} 行有未知的程序字：{word}。",
        "将其删除；含有未知程序字的程序无法验证。",
    ),
    "nc.twice": (
        "{post} 的文件第 {line} 行中，地址 {word} 出现两次。",
        "删除其中一个。",
    ),
    "nc.no-motion": (
        "{post} 的文件第 {line} 行在 G0 至 G3 之前出现坐标。",
        "先写 G0 至 G3 之一。",
    ),
    "nc.no-unit": (
        "{post} 的文件第 {line} 行在设定单位之前就有运动。",
        "先设定 G21（mm）或 G20（英寸）。",
    ),
    "nc.no-feed": (
        "{post} 的文件第 {line} 行切削时未设定进给速度。",
        "先设定 F。",
    ),
    "nc.no-spindle": (
        "{post} 的文件第 {line} 行切削时主轴未转动。",
        "先用 M3 启动主轴。",
    ),
    "nc.no-centre": (
        "{post} 的文件第 {line} 行的圆弧没有 I 和 J。",
        "给出圆心；用半径给出的圆弧精度不足。",
    ),
    "nc.centre-on-line": (
        "{post} 的文件第 {line} 行在直线运动中给出了圆心。",
        "删除 I、J 和 R，或改为圆弧。",
    ),
    "nc.radius": (
        "{post} 的文件第 {line} 行：圆弧起点到圆心的距离为 {start} mm，终点到圆心的距离为 {end} mm。",
        "改正终点或圆心；数控系统会在此处停机。",
    ),
}
TERMS = {
    "or-roller": "，或减小滚子",
    "or-rate": "，或保持当前预紧力，将弹簧刚度设为 {rate}",
    "no-rate": "；保持当前预紧力时，任何刚度都不够",
    "a-length": "从动件的尺寸",
    "no-base": "放大到 20 倍仍不满足",
    "normal-square": "压力角达到 90 deg，沿公法线方向的力无法推动从动件",
    "face-fast": "平底与凸轮转速相同，接触点沿平底移向无穷远",
    "cam-positive": "大于 0",
    "cam-zero": "不小于 0",
    "jump-acceleration": "加速度",
    "jump-jerk": "跃度",
    "cam-first": "凸轮",
    "cam-second": "副凸轮",
    "cam-flank": "沟槽外侧面",
    "cam-profile": "实际廓线",
    "of-second": "副凸轮的{what}",
    "base-between": "{base}，此时两接触相距 {between}",
    "check-pressure_rise": "推程压力角",
    "check-pressure_return": "回程压力角",
    "check-pitch_radius": "理论廓线曲率半径",
    "check-profile_radius": "实际廓线外凸曲率半径",
    "check-hollow_radius": "实际廓线内凹曲率半径",
    "check-groove_radius": "理论廓线内凹曲率半径",
}
