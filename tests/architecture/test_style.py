"""The house style, as far as a machine can measure it."""

from __future__ import annotations

import ast
import re
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from tests.architecture.layers import PACKAGE, ROOT
from tests.architecture.style import MAX_FILE_LINES, Offence, long_functions, random_sources, set_orders

FILES = sorted(PACKAGE.rglob("*.py"))
UNFINISHED = re.compile(r"\b(TO[D]O|FIX[M]E|XX[X]|HA[C]K)\b")

Rule = Callable[[ast.Module], Iterator[Offence]]


def relative(path: Path) -> str:
    return str(path.relative_to(ROOT))


def report(path: Path, offences: list[Offence]) -> str:
    return "\n".join(f"{relative(path)}:{offence.line}: {offence.message}" for offence in offences)


@pytest.mark.parametrize("path", FILES, ids=relative)
class TestEveryFile:
    @pytest.mark.parametrize("rule", [long_functions, random_sources, set_orders])
    def test_keeps(self, path: Path, rule: Rule) -> None:
        offences = list(rule(ast.parse(path.read_text())))
        assert not offences, report(path, offences)

    def test_is_short(self, path: Path) -> None:
        lines = len(path.read_text().splitlines())
        assert lines <= MAX_FILE_LINES, (
            f"{relative(path)} has {lines} lines, at most {MAX_FILE_LINES}: split by concept"
        )

    def test_has_a_docstring(self, path: Path) -> None:
        tree = ast.parse(path.read_text())
        assert ast.get_docstring(tree) or not tree.body, f"{relative(path)} does not say what it is"

    def test_is_finished(self, path: Path) -> None:
        found = [
            Offence(number, line.strip())
            for number, line in enumerate(path.read_text().splitlines(), 1)
            if UNFINISHED.search(line)
        ]
        assert not found, report(path, found)


def offences(rule: Rule, text: str) -> list[int]:
    return [offence.line for offence in rule(ast.parse(text))]


@pytest.mark.parametrize(
    "text",
    [
        "for x in {1, 2}: pass",
        "for x in set(y): pass",
        "z = [x for x in frozenset(y)]",
        "z = {x: 1 for x in {a for a in y}}",
        "z = list(set(y))",
        "z = ', '.join({a, b})",
        "z = [*{a, b}]",
        "def f(s: set[int]) -> None:\n for x in s: pass",
        "def f(y):\n s = set(y)\n return tuple(s)",
        "def f(s: frozenset[int], t: frozenset[int]):\n return list(s | t)",
    ],
)
def test_the_order_of_a_set_is_caught(text: str) -> None:
    assert offences(set_orders, text)


@pytest.mark.parametrize(
    "text",
    [
        "for x in sorted({1, 2}): pass",
        "z = any(x for x in {1, 2})",
        "z = {x for x in {1, 2}}",
        "z = len({1, 2})",
        "def f(s: set[int], t: list[int]):\n return [x for x in t if x in s]",
        "def f(s: set[int]):\n return sorted(x + 1 for x in s)",
    ],
)
def test_what_does_not_depend_on_the_order_passes(text: str) -> None:
    assert not offences(set_orders, text)


@pytest.mark.parametrize(
    "text",
    [
        "import random",
        "from numpy.random import default_rng",
        "from numpy import random",
        "z = f'v{id(x)}'",
        "z = sorted(y, key=id)",
        "z = sorted(y, key=lambda v: id(v))",
        "z = hash('a') % 7",
    ],
)
def test_randomness_is_caught(text: str) -> None:
    assert offences(random_sources, text)


@pytest.mark.parametrize(
    "text", ["cache = {id(x): x}", "class A:\n def __hash__(self): return hash(self.key)"]
)
def test_harmless_addresses_pass(text: str) -> None:
    assert not offences(random_sources, text)


def test_docstrings_do_not_make_a_function_long() -> None:
    documented = 'def f():\n    """A.\n' + "\n" * 80 + '    """\n    return 1\n'
    long = "def f():\n" + "    x = 1\n" * 60
    assert not offences(long_functions, documented)
    assert offences(long_functions, long) == [1]
