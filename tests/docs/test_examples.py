"""Every example in the README and the documentation does what the page says it does."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.docs.examples import ROOT, Command, ExampleError, Page, blocks, commands, same_json, same_text

PAGES = sorted([ROOT / "README.md", *(ROOT / "docs").glob("*.md")])


def relative(path: Path) -> str:
    return str(path.relative_to(ROOT))


@pytest.mark.parametrize("path", PAGES, ids=relative)
def test_page(path: Path, tmp_path: Path) -> None:
    Page(path, tmp_path).run()


PAGE = """\
# A page

<!-- file: A.mo -->
```modelica
model A
end A;
```

<!-- exit: 1 -->
```console
$ acausal check A.mo \\
    --json
{"a": 1}
$ acausal check 'B C.mo'
```
"""


def test_blocks_have_their_lines_and_marks() -> None:
    model, console = blocks(PAGE)
    assert (model.line, model.language, model.mark) == (5, "modelica", ("file", "A.mo"))
    assert model.code == "model A\nend A;\n"
    assert (console.line, console.mark) == (11, ("exit", "1"))


def test_a_mark_belongs_to_the_block_directly_after_it() -> None:
    (block,) = blocks("<!-- exit: 1 -->\n\nBetween.\n\n```console\n$ acausal\n```\n")
    assert block.mark is None


def test_commands_have_their_expected_output() -> None:
    assert commands(blocks(PAGE)[1]) == [
        Command(11, ("check", "A.mo", "--json"), '{"a": 1}'),
        Command(14, ("check", "B C.mo"), ""),
    ]


def test_other_commands_are_refused() -> None:
    (block,) = blocks("```console\n$ rm -r x\n```\n")
    with pytest.raises(ExampleError, match="line 2"):
        commands(block)


@pytest.mark.parametrize(
    ("expected", "actual", "same"),
    [
        ("a ... c", "a b c", True),
        ("a  \nb", "a\nb   \n", True),
        ("a\n...\nc", "a\nx\ny\nc", True),
        ("a\nb", "a b", False),
        ("a", "a\nb", False),
    ],
)
def test_text_is_compared(expected: str, actual: str, same: bool) -> None:
    assert same_text(expected, actual) is same


@pytest.mark.parametrize(
    ("expected", "actual", "same"),
    [
        ({"a": 1}, {"a": 1, "b": 2}, True),
        ({"a": "..."}, {"a": [1]}, True),
        ({"a": {"b": [1, "..."]}}, {"a": {"b": [1, 2]}}, True),
        ([0.5], [0.5001], True),
        ([0.5], [0.51], False),
        ({"a": 1}, {"b": 1}, False),
        ([1], [1, 2], False),
        ({"a": 1}, 1, False),
    ],
)
def test_json_is_compared(expected: object, actual: object, same: bool) -> None:
    assert same_json(expected, actual) is same


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("```modelica\nmodel A end A;\n```\n", "needs <!-- file"),
        ("<!-- file: A.mo -->\n```modelica\nmodel A end A;\n```\n", "nothing on the page uses A.mo"),
        ("```yaml\na: 1\n```\n", "no rule how to run a 'yaml' block"),
        ("```python\nprint(1)\n```\n\n<!-- output -->\n```text\n2\n```\n", "but this comes out\n1"),
    ],
)
def test_a_wrong_page_is_refused(
    text: str, message: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("tests.docs.examples.ROOT", tmp_path)
    page = tmp_path / "page.md"
    page.write_text(text)
    with pytest.raises(ExampleError) as raised:
        Page(page, tmp_path).run()
    assert message in str(raised.value)


def test_python_blocks_share_a_namespace_and_the_pages_files(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("tests.docs.examples.ROOT", tmp_path)
    page = tmp_path / "page.md"
    page.write_text(
        "<!-- file: A.mo -->\n```modelica\nmodel A end A;\n```\n\n"
        "```python\nfrom pathlib import Path\ntext = Path('A.mo').read_text()\n```\n\n"
        "```python\nprint(text)\n```\n\n<!-- output -->\n```text\nmodel ... A;\n```\n"
    )
    Page(page, tmp_path).run()
