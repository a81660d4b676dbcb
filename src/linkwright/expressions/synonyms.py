"""What words of the format are called elsewhere: in other programs, in books, in Chinese.

Each row has a word of the format and those that stand for it, of keys, elements, signals, functions, targets and
commands alike: a hint takes only words that can stand at its place.
"""

from __future__ import annotations

import unicodedata

from linkwright.expressions.chinese_units import chinese_unit

_WORDS = {
    "frame": "ground base fixed fix chassis world bed housing 机架 机座 基座 固定件 地面 地 底座 大地",
    # Sections.
    "assembly": "mode configuration branch 装配 装配模式 装配方式",
    "drives": "inputs input 驱动 原动件 驱动件 主动件 输入",
    "exports": "outputs 导出 输出",
    "joints": "constraints connections couplings pairs kinematic_pairs 运动副 关节",
    "linkwright": "version format 版本",
    "links": "bodies body parts part members member bars bar elements 构件 杆件 杆 零件",
    "loads": "forces external_forces 载荷 力 外力 负载",
    "measures": "outputs output results result sensors probes 测量 测量项 结果",
    "name": "title 名称 标题",
    "note": "description comment comments notes 备注 说明 注释",
    "parameters": "variables variable constants dimensions dimension 参数 变量 尺寸",
    "require": "limits constraints conditions specs 要求 性能要求 约束",
    "sketch": "coordinates nodes positions layout 草图",
    "studies": "analysis analyses simulation simulations solver calculation 分析 计算 仿真",
    "units": "单位",
    # Joints, drives, loads.
    "revolute": "links bodies between hinge pin pivot rotational rotary rotation turning R 转动副 铰链",
    "prismatic": "links bodies between slider slide sliding translational translation linear P 移动副 滑动副 滑块",
    "turns": "rotates rotate rotation revolute link body 转动 旋转 圈数 转数",
    "slides": "moves translates translate prismatic 移动 滑动",
    "extends": "cylinder actuator pushes stroke 伸缩 推 推动",
    "speed": "omega velocity rate rpm angular_velocity frequency w 速度 转速 角速度 速率",
    "start": "initial angle offset phase initial_angle phi0 theta0 初始角 起始角 初始位置 起始位置 初值",
    "position": "law motion profile function 位置 位移",
    "acceleration": "alpha 加速度",
    "on": "link body to parent relative_to 相对 作用于 基准",
    "at": "point location place 作用点 点",
    "line": "axis direction along 直线 导路 轴线",
    "from": "start begin first point1 low min minimum 从 起点 下限",
    "to": "end last second point2 high max maximum 到 终点 上限",
    "count": "steps number n points samples 个数 数量 步数",
    "torque": "moment couple M T 力矩 扭矩 转矩 驱动力矩",
    "force": "F load reaction 力",
    # Links, springs, parameters.
    "points": "nodes pins joints vertices coordinates 点 铰点 坐标",
    "mass": "m weight 质量",
    "inertia": "J I moment_of_inertia 转动惯量 惯量",
    "com": "cog centre center centre_of_mass center_of_mass centroid 质心 重心",
    "stiffness": "k rate constant spring_constant c 刚度 弹簧刚度",
    "free": "l0 free_length natural_length relaxed rest_length length 原长 自由长度",
    "damping": "b c d damping_constant 阻尼 阻尼系数",
    "value": "nominal val 数值 值 名义值",
    "tolerance": "tol tolerances deviation 公差",
    "gravity": "重力 重力加速度",
    "plane": "平面",
    "cylinders": "气缸 油缸 液压缸 电动缸 缸",
    "tables": "表 表格 数据表",
    "laws": "运动规律",
    "cams": "凸轮",
    "springs": "弹簧",
    "counterweights": "配重 平衡重",
    "friction": "frictions friction_coefficients 摩擦",
    "coefficient": "mu friction_coefficient coefficient_of_friction 摩擦系数",
    "static": "static_coefficient mu_s mu0 stiction 静摩擦系数",
    "viscous": "viscosity 粘性 粘性摩擦",
    "radius": "半径",
    "paths": "path trajectories trajectory curves 轨迹 路径",
    "moves": "point moved 移动点",
    "arc": "circle 圆弧",
    "differential": "diff differential_gear 差速器",
    "weights": "ratios factors 权 系数",
    "windows": "时间窗 窗口 区间",
    "source": "来源 出处",
    "author": "designer drawn_by creator 作者 设计者 编制",
    "revision": "rev issue 版次 修订",
    "pin_in_slot": "销槽副 滑槽 槽",
    "coupling": "联动 联轴",
    "gears": "齿轮副 齿轮",
    "teeth": "齿数",
    "rack": "齿条副 齿条",
    "pitch_line": "节线",
    "rolling": "滚动接触 滚动 纯滚动",
    "belt": "带传动 皮带 同步带 链传动",
    "crossed": "交叉",
    "pretension": "初拉力",
    "on_line": "沿直线",
    "on_circle": "沿圆",
    "carrier": "行星架 转臂 系杆",
    "pressure_angle": "压力角",
    "follows": "跟随 随动",
    "cam": "凸轮副 凸轮",
    "along": "沿 方向",
    "shape": "形状",
    "preload": "预紧力 预紧",
    "clearances": "间隙",
    "unit": "单位",
    "window": "窗口 时间窗",
    "where": "条件",
    "file": "文件",
    "outputs": "输出 输出量",
    "contributors": "误差源",
    "region": "区域",
    # Studies.
    "cycle": "kinematics kinematic dynamics dynamic motion simulation kinetostatics 运动 运动学 运动循环 循环 运动分析",
    "limits": "range dead_centre dead_center toggle 极限 运动极限 极限位置",
    "modes": "configurations assemblies circuits branches 装配模式 构型",
    "reactions": "statics static structure 约束反力 反力",
    "sweep": "parametric doe variation scan 扫描 参数扫描",
    "accuracy": "tolerance tolerances error errors monte_carlo 精度 公差 误差",
    "workspace": "reach region 工作空间 可达区域",
    "samples": "points steps poses count frames resolution n 点数 采样点 采样点数 采样数",
    "duration": "time length end stop t_end 时间 时长 持续时间",
    "period": "T cycle_time 周期",
    "vary": "parameters variables ranges 变化",
    # Measures and signals.
    "max": "maximum largest peak 最大 最大值 峰值",
    "min": "minimum smallest 最小 最小值",
    "extremes": "range minmax bounds 极值 范围 最大最小",
    "span": "stroke amplitude swing travel 摆角 摆幅 行程",
    "mean": "average avg 平均 平均值 均值",
    "rms": "effective 均方根 有效值",
    "angle": "theta phi rotation orientation 角度 转角 角位移",
    "omega": "speed velocity w angular_velocity 角速度",
    "alpha": "acceleration angular_acceleration 角加速度",
    "x": "position coordinate 横坐标",
    "y": "position coordinate 纵坐标",
    "vx": "velocity speed v",
    "vy": "velocity speed v",
    "ax": "acceleration a",
    "ay": "acceleration a",
    "s": "position displacement travel x 位移 行程",
    "v": "velocity speed 速度",
    "a": "acceleration 加速度",
    # Functions and numbers.
    "asin": "arcsin",
    "acos": "arccos",
    "atan": "arctan",
    "atan2": "arctan2",
    "log": "ln",
    "sqrt": "root",
    "pi": "π 圆周率",
    "t": "time 时间",
    "path": "轨迹",
    "dwell": "休止 停歇",
    "straightness": "直线度",
    "jerk": "跃度",
    "power": "功率",
    # Targets of exports.
    "timestep": "step dt",
    "mjcf": "mujoco xml",
    "motor-expressions": "creo solidworks nx catia adams recurdyn",
    "process-simulate": "siemens tecnomatix csharp",
    # Commands.
    "bench": "benchmark time",
    "check": "validate verify lint test 检查 校核 验证",
    "export": "convert write 导出 输出",
    "new": "init create example examples gallery list template 新建 创建 示例",
    "run": "start simulate solve calc calculate compute execute 运行 计算 求解 仿真",
    "schema": "json 模式",
}


