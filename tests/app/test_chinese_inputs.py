"""Wrong inputs as they come from Chinese desks, with the answers: the code, the decisive words in English and in
Chinese, and the right spelling, which is the same in both.

Every model is the sound one with one change; nothing else may be found in it.
"""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from click.testing import CliRunner

from linkwright.app import check
from linkwright.cli import cli
from linkwright.findings import Finding
from linkwright.words import LANGUAGES, in_language

SOUND = """\
linkwright: 1
name: 曲柄摇杆机构
units: {length: mm, angle: deg, mass: kg, time: s, force: N, torque: N*m}
gravity: earth
parameters:
  曲柄长: 60
  连杆长: 190
  摇杆长: 120
links:
  frame: {points: {A: [0, 0], D: [200, 0]}}
  曲柄: {points: {A: [0, 0], B: [曲柄长, 0]}, mass: 0.4, shape: rod A-B}
  连杆: {points: {B: [0, 0], C: [连杆长, 0]}, mass: 0.8, shape: rod B-C}
  摇杆: {points: {D: [0, 0], C: [摇杆长, 0]}, mass: 1.5, shape: rod D-C}
assembly: {C: left of B-D}
drives:
  电机: {turns: 曲柄, on: frame, speed: 60 rpm, start: 0 deg}
tables:
  阻力矩: {file: 阻力矩.csv, x: 时间 s, y: 力矩 N*m}
loads:
  阻力: {on: 摇杆, torque: 阻力矩(t)}
  冲击: {on: 摇杆, at: C, force: [-15, 0]}
windows:
  工作段: {电机.angle: [0, 180]}
measures:
  摆幅: {span: 摇杆.angle}
  驱动力矩: {max: 电机.torque, window: 工作段}
require:
  摆幅: ">= 40 deg"
studies:
  cycle: {turns: 1 电机, samples: 36}
"""
TABLE = "时间,力矩\n0,-3\n0.3,-3\n0.6,-3\n1,-3\n"

KINDS = {
    "wide": ("file.wide", "full-width", "全角"),
    "blank": ("file.blank", "spaces", "空格"),
    "brackets": ("file.brackets", "square brackets", "方括号"),
    "decimal": ("file.decimal-comma", "decimal point", "小数点"),
    "comma": ("expression.respelled", "not a comma", "不能用逗号"),
    "half": ("expression.respelled", "full-width", "全角"),
    "unit": ("expression.respelled", "short names", "缩写"),
    "foreign unit": ("expression.respelled", "isn't supported", "不支持"),
    "speed": ("expression.respelled", "rpm or r/s", "转速"),
    "sense": ("expression.respelled", "direction of rotation", "逆时针为正"),
    "signs": ("expression.respelled", "don't support", "不支持的字符"),
    "minutes": ("expression.respelled", "as a sum", "求和"),
    "powers": ("expression.respelled", "positive powers", "相除"),
    "diameter": ("expression.respelled", "diameter", "直径"),
    "tolerance": ("expression.respelled", "tolerance", "公差"),
    "range": ("expression.respelled", "not a range", "不能是范围"),
    "mark": ("expression.respelled", "by a mark", "撇号"),
    "remark": ("expression.respelled", "aren't part of", "不属于表达式"),
    "factor": ("expression.respelled", "missing between factors", "缺少 *"),
    "dot": ("expression.respelled", "a dot is missing", "缺少点号"),
    "base unit": ("units.wrong", "isn't a unit of", "的单位"),
    "key": ("file.unknown-key", "Unknown key", "未知的键"),
    "name": ("name.unknown", "isn't a link", "构件"),
    "parameter": ("name.unknown-parameter", "no parameter", "参数"),
    "study": ("study.unknown", "no study", "分析"),
    "signal": ("signal.no-attribute", "isn't a signal", "信号"),
    "function": ("expression.unknown-function", "no function", "函数"),
    "form": ("file.expected", "Expected", "应为"),
    "frame": ("model.no-frame", "frame", "机架"),
}
"""The code of each kind of answer, and the decisive words of its description."""

