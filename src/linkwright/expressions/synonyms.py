"""What words of the format are called elsewhere: in other programs, in books, in Chinese.

Each row has a word of the format and those that stand for it, of keys, elements, signals, functions, targets and
commands alike: a hint takes only words that can stand at its place.
"""

from __future__ import annotations

import unicodedata

from linkwright.expressions.chinese_units import chinese_unit

_WORDS = {
    "frame": "ground base fixed fix chassis world bed housing 机架 机座 基座 固定件 地面 地",
    # Sections.
    "assembly": "mode configuration branch 装配",
    "drives": "inputs input 驱动 原动件",
    "exports": "outputs",
    "joints": "constraints connections couplings pairs kinematic_pairs 运动副 关节",
    "linkwright": "version format",
    "links": "bodies body parts part members member bars bar elements 构件 杆件",
    "loads": "forces external_forces 载荷 力",
    "measures": "outputs output results result sensors probes 测量",
    "name": "title 名称",
    "note": "description comment comments notes 备注 说明",
    "parameters": "variables variable constants dimensions dimension 参数 变量",
    "require": "limits constraints conditions specs 要求",
    "sketch": "coordinates nodes positions layout 草图",
    "studies": "analysis analyses simulation simulations solver calculation 分析",
    "units": "单位",
    # Joints, drives, loads.
    "revolute": "links bodies between hinge pin pivot rotational rotary rotation turning R 转动副 铰链",
    "prismatic": "links bodies between slider slide sliding translational translation linear P 移动副 滑动副",
    "turns": "rotates rotate rotation revolute link body 转动",
    "slides": "moves translates translate prismatic 移动",
    "extends": "cylinder actuator pushes stroke 伸缩",
    "speed": "omega velocity rate rpm angular_velocity frequency w 速度 转速 角速度",
    "start": "initial angle offset phase initial_angle phi0 theta0 初始角",
    "position": "law motion profile function",
    "acceleration": "alpha 加速度",
    "on": "link body to parent relative_to",
    "at": "point location place",
    "line": "axis direction along",
    "from": "start begin first point1 low min minimum",
    "to": "end last second point2 high max maximum",
    "count": "steps number n points samples",
    "torque": "moment couple M T 力矩 扭矩",
    "force": "F load reaction 力",
    # Links, springs, parameters.
    "points": "nodes pins joints vertices coordinates 点",
    "mass": "m weight 质量",
    "inertia": "J I moment_of_inertia 转动惯量",
    "com": "cog centre center centre_of_mass center_of_mass centroid 质心",
    "stiffness": "k rate constant spring_constant c 刚度",
    "free": "l0 free_length natural_length relaxed rest_length length 原长",
    "damping": "b c d damping_constant 阻尼",
    "value": "nominal val",
    "tolerance": "tol tolerances deviation 公差",
    # Studies.
    "cycle": "kinematics kinematic dynamics dynamic motion simulation kinetostatics 运动 运动学",
    "limits": "range dead_centre dead_center toggle",
    "modes": "configurations assemblies circuits branches",
    "reactions": "statics static structure",
    "sweep": "parametric doe variation scan",
    "accuracy": "tolerance tolerances error errors monte_carlo 精度 公差",
    "workspace": "reach region 工作空间",
    "samples": "points steps poses count frames resolution n 点数",
    "duration": "time length end stop t_end 时间",
    "period": "T cycle_time 周期",
    "vary": "parameters variables ranges",
    # Measures and signals.
    "max": "maximum largest peak 最大",
    "min": "minimum smallest 最小",
    "extremes": "range minmax bounds",
    "span": "stroke amplitude swing travel",
    "mean": "average avg 平均",
    "rms": "effective",
    "angle": "theta phi rotation orientation 角度 转角",
    "omega": "speed velocity w angular_velocity 角速度",
    "alpha": "acceleration angular_acceleration 角加速度",
    "x": "position coordinate",
    "y": "position coordinate",
    "vx": "velocity speed v",
    "vy": "velocity speed v",
    "ax": "acceleration a",
    "ay": "acceleration a",
    "s": "position displacement travel x",
    "v": "velocity speed",
    "a": "acceleration",
    # Functions and numbers.
    "asin": "arcsin",
    "acos": "arccos",
    "atan": "arctan",
    "atan2": "arctan2",
    "log": "ln",
    "sqrt": "root",
    "pi": "π 圆周率",
    "t": "time 时间",
    # Targets of exports.
    "timestep": "step dt",
    "mjcf": "mujoco xml",
    "motor-expressions": "creo solidworks nx catia adams recurdyn",
    "process-simulate": "siemens tecnomatix csharp",
    # Commands.
    "bench": "benchmark time",
    "check": "validate verify lint test",
    "export": "convert write",
    "new": "init create example examples gallery list template",
    "run": "start simulate solve calc calculate compute execute",
    "schema": "json",
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
