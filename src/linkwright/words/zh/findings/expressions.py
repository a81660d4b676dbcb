"""Problems of units and expressions."""

PROBLEMS: dict[str, tuple[str, str]] = {
    "units.wrong": (
        "“{word}”不能用作{quantity}的单位。",
        "改写为单位的缩写，例如 {usual}。",
    ),
    "units.unknown": (
        "未知的单位“{word}”。",
        "{hint}",
    ),
    "expression.syntax": (
        "“{text}”不是有效的表达式：{reason}。",
        "使用 + - * / ^ 和括号，例如“2*AB + 5 mm”；因子之间写 *。",
    ),
    "expression.respelled": (
        "“{text}”不是有效的表达式：{reason}。",
        "{hint}",
    ),
    "expression.units-conflict": (
        "“{part}”的单位为 {given}，而此处应为 {wanted}。",
        "改正单位或参数；参数的单位取自其自身的值，或由其他引用处确定。",
    ),
    "expression.units-mixed": (
        "“{part}”混用了单位 {given} 和 {wanted}，这样的值不能相加。",
        "在数值后写明单位，或改正参数；不带单位的参数由其引用处确定单位。",
    ),
    "expression.hertz": (
        "“{part}”表示每秒的次数，无法确定指的是转数还是弧度。",
        "速度写成 rpm、r/s 或 deg/s；在 sin 和 cos 中写 2*pi*{part}*t。",
    ),
    "expression.arguments": (
        "函数 {name} 给出了 {given} 个自变量，而它需要 {wanted} 个。",
        "给出 {wanted} 个自变量，用逗号分隔。",
    ),
    "expression.unknown-function": (
        "没有名为“{name}”的函数、表或运动规律。",
        "{near}否则在 tables 或 laws 中定义它。",
    ),
    "expression.unit-alone": (
        "“{name}”是不带数值的单位，也没有同名的参数。",
        "在其前面写数值，例如“1 {name}”，或在 parameters 中定义 {name}。",
    ),
    "expression.undeclared-unit": (
        "此处的数值没有单位，而 units 中未声明{quantity}的单位（此类数值共 {count} 个）。",
        "在 units 中声明 {base}，或在数值后写明单位。",
    ),
    "expression.odd-unit": (
        "此处不带单位的数值将按 {dimension} 读取，这通常不是本意。",
        "在数值后写明单位。",
    ),
    "expression.not-constant": (
        "“{name}”随机构的运动而变化，而此处应为常数。",
        "只使用数值、参数及其函数。",
    ),
    "expression.ambiguous-unit": (
        "在“{part}”中，“{word}”被读作单位，但有一个同名的参数。",
        "若指参数，将其写在括号中：“*({word})”。若指单位，将该参数改名。",
    ),
    "parameters.cycle": (
        "以下参数循环引用：{cycle}。",
        "将其中一个直接给出数值。",
    ),
    "parameters.value": (
        "“{text}”的值不是有限值：除以零、负数开方，或数值过大。",
        "检查其中所用的数值。",
    ),
    "value.not-finite": (
        "“{text}”的值不是有限值：除以零、负数开方，或数值过大。",
        "检查其中所用的数值和参数。",
    ),
    "value.too-small": (
        "{what}为 {value} {unit}，过小。",
        "给出正值。",
    ),
    "value.rod": (
        "rod 的两个端点 {points} 重合。",
        "使用两个不同的点，或将“rod”改为“point”。",
    ),
    "value.not-rising": (
        "区间 {low} 至 {high} 为空。",
        "先写下限，后写上限。",
    ),
}