INPUTS = [
    # Full-width punctuation, digits and letters, where YAML reads them.
    ("wide", "曲柄长: 60", "曲柄长：60", "曲柄长: 60"),
    ("wide", "曲柄长: 60", "曲柄长： 60", "曲柄长: 60"),
    ("wide", "曲柄长: 60", "曲柄长＝60", "曲柄长: 60"),
    ("wide", "曲柄长: 60", "曲柄长: ６０", "曲柄长: 60"),
    ("wide", "曲柄长: 60", "曲柄长: 60．5", "曲柄长: 60.5"),
    ("wide", "曲柄长: 60", "曲柄长: 60。5", "曲柄长: 60.5"),
    ("wide", "曲柄长: 60", "曲柄长: 60，5", "曲柄长: 60.5"),
    ("wide", "曲柄长: 60", "曲柄长: （20＋40）", "曲柄长: (20+40)"),
    ("wide", "曲柄长: 60", "曲柄长: 100－40", "曲柄长: 100-40"),
    ("wide", "曲柄长: 60", "曲柄长: 30＊2", "曲柄长: 30*2"),
    ("wide", "曲柄长: 60", "曲柄长: 120／2", "曲柄长: 120/2"),
    ("wide", "曲柄长: 60", "曲柄长: 6000％", "曲柄长: 6000%"),
    ("wide", "曲柄长: 60", "曲柄长: 60ｍｍ", "曲柄长: 60mm"),
    ("wide", "曲柄长: 60", "曲柄长: “60”", '曲柄长: "60"'),
    ("wide", "曲柄长: 60", "曲柄长: ‘60’", "曲柄长: '60'"),
    ("wide", "曲柄长: 60", "曲柄长: 60＃毫米", "曲柄长: 60  # 毫米"),
    ("wide", "曲柄长: 60", "曲柄长：60；", "曲柄长: 60"),
    ("wide", "曲柄长: 60", "曲柄长: {value: 60，tolerance: 0.05}", "{value: 60, tolerance: 0.05}"),
    ("wide", "linkwright: 1", "linkwright：1", "linkwright: 1"),
    ("wide", "studies:", "studies：", "studies:"),
    ("wide", "units: {", "units：｛", "units: {length: mm"),
    ("wide", "[曲柄长, 0]", "[曲柄长，0]", "[曲柄长, 0]"),
    ("wide", "[曲柄长, 0]", "[曲柄长、0]", "[曲柄长, 0]"),
    ("wide", "[曲柄长, 0]", "【曲柄长, 0】", "[曲柄长, 0]"),
    ("wide", "[曲柄长, 0]", "（曲柄长，0）", "[曲柄长, 0]"),
    ("wide", "[-15, 0]", "[－15, 0]", "[-15, 0]"),
    ("wide", "[-15, 0]", "[—15, 0]", "[-15, 0]"),
    ("wide", "mass: 0.4", "mass：0.4", "mass: 0.4"),
    ("wide", "mass: 0.4", "mass: 0，4", "mass: 0.4"),
    ("wide", "span: 摇杆.angle", "span: 摇杆．angle", "span: 摇杆.angle"),
    ("wide", "max: 电机.torque", "max: abs（电机.torque）", "max: abs(电机.torque)"),
    ("wide", '">= 40 deg"', "＞＝40", '">=40"'),
    ("wide", "left of B-D", "left of B－D", "left of B-D"),
    ("wide", "samples: 36", "samples: ３６", "samples: 36"),
    ("blank", "  曲柄长: 60", "　　曲柄长: 60", "曲柄长: 60"),
    ("blank", "曲柄长: 60", "曲柄长:\u00a060", "曲柄长: 60"),
    ("brackets", "[-15, 0]", "(-15, 0)", "[-15, 0]"),
    ("decimal", "mass: 0.4", "mass: 0,4", "0.4"),
    # The same within quotes, where only the expression knows of them.
    ("half", "[曲柄长, 0]", '["hypot（曲柄长，0）", 0]', "hypot(曲柄长,0)"),
    ("half", "曲柄长: 60", '曲柄长: "６０"', "60"),
    ("comma", "曲柄长: 60", "曲柄长: 60,5", "60.5"),
    # Signs of print.
    ("signs", "曲柄长: 60", "曲柄长: 120÷2", "120/2"),
    ("signs", "曲柄长: 60", "曲柄长: √3600", "sqrt(3600)"),
    ("signs", "曲柄长: 60", "曲柄长: 60 ㎜", "60 mm"),
    ("signs", "mass: 0.4", "mass: 0.4 ㎏", "0.4 kg"),
    ("signs", "start: 0 deg", "start: π/6", "pi/6"),
    ("signs", "start: 0 deg", "start: 30º", "30°"),
    ("signs", "gravity: earth", "gravity: [0, -9.8 m/s²]", "-9.8 m/s^2"),
    ("signs", "speed: 60 rpm", "speed: 2π rad/s", "2*pi*(1 rad/s)"),
    ("signs", "speed: 60 rpm", "speed: 6.28 rad·s⁻¹", "6.28 rad/s"),
    ("powers", "speed: 60 rpm", "speed: 6.28 rad*s^-1", "6.28 rad/s"),
    ("minutes", "start: 0 deg", "start: 30°15′20″", "30 deg + 15 arcmin + 20 arcsec"),
    ("minutes", "start: 0 deg", "start: 30度15分", "30 deg + 15 arcmin"),
    ("mark", "start: 0 deg", "start: 30′", "30 arcmin"),
    ("diameter", "曲柄长: 60", "曲柄长: φ60", "60"),
    ("diameter", "曲柄长: 60", "曲柄长: φ60H7", "{value: 60, tolerance: H7}"),
    ("tolerance", "曲柄长: 60", "曲柄长: 60±0.05", "{value: 60, tolerance: 0.05}"),
    ("range", "曲柄长: 60", "曲柄长: 60～62", "62"),
    ("remark", "曲柄长: 60", "曲柄长: 60 mm（中心距）", "60 mm  # 中心距"),
    ("factor", "曲柄长: 60", "曲柄长: 2连杆长", "2*连杆长"),
    ("factor", "曲柄长: 60", "曲柄长: 60（中心距）", "60  # 中心距"),
    # Units in Chinese and as Chinese drawings have them.
    ("unit", "曲柄长: 60", "曲柄长: 60毫米", "60 mm"),
    ("unit", "曲柄长: 60", "曲柄长: 6厘米", "6 cm"),
    ("unit", "曲柄长: 60", "曲柄长: 0.06米", "0.06 m"),
    ("unit", "曲柄长: 60", "曲柄长: 60 MM", "60 mm"),
    ("unit", "mass: 0.4", "mass: 0.4公斤", "0.4 kg"),
    ("unit", "mass: 0.4", "mass: 0.4千克", "0.4 kg"),
    ("unit", "mass: 0.4", "mass: 400克", "400 g"),
    ("unit", "mass: 0.4", "mass: 0.4 KG", "0.4 kg"),
    ("foreign unit", "mass: 0.4", "mass: 0.8斤", "0.8*0.5 kg"),
    ("foreign unit", "曲柄长: 60", "曲柄长: 6000丝", "6000*0.01 mm"),
    ("unit", "[-15, 0]", "[-15牛, 0]", "-15 N"),
    ("unit", "[-15, 0]", "[-15牛顿, 0]", "-15 N"),
    ("unit", "[-15, 0]", "[-1.5公斤力, 0]", "-1.5 kgf"),
    ("unit", "阻力矩(t)", "阻力矩(t) - 1 牛·米", "阻力矩(t) - 1 N*m"),
    ("unit", "阻力矩(t)", "阻力矩(t) - 1 牛顿米", "阻力矩(t) - 1 N*m"),
    ("unit", "阻力矩(t)", "阻力矩(t) - 1 N.m", "阻力矩(t) - 1 N*m"),
    ("unit", "阻力矩(t)", "阻力矩(t) - 1 兆帕*(1 mm^3)", "阻力矩(t) - 1 MPa*(1 mm^3)"),
    ("unit", "阻力矩(t)", "阻力矩(t) - 1 N*mm2/(1 mm)", "阻力矩(t) - 1 N*mm^2/(1 mm)"),
    ("unit", "gravity: earth", "gravity: [0, -9.8 m/s2]", "-9.8 m/s^2"),
    ("unit", "gravity: earth", "gravity: [0, -9.8 米每二次方秒]", "-9.8 m/s^2"),
    ("unit", "start: 0 deg", "start: 30度", "30 deg"),
    ("unit", "start: 0 deg", "start: 0.5弧度", "0.5 rad"),
    ("unit", "speed: 60 rpm", "speed: 60 RPM", "60 rpm"),
    ("unit", "speed: 60 rpm", "speed: 360 度/秒", "360 deg/s"),
    ("unit", "speed: 60 rpm", "speed: 6.28 弧度每秒", "6.28 rad/s"),
    ("unit", "speed: 60 rpm", "speed: 1 赫兹", "1 Hz"),
    ("speed", "speed: 60 rpm", "speed: 60转/分", "60 rpm"),
    ("speed", "speed: 60 rpm", "speed: 60 转/分钟", "60 rpm"),
    ("speed", "speed: 60 rpm", "speed: 60转每分钟", "60 rpm"),
    ("speed", "speed: 60 rpm", "speed: 每分钟60转", "60 rpm"),
    ("speed", "speed: 60 rpm", "speed: 60 圈/分", "60 rpm"),
    ("speed", "speed: 60 rpm", "speed: 1 转/秒", "1 r/s"),
    ("wide", "speed: 60 rpm", "speed: 60 转／分", "60 rpm"),
    ("sense", "speed: 60 rpm", "speed: 60 rpm 顺时针", "-60 rpm"),
    ("half", "speed: 60 rpm", "speed: 60 rpm（逆时针）", "60 rpm"),
    ("unit", "turns: 1 电机", "duration: 1 秒", "1 s"),
    ("base unit", "length: mm", "length: 毫米", "mm"),
    ("base unit", "length: mm", "length: 厘米", "cm"),
    ("base unit", "angle: deg", "angle: 度", "deg"),
    ("base unit", "mass: kg", "mass: 公斤", "kg"),
    ("base unit", "time: s", "time: 秒", "s"),
    ("base unit", "force: N", "force: 牛", "N"),
    ("base unit", "torque: N*m", "torque: 牛·米", "N*m"),
    ("base unit", "torque: N*m", "torque: N·m", "N*m"),
    ("base unit", "torque: N*m", "torque: N.m", "N*m"),
    # Keys, names and words of the format in Chinese.
    ("key", "links:", "构件:", "links"),
    ("key", "parameters:", "参数:", "parameters"),
    ("key", "drives:", "驱动:", "drives"),
    ("key", "loads:", "载荷:", "loads"),
    ("key", "measures:", "测量项:", "measures"),
    ("key", "require:", "要求:", "require"),
    ("key", "speed: 60 rpm", "转速: 60 rpm", "speed"),
    ("key", "mass: 0.4", "质量: 0.4", "mass"),
    ("key", "shape: rod A-B", "形状: rod A-B", "shape"),
    ("key", "span: 摇杆.angle", "行程: 摇杆.angle", "span"),
    ("key", "max: 电机", "最大值: 电机", "max"),
    ("key", "samples: 36", "采样点数: 36", "samples"),
    ("study", "cycle: {", "运动循环: {", "cycle"),
    ("frame", "  frame:", "  机架:", "frame"),
    ("name", "on: frame", "on: 机架", "frame"),
    ("name", "turns: 曲柄", "turns: 曲柄1", "曲柄"),
    ("parameter", "[曲柄长, 0]", "[曲柄, 0]", "曲柄长"),
    ("signal", "摇杆.angle", "摇杆.角度", "angle"),
    ("dot", "max: 电机.torque", "max: 电机的torque", "电机.torque"),
    ("function", "阻力矩(t)", "阻力距(t)", "阻力矩"),
    ("form", "gravity: earth", "gravity: 地球", "earth"),
    ("form", "shape: rod A-B", "shape: 匀质杆 A-B", "rod A-B"),
    ("form", "left of B-D", "B-D左侧", "left of B-D"),
    ("form", "[0, 180]", "0～180度", "[0, 180度]"),
    ("form", '">= 40 deg"', '"≥40度"', ">= 40 deg"),
    ("form", '">= 40 deg"', '"＞＝ 40 deg"', ">= 40 deg"),
    ("form", '">= 40 deg"', '"不小于 40 度"', ">= 40 deg"),
    ("form", '">= 40 deg"', '"40～60 deg"', "40 .. 60 deg"),
]


