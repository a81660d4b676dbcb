"""Compiled mechanisms as objects."""

from __future__ import annotations

from linkwright.compilation import compile_mechanism
from linkwright.model.document import parse_document
from model.given import four_bar


def test_it_is_told_in_one_line_as_its_document_is() -> None:
    document = parse_document(four_bar(name="four-bar\nof two lines"))
    assert document is not None
    assert repr(document) == str(document) == "<Document 'four-bar of two lines': links 4, joints 4>"
    assert repr(compile_mechanism(document)) == "<Compiled 'four-bar of two lines': links 4, joints 4>"
