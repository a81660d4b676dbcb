"""Models in other encodings than UTF-8: read where nothing can be mistaken, else refused by the encoding's name."""

from __future__ import annotations

import random
from pathlib import Path

import pytest

import linkwright as lw
from linkwright.app import examine_file, modes_of_file
from linkwright.findings import Finding
from linkwright.model.document import read_document
from linkwright.model.encodings import decoded
from model.given import FEEDER

NAME = "送料机构的曲柄与摇杆"
CHINESE = FEEDER.replace("Packaging paper feeder", NAME)


def findings(raw: bytes) -> list[Finding]:
    return read_document(raw)[1].findings


@pytest.mark.parametrize(
    ("encoding", "name", "severity"),
    [
        ("gbk", "GBK", "warning"),
        ("gb18030", "GBK", "warning"),
        ("gb2312", "GBK", "warning"),
        ("utf-16", "UTF-16", "note"),
    ],
)
def test_chinese_in_another_encoding_is_read_and_reported(encoding: str, name: str, severity: str) -> None:
    document, source = read_document(CHINESE.encode(encoding))
    assert document is not None and document.name == NAME
    (remark,) = source.remarks
    assert (remark.code, remark.severity, remark.line) == ("file.read-as", severity, 1)
    assert name in remark.what and "UTF-8" in remark.mend


def test_utf_16_of_either_order_is_read() -> None:
    for mark, encoding in ((b"\xfe\xff", "utf-16-be"), (b"\xff\xfe", "utf-16-le")):
        assert decoded(mark + CHINESE.encode(encoding)) == (CHINESE, "UTF-16", True)


def test_utf_8_with_and_without_its_mark_is_no_remark() -> None:
    for encoding in ("utf-8", "utf-8-sig"):
        document, source = read_document(CHINESE.encode(encoding))
        assert document is not None and not source.remarks


def test_lines_of_other_faults_are_those_of_the_text() -> None:
    (found,) = findings(CHINESE.replace("start:", "strat:").encode("gbk"))
    assert found.code == "file.unknown-key"
    assert found.line == 1 + CHINESE.split("start:")[0].count("\n")


@pytest.mark.parametrize(
    ("text", "encoding", "name"),
    [
        ("牛头刨床", "gbk", "GBK"),  # too little to be sure
        ("曲柄搖桿機構的運動", "gbk", ""),  # halves of characters that are punctuation of YAML in other encodings
        (NAME, "utf-16-le", "UTF-16"),  # without the mark
        ("Größe, Übermaß", "cp1252", "Windows-1252"),
        ("30°", "cp1252", "Windows-1252"),
        ("Hüllkurve für µm", "cp1252", "Windows-1252"),
        ("façade à", "cp1252", "Windows-1252"),
        ("曲柄搖桿機構的位置與速度", "big5", ""),
        ("크랭크 기구의 길이와 각도, 속도", "euc-kr", ""),
        ("クランク機構の位置と速度、角度と長さ", "euc-jp", ""),
        ("クランク機構の位置と速度", "shift-jis", ""),
        ("кривошипно ползунный механизм", "koi8-r", ""),
        ("кривошипно ползунный механизм", "cp1251", ""),
        ("μηχανισμός θέση ταχύτητα", "cp1253", ""),
    ],
)
def test_what_may_be_mistaken_is_refused(text: str, encoding: str, name: str) -> None:
    (found,) = findings(f"linkwright: 1\nname: {text}\n".encode(encoding))
    assert found.code in ("file.encoding", "file.binary") and found.line == 2
    assert name in found.what and "UTF-8" in found.mend


@pytest.mark.parametrize("name", ["机构", "曲柄", "压力机", "四杆机构"])
def test_a_short_chinese_word_is_enough(name: str) -> None:
    assert decoded(f"linkwright: 1\nname: {name}\n".encode("gbk")) is not None


@pytest.mark.parametrize(
    ("text", "encoding", "chinese"),
    [
        ("привод", "koi8-r", "幸勺夏"),
        ("ВАЛ И РЫЧАГ", "cp1251", ""),
        ("크랭크", "euc-kr", "农珐农"),
        ("기구", "euc-kr", "扁备"),
        ("位置", "euc-jp", "疤弥"),
        ("長", "euc-jp", "墓"),
    ],
)
def test_common_characters_alone_are_no_sign_of_chinese(text: str, encoding: str, chinese: str) -> None:
    """So a text of a few characters that aren't :data:`_OF_MECHANISMS` is refused."""
    raw = text.encode(encoding)
    assert not chinese or raw.decode("gb18030") == chinese
    assert decoded(b"name: " + raw + b"\n") is None


def test_what_is_no_text_at_all() -> None:
    assert [f.code for f in findings(b"\x7fELF\x00\xff\xfe\x81")] == ["file.binary"]
    assert [f.code for f in findings(b"\xff\xfe" + "a: \x00".encode("utf-16-le"))] == ["file.encoding"]
    assert [f.code for f in findings(b"\xff\xfea")] == ["file.encoding"]


def test_korean_and_random_texts_are_hardly_ever_taken_for_chinese() -> None:
    """Every pair of bytes of a Korean text is a common Chinese character as well."""
    draw = random.Random(7)
    leads, halves = range(0xB0, 0xC9), range(0xA1, 0xFF)
    taken = 0
    for _ in range(1000):
        words = [
            bytes(draw.choice(half) for _ in range(draw.randint(1, 4)) for half in (leads, halves)) for _ in "12345"
        ]
        taken += decoded(b" ".join(words)) is not None
    assert taken <= 10


def test_short_korean_words_are_hardly_ever_taken_for_chinese() -> None:
    draw, taken = random.Random(7), 0
    for _ in range(2000):
        pairs = [(draw.randrange(0xB0, 0xC9), draw.randrange(0xA1, 0xFF)) for _ in range(draw.randint(1, 3))]
        taken += decoded(b"name: " + bytes(half for pair in pairs for half in pair)) is not None
    assert taken <= 20


def test_the_remark_goes_with_the_results(tmp_path: Path) -> None:
    (path := tmp_path / "模型.yaml").write_bytes(CHINESE.encode("gbk"))
    (found,) = (f for f in lw.check(path) if f.severity == "warning")
    assert found.code == "file.read-as"
    job = lw.run(path, tmp_path / "结果")
    assert job.exit_code == 0 and "file.read-as" in [f["code"] for f in job.summary["findings"]]
    assert NAME in (tmp_path / "结果" / "report.html").read_text("utf-8")
    assert "file.read-as" in [f.code for f in modes_of_file(path).examined.findings]
    assert examine_file(path).exit_code == 0


def test_load_warns(tmp_path: Path) -> None:
    (path := tmp_path / "model.yaml").write_bytes(CHINESE.encode("gbk"))
    with pytest.warns(UserWarning, match="read as GBK"):
        assert lw.load(path).name == NAME
