"""Problems of exports."""

PROBLEMS: dict[str, tuple[str, str]] = {
    "export.which": (
        "未指定导出目标。",
        "添加 --to 和以下之一：{known}。",
    ),
    "export.unknown": (
        "没有名为“{name}”的导出目标。",
        "{near}",
    ),
    "export.missing": (
        "文件中没有导出到 {name} 的选项。已有的导出：{has}。",
        "在文件中添加，例如“exports: {{{name}: {example}}}”。",
    ),
    "export.options": (
        "导出到 {export} 的选项 {key} 无效：{reason}。",
        "改正该选项；docs/file-format.md 列出了各导出目标的选项。",
    ),
    "export.choice": (
        "导出到 {study} 的选项 {key} 不能为 {given}。",
        "{near}",
    ),
    "export.handle": (
        "把手 {name} 是机架上的点，不会运动。",
        "指定盖板平台（panel）上的一点，即开启时手握之处。",
    ),
    "export.outline": (
        "这些点不能构成外轮廓：{reason}。",
        "按绕行顺序列出盖板平台（panel）上至少三个点，每点一次。",
    ),
    "export.setting": (
        "“{given}”不符合 KEY=VALUE 的形式。",
        "按模型文件中的写法给出选项及其值：--set decimals=12。",
    ),
    "export.no-mass": (
        "MuJoCo 要求每个运动构件都有质量：已为 {links} 设定质量 {mass}、回转半径 {radius}。",
        "在模型中给出这些构件的质量，或修改 tiny_mass。",
    ),
    "export.no-inertia": (
        "MuJoCo 要求每个运动构件都有转动惯量：已按回转半径 {radius} 设定 {links} 的转动惯量。",
        "若转动惯量有影响，在模型中为这些构件给出。",
    ),
    "export.no-duration": (
        "未给出运动的时长。",
        "在 exports.{export} 中给出 duration，或在 studies 中给出 cycle。",
    ),
    "export.too-many-pieces": (
        "{drive} 的运动规律在该时段内超过 {limit} 段，因此未写成文本。",
        "使用 motion.csv 中的数值，或缩短 duration。",
    ),
    "export.no-formula": (
        "{drive} 的运动规律没有公式，因此未写成文本。",
        "使用 motion.csv 中的数值。",
    ),
    "joint.winds": (
        "该类运动副（{kind}）需要构件的连续转角，而该构件只有方向已知。",
        "在该类运动副的类中设置 winds = True，使转角可连续跟踪多周。",
    ),
    "joint.weld-pin": (
        "{link} 和 {on} 没有共用唯一一个可供焊接的转动副。",
        "在需要求力的截面处给两个构件一个同名的点，且两者之间不设其他运动副；weld: [{link}, {on}] 即保持二者的角度。",
    ),
    "joint.weld-drive": (
        "无法把 {link} 焊在 {on} 上：所有驱动都带有 output，或没有驱动。",
        "使一个驱动按自身的规律运动。对于静止的结构，把两个构件的点写在同一个构件上。",
    ),
    "joint.coupling-joint": (
        "{link} 与 {on} 之间不是恰好由一个运动副连接，无法随动。",
        "用一个转动副或一个移动副连接这两个构件，并把随动的构件写在前面：coupling: [{link}, {on}]。",
    ),
    "joint.coupling-motor": (
        "“{text}”没有恰好引用一个驱动的值作为随动的依据。",
        "{near}写成一个驱动的值与参数的表达式，例如 follows: 2*motor.angle + 30 deg。",
    ),
    "joint.coupling-name": (
        "联动的表达式中不能使用“{name}”。",
        "用一个驱动的值、参数和函数写出，例如 follows: 2*motor.angle + 30 deg；以角度为自变量的运动规律用于凸轮或驱动本身。",
    ),
    "joint.follower-output": (
        "不能以 {motor} 作为从动件的驱动：其运动规律定义在输出 {output} 上。",
        "将 motor 改为其他驱动，或为 {motor} 给出自身的运动规律。",
    ),
    "joint.follower-law": (
        "运动规律 {law} 必须以驱动的{argument}为自变量，以从动件的{value}为因变量；现为 {given}。",
        "在该运动规律中写 over: {over} 和 of: {of}，或指定其他运动规律。",
    ),
    "export.unproven": (
        "验证未通过：{name} 的导出结果与模型的偏差为 {error} {unit}，因此未写入。",
        "检查是否有接近奇异的运动规律或位姿；否则将其作为 linkwright 的缺陷报告。",
    ),
    "export.drive": (
        "导出到 {name} 时不能包含驱动 {drive}：它所给定的不是运动副的值。",
        "改用作用于运动副的驱动再导出：先在此算出其运动，再作为其运动规律。",
    ),
    "export.left-out": (
        "MuJoCo 文件中不包含 {names}。",
        "若仿真需要，手工添加。",
    ),
    "export.followers": (
        "MuJoCo 没有使构件跟随驱动的运动副：每个从动件（{names}）各有一个执行器，按其运动规律运动。从动件上的力不作用于其驱动的执行器。",
        "使用 positions.csv 中从动件的控制量；从动件的力和驱动力矩取自 linkwright。",
    ),
}