def folder(where: Path, model: bytes, table: bytes = TABLE.encode()) -> Path:
    """A folder with a model and its table; the model's path."""
    (where / "阻力矩.csv").write_bytes(table)
    (path := where / "曲柄摇杆机构.yaml").write_bytes(model)
    return path


def answered(found: Finding, words: tuple[str, str], meant: str) -> None:
    """Its description holds a word in each language, its fix what is meant."""
    for language, word in zip(LANGUAGES, words, strict=True):
        with in_language(language):
            assert word in found.what, found.what
            assert not meant or re.search(rf"(?<![\w.]){re.escape(meant)}(?!\w)", found.mend), found.mend


def test_the_sound_model_is_sound(tmp_path: Path) -> None:
    assert not check(folder(tmp_path, SOUND.encode()))


def test_there_are_enough_of_them_and_each_kind_is_there() -> None:
    assert len(INPUTS) >= 60
    assert {kind for kind, *_ in INPUTS} == KINDS.keys()


@pytest.mark.parametrize(("kind", "old", "new", "meant"), INPUTS, ids=[new for _, _, new, _ in INPUTS])
def test_the_answer_names_the_place_and_the_right_spelling(
    kind: str, old: str, new: str, meant: str, tmp_path: Path
) -> None:
    assert old in SOUND
    code, *words = KINDS[kind]
    (found,) = (f for f in check(folder(tmp_path, SOUND.replace(old, new, 1).encode())) if f.severity == "error")
    assert found.code == code, found
    assert kind in ("frame",) or found.line == 1 + SOUND.split(old)[0].count("\n")
    answered(found, (words[0], words[1]), meant)


