"""Units by their Chinese names, with the words that stand for powers and quotients: 毫米每秒, 牛顿米, 千克平方米."""

from __future__ import annotations

import re

_NAMES = {
    "m": "米 公尺", "dm": "分米", "cm": "厘米 公分", "mm": "毫米 公厘", "um": "微米", "nm": "纳米", "km": "千米 公里",
    "in": "英寸 吋", "ft": "英尺 呎", "kg": "千克 公斤", "g": "克", "mg": "毫克", "tonne": "吨 公吨", "lb": "磅",
    "s": "秒 秒钟", "ms": "毫秒", "us": "微秒", "min": "分 分钟", "h": "时 小时", "rad": "弧度", "mrad": "毫弧度",
    "deg": "度 角度", "arcmin": "角分 弧分", "arcsec": "角秒 弧秒", "r": "转 圈", "Hz": "赫兹 赫", "kHz": "千赫兹 千赫",
    "N": "牛顿 牛", "mN": "毫牛", "kN": "千牛顿 千牛", "MN": "兆牛", "kgf": "公斤力 千克力", "lbf": "磅力",
    "Pa": "帕斯卡 帕", "hPa": "百帕", "kPa": "千帕", "MPa": "兆帕", "GPa": "吉帕", "bar": "巴", "mbar": "毫巴",
    "J": "焦耳 焦", "mJ": "毫焦", "kJ": "千焦", "W": "瓦特 瓦", "mW": "毫瓦", "kW": "千瓦",
}  # fmt: skip
_UNIT_OF = {name: unit for unit, names in _NAMES.items() for name in names.split()}
_POWERS = {"平方": "^2", "二次方": "^2", "立方": "^3", "三次方": "^3"}
_POWER = "|".join(_POWERS)
_ONE = re.compile(rf"({_POWER})?({'|'.join(sorted(_UNIT_OF, key=len, reverse=True))})")


def chinese_unit(word: str) -> str | None:
    """The unit that a Chinese word stands for, if it does for one."""
    over, *under = (_product(part) for part in word.split("每"))
    return None if None in (over, *under) else "/".join([over or "", *map(str, under)])


def _product(word: str) -> str | None:
    """Units one after the other, each with a power before it."""
    if not word or _ONE.sub("", word):
        return None
    return "*".join(_UNIT_OF[name] + _POWERS.get(power, "") for power, name in _ONE.findall(word))
