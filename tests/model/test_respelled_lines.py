"""Lines in the spellings of other places."""

from __future__ import annotations

import pytest

from linkwright.findings import Finding, Term
from linkwright.model.respelled_lines import LONGEST, ROUNDS, read_respelled
from model.given import FEEDER, findings
from model.given import changed as changed_in

_FLOW = "{AB: 155, BC: 395, CD: 300, DE: 500, AD: 300, AH: 580}"
BLOCK = FEEDER.replace(_FLOW, "\n  " + _FLOW[1:-1].replace(", ", "\n  "))


def changed(*pairs: tuple[str, str]) -> str:
    """The paper feeder with a line for each parameter, some of its text replaced."""
    return changed_in(*pairs, text=BLOCK)


LINES = {
    "colon of a block": (("AB: 155", "AB：155"), "file.wide", "Write 'AB: 155'."),
    "colon in braces": (("mass: 0.6, shape", "mass：0.6, shape"), "file.wide", "mass: 0.6, shape"),
    "comma": (("B: [AB, 0]", "B: [AB，0]"), "file.wide", "[AB, 0]"),
    "bracket": (("D: [AD, 0]", "D: [（AD）, 0]"), "file.wide", "[(AD), 0]"),
    "brackets": (("B: [AB, 0]", "B: 【AB, 0】"), "file.wide", "[AB, 0]"),
    "digits": (("AB: 155", "AB: １５５"), "file.wide", "Write 'AB: 155'."),
    "no space": (("AB: 155", "AB:155"), "file.colon", "Write 'AB: 155'."),
    "no space in braces": (("mass: 0.6, shape", "mass:0.6, shape"), "file.colon", "mass: 0.6, shape"),
    "equals": (("AB: 155", "AB = 155"), "file.equals", "Write 'AB: 155'."),
    "tab": (("  AB: 155", "\tAB: 155"), "file.tab", "spaces"),
    "tab behind a colon": (("AB: 155", "AB:\t155"), "file.tab", "spaces"),
    "decimal comma": (("mass: 0.6", "mass: 0,6"), "file.decimal-comma", "Write 0.6."),
    "decimal comma in a list": (("D: [AD, 0]", "D: [60,5, 0]"), "file.decimal-comma", "Write 60.5."),
    "wide decimal comma": (("mass: 0.6", "mass: 0，6"), "file.wide", "mass: 0.6,"),
    "wide comma between numbers of a list": (("D: [AD, 0]", "D: [60，5]"), "file.wide", "D: [60, 5]"),
    "list in round brackets": (("D: [AD, 0]", "D: （AD，0）"), "file.wide", "D: [AD, 0]"),
    "list in narrow round brackets": (("D: [AD, 0]", "D: (AD, 0)"), "file.brackets", "Write [AD, 0]."),
    "enumeration comma": (("B: [AB, 0]", "B: [AB、0]"), "file.wide", "[AB, 0]"),
    "semicolon in a list": (("B: [AB, 0]", "B: [AB；0]"), "file.wide", "[AB, 0]"),
    "corner quotes": (("AB: 155", "AB: 「155」"), "file.wide", "Write 'AB: \"155\"'."),
    "dash": (("D: [AD, 0]", "D: [—AD, 0]"), "file.wide", "D: [-AD, 0]"),
    "comment": (("AB: 155", "AB: 155＃长"), "file.wide", "Write 'AB: 155  # 长'."),
    "end of a sentence": (("AB: 155", "AB：155。"), "file.wide", "Write 'AB: 155'."),
    "indentation": (("  AB: 155", "\u3000\u3000AB: 155"), "file.blank", "Write 'AB: 155'."),
    "blank of a web page": (("AB: 155", "AB:\u00a0155"), "file.blank", "Write 'AB: 155'."),
    "digits of an option": (("samples: 200", "samples: ２００"), "file.wide", "samples: 200"),
}


@pytest.mark.parametrize("name", LINES)
def test_the_spelling_is_the_finding(name: str) -> None:
    change, code, hint = LINES[name]
    (found,) = findings(changed(change))
    assert found.code == code and hint in found.mend
    assert found.line == 1 + changed(change).split(change[1])[0].count("\n")


def test_all_of_them_at_once_and_what_else_is_wrong() -> None:
    text = changed(
        ("AB: 155", "AB：155"), ("B: [AB, 0]", "B: [AB，0]"), ("start:", "strat:"), ("mass: 1.5", "mass:1.5")
    )
    assert sorted(f.code for f in findings(text)) == ["file.colon", "file.unknown-key", "file.wide", "file.wide"]


def test_chinese_punctuation_in_texts_and_comments_is_no_fault() -> None:
    text = changed(("linkwright: 1\n", "linkwright: 1\nnote: '长：宽，高'  # 注：无\n"))
    text = text.replace("Packaging paper feeder", "送料机（试）")
    assert not findings(text)
    (found,) = findings(text.replace("start:", "strat:"))
    assert found.code == "file.unknown-key"


def test_a_list_without_spaces_is_a_list() -> None:
    assert not findings(changed(("B: [AB, 0]", "B: [155,0]")))


def test_a_text_full_of_them_is_read_a_bounded_number_of_times() -> None:
    text = "".join(f"m{i}：1\n" for i in range(300))
    reads: list[str] = []

    def read(text: str) -> list[Finding]:
        reads.append(text)
        at = next((i for i, line in enumerate(text.split("\n")) if "：" in line), None)
        return [] if at is None else [Finding("file.yaml", line=at + 1)]

    told = read_respelled(text, read(text), read)
    assert len(reads) <= 2 * ROUNDS + 1 and len(told) == ROUNDS + 1
    assert read_respelled("x" * (LONGEST + 1), [Finding("file.yaml", line=1)], read)[0].code == "file.yaml"


@pytest.mark.parametrize(
    ("line", "wide"),
    [
        ("AB: 155", "AB： 15.5 厘米"),
        ("AB: 155", "AB：155毫米"),
        ("speed: -40 rpm", "speed： -40 转／分"),
        ("  crank:", "  曲柄（1）："),
    ],
)
def test_what_is_proposed_is_valid_itself(line: str, wide: str) -> None:
    """Put into the line, the proposed text leaves nothing to be told of it but what follows from another name."""
    text = BLOCK.replace(line, wide, 1)
    assert text != BLOCK
    (told,) = [finding for finding in findings(text) if finding.code == "file.wide"]
    hint = told.data["hint"]
    assert isinstance(hint, Term)
    mended = text.replace(str(told.data["given"]), str(hint.data["text"]), 1)
    left = [f for f in findings(mended) if f.line == told.line]
    assert left == [], [str(finding) for finding in left]