RIGHT = [
    ("speed: 60 rpm", "speed: 60 r/min"),
    ("speed: 60 rpm", "speed: 60 rev/min"),
    ("speed: 60 rpm", "speed: 360°/s"),
    ("[-15, 0]", "[-1.5 kgf, 0]"),
    ("[-15, 0]", "[−15, 0]"),
    ("阻力矩(t)", "阻力矩(t) - 1 Nm"),
    ("torque: N*m", "torque: Nm"),
    ("曲柄长: 60", "曲柄长: 30×2"),
    ("曲柄长: 60", "曲柄长: 60  # 单位：毫米（图 2－1）"),
    ("name: 曲柄摇杆机构", "name: 曲柄摇杆机构（方案１）——“试制”，２０２６"),
    ("name: 曲柄摇杆机构", "name: ２０２６"),
]


@pytest.mark.parametrize(("old", "new"), RIGHT, ids=[new for _, new in RIGHT])
def test_what_is_right_stays_right(old: str, new: str, tmp_path: Path) -> None:
    assert not check(folder(tmp_path, SOUND.replace(old, new, 1).encode()))


FILES = [
    ("utf-16", "file.read-as", ("read as UTF-16", "按 UTF-16 读取")),
    ("gbk", "file.read-as", ("read as GBK", "按 GBK 读取")),
    ("gb18030", "file.read-as", ("read as GBK", "按 GBK 读取")),
    ("utf-16-le", "file.encoding", ("looks like UTF-16", "可能是 UTF-16")),
    ("big5", "file.encoding", ("isn't valid UTF-8", "不是有效的 UTF-8")),
]


