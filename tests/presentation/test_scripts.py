"""Scripts in pages: each is in the policy by its hash, and stands in the page to the letter."""

from __future__ import annotations

import base64
import hashlib
import re

import pytest

from linkwright.presentation.html_file import html_file
from linkwright.presentation.scripts import built, element, policy


def test_the_policy_has_the_hash_of_each_script_of_the_page_and_of_nothing_else() -> None:
    page = html_file("T", lambda: "<p>1</p>", data={"a": "<b>"}, scripts=["let a = '✓';\n", "a += 1"])
    (rules,) = re.findall(r'http-equiv="Content-Security-Policy" content="(.*?)"', page)
    scripts = re.findall(r"<script>(.*?)</script>", page, re.DOTALL)
    assert len(scripts) == 3 and "linkwrightWords" in scripts[0]
    hashes = [base64.b64encode(hashlib.sha256(code.encode()).digest()).decode() for code in scripts]
    (allowed,) = re.findall(r"script-src (.*?);", rules)
    assert allowed.split() == [f"'sha256-{one}'" for one in hashes]
    assert rules.startswith("default-src 'none'; ") and "unsafe-eval" not in rules


def test_a_page_without_scripts_allows_none() -> None:
    assert "script-src 'none';" in policy([])


@pytest.mark.parametrize("code", ["a = '</script>'", "a = '</SCRIPT '", "a = '<!--'", "a\r\nb"])
def test_a_script_that_would_end_early_or_differ_from_its_hash_is_an_error(code: str) -> None:
    with pytest.raises(ValueError, match="can't stand in a page"):
        element(code)


def test_built_files_come_without_their_first_line() -> None:
    code = built("linkwright.report", "assets/report.js")
    assert code.startswith('"use strict";') and "sha256" not in code