def plain(name: str) -> str:
    """A name without what spellings differ in: case, width of letters, marks between words."""
    folded = unicodedata.normalize("NFKC", name).casefold()
    return "".join(letter for letter in folded if letter not in "-_ ")


_MEANT: dict[str, list[str]] = {}
for _word, _others in _WORDS.items():
    for _other in _others.split():
        _MEANT.setdefault(plain(_other), []).append(_word)


def meant(name: str) -> list[str]:
    """The words of the format that a name stands for elsewhere."""
    return _MEANT.get(plain(name), [])


_UNITS = {
    "mm": "millimeter millimeters millimetre millimetres",
    "cm": "centimeter centimeters centimetre centimetres",
    "m": "meter meters metre metres",
    "um": "micron microns micrometer micrometre",
    "in": "inches zoll",
    "ft": "foot feet",
    "kg": "kilogram kilograms kilo",
    "g": "gram grams gramm",
    "s": "sec secs second seconds sek",
    "ms": "msec millisecond milliseconds",
    "min": "minute minutes",
    "h": "hour hours hr",
    "deg": "degree degrees grad",
    "rad": "radian radians",
    "r": "revs revolution revolutions turns rotation rotations U",
    "N": "newton newtons",
    "kN": "kilonewton",
    "Nm": "newtonmeter",
    "Pa": "pascal",
    "J": "joule joules",
    "W": "watt watts",
    "rpm": "Upm",
}
_UNIT_MEANT = {plain(other): unit for unit, others in _UNITS.items() for other in others.split()}


def unit_meant(word: str) -> str | None:
    """The unit that a word stands for elsewhere, if any: its name written out, in another language, or in capitals."""
    own = plain(word)
    capitals = next((unit for unit in _CAPITALS if own in (plain(unit), f"{plain(unit)}s")), None)
    return _UNIT_MEANT.get(own) or capitals or chinese_unit(own)


_CAPITALS = ("mm", "cm", "kg", "deg", "rad", "rpm", "Hz", "kHz", "kN", "Nm", "MPa", "kPa", "bar", "min", "N", "s")
"""Units that are recognised in other capitals; not those of which two differ in them alone."""