@pytest.mark.parametrize(("encoding", "code", "words"), FILES)
def test_a_model_in_another_encoding(encoding: str, code: str, words: tuple[str, str], tmp_path: Path) -> None:
    text = SOUND if encoding != "big5" else "linkwright: 1\nname: 曲柄搖桿機構\n"
    (found,) = check(folder(tmp_path, text.encode(encoding)))
    assert (found.code, found.severity == "error") == (code, code == "file.encoding")
    answered(found, words, "UTF-8")


def test_a_model_with_one_chinese_word_in_gbk(tmp_path: Path) -> None:
    text = "linkwright: 1\nname: 压力机\nlinks: {frame: {points: {A: [0, 0]}}}\n"
    assert "file.read-as" in [one.code for one in check(folder(tmp_path, text.encode("gbk")))]


TABLES = [
    (TABLE.encode("gbk"), "", ("", ""), ""),
    (TABLE.encode("utf-16"), "", ("", ""), ""),
    (TABLE.encode("utf-8-sig"), "", ("", ""), ""),
    (TABLE.encode("utf-16-le"), "table.encoding", ("UTF-16", "UTF-16"), "UTF-8"),
    (TABLE.replace(",", "，").encode(), "table.separator", ("commas are expected", "应为半角逗号"), ""),
    (TABLE.replace(",", "\t").encode("utf-16"), "table.separator", ("commas are expected", "应为半角逗号"), ""),
    (TABLE.replace("力矩", "扭矩").encode(), "table.no-column", ("no column '力矩'", "没有“力矩”列"), ""),
    (TABLE.replace("-3", "－3", 1).encode(), "table.not-number", ("'－3'", "“－3”"), ""),
    (TABLE.replace("-3", "-3 牛米", 1).encode(), "table.not-number", ("'-3 牛米'", "“-3 牛米”"), ""),
]


