"""tools/smoke.py: what it takes out of Markdown, what it makes of it, and what it tells apart."""

import importlib.util
import json
import sys
from pathlib import Path
from types import ModuleType

import pytest

SMOKE = Path(__file__).resolve().parents[2] / "tools" / "smoke.py"


@pytest.fixture(scope="module")
def smoke() -> ModuleType:
    sys.path.append(str(SMOKE.parent))  # as for a script
    spec = importlib.util.spec_from_file_location("smoke_under_test", SMOKE)
    assert spec is not None and spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    sys.path.append(str(SMOKE.parent))  # of the modules beside it
    sys.modules[spec.name] = module  # dataclasses look their module up
    spec.loader.exec_module(module)
    return module


DOCUMENT = """\
# Title

```python
a = 1
```

Words.

<!-- exit 2 -->

```console
$ linkwright check \\
>     bad.yaml
bad.yaml:3: no such link
$ ls
```

1. In a list:

   ```sh
   # a comment
   linkwright check good.yaml  # and why
   ```

<!-- no-run -->
```python
b = 1
```

```python no-run
c = 1
```

````markdown
```python
inside = "not a block of its own"
```
````

<!-- exit 3 --> These words stand between the comment and the block.

Words.

~~~yaml
linkwright: 1
name: Test
~~~
"""


def test_blocks_come_with_language_line_and_text(smoke: ModuleType) -> None:
    found = list(smoke.blocks(DOCUMENT))
    assert [(block.language, block.line) for block in found] == [
        ("python", 4),
        ("console", 12),
        ("sh", 21),
        ("python", 27),
        ("python", 31),
        ("markdown", 35),
        ("yaml", 45),
    ]
    assert found[0].text == "a = 1\n"
    assert found[2].text.startswith("# a comment\nlinkwright")


def test_comments_hold_for_the_next_block_alone(smoke: ModuleType) -> None:
    found = list(smoke.blocks(DOCUMENT))
    assert [block.exit_code for block in found] == [0, 2, 0, 0, 0, 0, 0]
    assert [block.skip for block in found] == [False, False, False, True, True, False, False]


def test_two_comments_hold_together(smoke: ModuleType) -> None:
    (block,) = smoke.blocks("<!-- exit 2 -->\n<!-- no-run -->\n```sh\nlinkwright\n```\n")
    assert (block.exit_code, block.skip) == (2, True)


def test_a_block_left_open_ends_with_the_file(smoke: ModuleType) -> None:
    (block,) = smoke.blocks("```sh\nlinkwright --help\n")
    assert block.text == "linkwright --help\n"


def test_indentation_inside_a_block_stays(smoke: ModuleType) -> None:
    (block,) = smoke.blocks("  ```python\n  if True:\n      a = 1\n\n  b = 2\n  ```\n")
    assert block.text == "if True:\n    a = 1\n\nb = 2\n"


def test_command_lines(smoke: ModuleType) -> None:
    found = list(smoke.blocks(DOCUMENT))
    assert list(smoke.command_lines(found[1])) == [(12, "linkwright check bad.yaml"), (15, "ls")]
    assert list(smoke.command_lines(found[2])) == [(22, "linkwright check good.yaml")]


@pytest.mark.parametrize(
    ("command", "rest"),
    [
        ("linkwright run a.yaml --out x", " run a.yaml --out x"),
        ("python -m linkwright check a.yaml", " check a.yaml"),
        ("python3 dev.py run a.yaml", " run a.yaml"),
        ("python3 dev.py schema > schema.json", " schema > schema.json"),
        ("python3 dev.py --help", " --help"),
    ],
)
def test_documented_commands_run_with_this_python(smoke: ModuleType, command: str, rest: str) -> None:
    assert smoke.translate(command) == f'"{sys.executable}" -m linkwright{rest}'


@pytest.mark.parametrize(
    "command",
    [
        "python3 dev.py",
        "python3 dev.py test -k cam",
        "python3 dev.py all",
        "git clone linkwright",
        "linkwrights",
    ],
)
def test_other_commands_are_not_run(smoke: ModuleType, command: str) -> None:
    assert smoke.translate(command) is None


@pytest.mark.parametrize(
    ("markdown", "expected"),
    [
        ("```yaml\nlinkwright: 1\nname: A\n```", True),
        ("```yaml\n# A comment.\n\nlinkwright: 1  # the version\n```", True),
        ("```yaml\nlinks:\n  linkwright: 1\n```", False),
        ("```yaml\n```", False),
        ("```text\nlinkwright: 1\n```", False),
    ],
)
def test_whole_models_are_told_from_pieces(smoke: ModuleType, markdown: str, expected: bool) -> None:
    (block,) = smoke.blocks(markdown)
    assert smoke.is_model(block) is expected


def test_a_document_runs_in_one_namespace(smoke: ModuleType, tmp_path: Path) -> None:
    path = tmp_path / "page.md"
    path.write_text(
        "```python\na = 1\n```\n"
        "```python\nprint('said'); raise ValueError(a)\n```\n"
        "<!-- exit 2 -->\n```python\nimport sys; sys.exit(a + 1)\n```\n"
        "```python\nassert a == 1\n```\n"
        "```sh\ngit status\n```\n",
        encoding="utf-8",
    )
    with smoke.Snippets(path, tmp_path) as snippets:
        outcomes = list(smoke.run_document("page.md", path, tmp_path, snippets))
    assert [outcome.verdict for outcome in outcomes] == ["ok", "FAIL", "ok", "ok", "skip"]
    assert outcomes[1].name == "page.md:5 python"
    assert outcomes[1].detail.startswith("said\n")
    assert f'{path}", line 5' in outcomes[1].detail


