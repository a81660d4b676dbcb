"""CSV files beside a model: what is read of them, and what is said of those that can't be."""

from __future__ import annotations

from pathlib import Path

import pytest

import linkwright as lw
from linkwright.findings import Finding
from linkwright.model.csv_file import read_csv

PLACE = ("tables", "a", "file")


def rows(folder: Path, content: str | bytes, limit: int = 10) -> list[list[float]]:
    (folder / "a.csv").write_bytes(content if isinstance(content, bytes) else content.encode())
    file = read_csv("a.csv", folder, PLACE, limit)
    return file.numbers([file.column("x"), file.column("y")])


def findings(folder: Path, content: str | bytes, limit: int = 10) -> list[Finding]:
    with pytest.raises(lw.ModelError) as caught:
        rows(folder, content, limit)
    assert all(f.path == PLACE and f.what and f.mend for f in caught.value.findings)
    return [*caught.value.findings]


@pytest.mark.parametrize(
    "content",
    [
        "x,y\n1,2\n3,-0\n",
        "\ufeffx,y\r\n1,2\r\n3,-0",
        "x,y\n1,2\n3,-0\n".encode("utf-16"),
        "角度,x,y\n?,1,2\n?,3,-0\n".encode("gbk"),
        "\n\n x ,z, y\n\n1,?,2\n , ,\n3,nan,-0e9\n",
        "x,y\r1,2\r3,-0\r",
        '"x","y"\n"1","2"\n"3","-0"\n',
    ],
)
def test_what_is_read(tmp_path: Path, content: str | bytes) -> None:
    assert rows(tmp_path, content) == [[1, 2], [3, 0]]


@pytest.mark.parametrize(
    ("content", "code"),
    [
        ("", "table.empty"),
        ("\n , \n", "table.empty"),
        ("\ufeff", "table.empty"),
        ("a,b\n1,2\n", "table.no-column"),
        ("x,y,x\n1,2,3\n", "table.column-twice"),
        ("x;y\n1,5;2,5\n", "table.separator"),
        ("x\ty\n1\t2\n", "table.separator"),
        ("x，y\n1，2\n", "table.separator"),
        ("x,y\n1,2\n".encode("utf-16-le"), "table.encoding"),
        ("x\ty\n1\t2\n".encode("utf-16"), "table.separator"),
        ("x,y,Länge\n1,2,3\n".encode("cp1252"), "table.encoding"),
        (b"x,y\n1,2\0\n", "table.not-text"),
        (b"PK\x03\x04\x14\x00", "table.not-text"),
        ("x,y\n1," + "9" * 200_000 + "\n", "table.bad-line"),
        ("x,y\n" + "1,2\n" * 11, "table.long"),
        ("x,y\n1,2\n1\n", "table.not-number"),
        *(
            (f"x,y\n1,{cell}\n", "table.not-number")
            for cell in ("nan", "-inf", "1e400", "9" * 400, '"1,5"', "2 mm", "")
        ),
    ],
)
def test_what_is_refused(tmp_path: Path, content: str | bytes, code: str) -> None:
    (finding,) = findings(tmp_path, content)
    assert finding.code == code


@pytest.mark.parametrize("encoding", ["utf-8", "utf-8-sig", "gbk", "gb18030", "utf-16"])
def test_columns_with_chinese_names_as_spreadsheets_save_them(tmp_path: Path, encoding: str) -> None:
    (tmp_path / "a.csv").write_bytes("时间,角度\r\n0,1.5\r\n".encode(encoding))
    file = read_csv("a.csv", tmp_path, PLACE, 10)
    assert file.numbers([file.column("时间"), file.column("角度")]) == [[0, 1.5]]
    assert file.encoding == {"gbk": "GBK", "gb18030": "GBK", "utf-16": "UTF-16"}.get(encoding)


def test_the_encoding_is_named_with_the_way_out(tmp_path: Path) -> None:
    (finding,) = findings(tmp_path, "x,y,Länge\n1,2,3\n".encode("cp1252"))
    assert "Windows-1252" in finding.what and "UTF-8" in finding.mend


def test_cells_are_told_all_at_once_with_their_lines(tmp_path: Path) -> None:
    found = findings(tmp_path, "x,y\n\n1,a\ninf,b\n")
    assert [(f.data["row"], f.data["name"], f.data["given"]) for f in found] == [
        (3, "y", "a"),
        (4, "x", "inf"),
        (4, "y", "b"),
    ]
    found = findings(tmp_path, "x,y\n" + "a,b\n" * 10)
    assert len(found) == 11
    assert (found[-1].code, found[-1].data) == ("file.more", {"count": 10})
    assert len(findings(tmp_path, "x,y\n" + "a,b\n" * 5)) == 10


def test_bytes_are_told_with_their_line(tmp_path: Path) -> None:
    (finding,) = findings(tmp_path, b"x,y\n1,2\n\x1b[31m,3\n")
    assert finding.data == {"file": "a.csv", "at": 8, "line": 3}