@pytest.mark.parametrize(("content", "code", "words", "meant"), TABLES)
def test_a_table_from_a_spreadsheet(
    content: bytes, code: str, words: tuple[str, str], meant: str, tmp_path: Path
) -> None:
    found = check(folder(tmp_path, SOUND.encode(), content))
    assert [f.code for f in found] == [code] * bool(code)
    for one in found:
        answered(one, words, meant)


WORDS = [
    (["—out"], "an option begins with two hyphens: --out", "选项应以两个半角连字符开头：--out"),
    (["－－open"], "an option begins with two hyphens: --open", "选项应以两个半角连字符开头：--open"),
]


@pytest.mark.parametrize(("words", "english", "chinese"), WORDS)
def test_hyphens_of_a_chinese_keyboard(words: list[str], english: str, chinese: str, tmp_path: Path) -> None:
    path = folder(tmp_path, SOUND.encode())
    for language, answer in zip(LANGUAGES, (english, chinese), strict=True):
        result = CliRunner().invoke(cli, ["run", str(path), *words, "--lang", language])
        assert result.exit_code == 2
        with in_language(language):
            assert answer in CliRunner().invoke(cli, ["run", str(path), *words]).output


@pytest.mark.parametrize(("word", "command"), [("运行", "run"), ("检查", "check"), ("导出", "export")])
def test_a_command_in_chinese(word: str, command: str) -> None:
    result = CliRunner().invoke(cli, [word, "模型.yaml"])
    assert result.exit_code == 2 and f"'{command}'" in result.output