def test_what_a_snippet_prints_is_compared_with_the_text_block_right_after_it(
    smoke: ModuleType, tmp_path: Path
) -> None:
    path = tmp_path / "page.md"
    path.write_text(
        "```python\nprint('a', 1.00001)\n```\n\n```text\na 1\n```\n"
        "```python\nprint('b')\n```\n\n```text\nc\n```\n"
        "```python\nprint('b')\n```\n\nWords.\n\n```text\nc\n```\n",
        encoding="utf-8",
    )
    with smoke.Snippets(path, tmp_path) as snippets:
        outcomes = list(smoke.run_document("page.md", path, tmp_path, snippets))
    assert [outcome.verdict for outcome in outcomes] == ["ok", "FAIL", "ok"]


def test_what_a_block_shows_is_compared_with_what_its_command_prints(smoke: ModuleType) -> None:
    block = smoke.Block("console", 10, "$ linkwright a \\\n>   b\nfirst\n$ linkwright c\nsecond  2.00001\n...\nlast\n")
    assert [line for line, _ in smoke.command_lines(block)] == [10, 13]
    smoke.compare(block, 10, "first\n")
    smoke.compare(block, 13, "second 2\nmore\n\nlast\n")
    with pytest.raises(smoke.Failure, match="not printed:\nlast"):
        smoke.compare(block, 13, "second 2\nlast\nmore\n")


@pytest.mark.parametrize(
    ("name", "language"),
    [("README.md", "en"), ("docs/how-to/cams.md", "en"), ("README.zh-CN.md", "zh"), ("docs/zh/how-to/cams.md", "zh")],
)
def test_commands_of_a_page_speak_its_language(smoke: ModuleType, name: str, language: str, tmp_path: Path) -> None:
    command = [sys.executable, "-c", "import os; print(os.environ['LANG'], os.environ.get('LC_ALL'))"]
    assert smoke.call(command, tmp_path, language=smoke.language_of(name)).startswith(language)


def test_a_page_is_remade(smoke: ModuleType, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    page = "1. Words.\n\n   ```console\n   $ linkwright --version\n   {}\n   ```\n\n"
    page += "```console\n$ linkwright --version\n```\n"
    path = tmp_path / "page.md"
    path.write_text(page.format("version 0"), encoding="utf-8")
    monkeypatch.setattr(smoke, "ROOT", tmp_path)
    monkeypatch.setattr(smoke, "forked", lambda *_: (0, "linkwright, version 7\n"))
    assert [outcome.verdict for outcome in smoke.remake_document(path)] == ["ok", "ok"]
    assert path.read_text(encoding="utf-8") == page.format("linkwright, version 7")


def test_a_snippet_that_ends_its_process_fails_and_so_do_those_after_it(smoke: ModuleType, tmp_path: Path) -> None:
    path = tmp_path / "page.md"
    path.write_text("```python\nimport os; os._exit(3)\n```\n```python\na = 1\n```\n", encoding="utf-8")
    with smoke.Snippets(path, tmp_path) as snippets:
        outcomes = list(smoke.run_document("page.md", path, tmp_path, snippets))
    assert [outcome.verdict for outcome in outcomes] == ["FAIL", "FAIL"]
    assert "ended with 3" in outcomes[0].detail


def test_an_exit_code_that_was_not_expected_fails(smoke: ModuleType, tmp_path: Path) -> None:
    command = [sys.executable, "-c", "print('why'); raise SystemExit(3)"]
    smoke.call(command, tmp_path, 3)
    with pytest.raises(smoke.Failure, match="exit code 3, expected 0\nwhy"):
        smoke.call(command, tmp_path)


def test_a_command_that_hangs_fails(smoke: ModuleType, tmp_path: Path) -> None:
    with pytest.raises(smoke.Failure, match="not done after"):
        smoke.call([sys.executable, "-c", "import time; time.sleep(60)"], tmp_path, timeout=0.2)


def results(folder: Path, summary: str = '{"a": [1.5, null, "nan"]}') -> Path:
    (folder / "report.html").write_text("<p>", encoding="utf-8")
    (folder / "cycle.csv").write_text("a\n", encoding="utf-8")
    (folder / "summary.json").write_text(summary, encoding="utf-8")
    return folder


def test_sound_results_pass(smoke: ModuleType, tmp_path: Path) -> None:
    smoke.check_results(results(tmp_path))


@pytest.mark.parametrize("value", ["NaN", "Infinity", "-Infinity"])
def test_a_summary_with_a_number_that_is_none_fails(smoke: ModuleType, tmp_path: Path, value: str) -> None:
    results(tmp_path, f'{{"peaks": [{{"torque": {value}}}]}}')
    with pytest.raises(smoke.Failure, match=r"summary\.peaks\[0\]\.torque is"):
        smoke.check_results(tmp_path)


def test_a_summary_that_does_not_parse_fails(smoke: ModuleType, tmp_path: Path) -> None:
    with pytest.raises(json.JSONDecodeError):
        smoke.check_results(results(tmp_path, "{"))


@pytest.mark.parametrize("name", ["report.html", "cycle.csv", "summary.json"])
def test_an_empty_or_missing_file_fails(smoke: ModuleType, tmp_path: Path, name: str) -> None:
    results(tmp_path)
    (tmp_path / name).write_text("", encoding="utf-8")
    with pytest.raises(smoke.Failure, match=f"{name} is missing or empty"):
        smoke.check_results(tmp_path)
    (tmp_path / name).unlink()
    with pytest.raises(smoke.Failure, match=f"{name} is missing or empty"):
        smoke.check_results(tmp_path)
