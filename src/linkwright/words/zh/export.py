"""The words of the exports: sentences for the terminal, comments in the files."""

TEXTS: dict[str, str] = {
    "mjcf.told": "{bodies} 个物体，{loops} 个闭环由 connect 约束封闭；{poses} 个位姿下闭环与构件的最大误差：{error} m。",
    "mjcf.comment": "由 linkwright 写入。m、kg、s、rad；平面 x-y，轴线 z。各物体为构件，采用其自身坐标系，位姿取 t = 0 时刻。hinge 的位置为子构件角度减去父构件角度，slide 的位置为其行程，actuator 的控制量为驱动的数值。闭环由 connect 约束封闭；该约束在 MuJoCo 中是柔性的：受载时闭环略有张开，结果与刚性构件的结果相差同等程度。其刚度由 solref 和 solimp 设定。受驱动的运动副设有 armature，使载荷几乎不影响驱动的运动。",
    "motors.told": "{drive}：{count} 段，最大误差 {error} {unit}。",
    "motors.title": "{name}：电机的运动规律，由 linkwright 写入",
    "motors.time": "时长 {stop} s；t 的单位为 s。",
    "motors.dialect.creo": "sin、cos、tan 的自变量单位为度，asin、acos 的返回值单位为度。在 Creo Mechanism 中：位置伺服电机，采用用户定义函数；以下每行对应其表中一行：表达式和定义域。",
    "motors.dialect.radians": "sin、cos、tan 的自变量单位为弧度，asin、acos 的返回值单位为弧度。",
    "motors.head": "{drive}：{what}，单位 {unit}；最大误差 {error} {unit}",
    "motors.turns": "{link} 相对 {on} 的角度",
    "motors.slides": "{link} 相对 {on} 的行程",
    "motors.path": "{link} 的点 {point} 在 {on} 坐标系中的 {axis} 坐标；{drives} 由两个坐标求出",
    "motors.point": "{link} 上的点沿 {on} 上直线的位置",
    "motors.output": "{link} 相对 {on} 的运动，为 {drive} 的输出",
}
