"""Imports point down the pipeline only."""

from __future__ import annotations

import ast
from pathlib import Path

import pytest

from tests.architecture.layers import LAYERS, Edge, edges, is_allowed, modules, prefix_of

MODULES = modules()
KNOWN = frozenset(MODULES)


def module_cases() -> list[str]:
    return sorted(MODULES)


@pytest.mark.parametrize("name", module_cases())
def test_module_has_a_layer(name: str) -> None:
    assert prefix_of(name), f"{name} belongs to no layer: give it one in tests/architecture/layers.py"


@pytest.mark.parametrize("name", module_cases())
def test_imports_point_down(name: str) -> None:
    path = MODULES[name]
    wrong = [edge for edge in edges(name, path.read_text(), KNOWN) if not is_allowed(edge)]
    assert not wrong, "\n".join(
        f"{path.name}:{edge.line}: {edge.importer} ({prefix_of(edge.importer)}) must not import "
        f"{edge.imported} ({prefix_of(edge.imported)}): imports point down the pipeline"
        for edge in wrong
    )


def test_package_above_a_lower_layer_imports_nothing_when_that_layer_is_imported() -> None:
    """`import acausal.symbolic.graphs` runs `acausal/symbolic/__init__.py`, so that file stays empty."""
    prefixes = [prefix for layer in LAYERS for prefix in layer]
    shared = {prefix for prefix in prefixes if any(p.startswith(prefix + ".") for p in prefixes)} - {
        "acausal"
    }
    for name in sorted(shared & KNOWN):
        body = ast.parse(MODULES[name].read_text()).body
        imports = [node.lineno for node in body if isinstance(node, ast.Import | ast.ImportFrom)]
        assert not imports, f"{MODULES[name]}: lower layers live inside {name}, so it must import nothing"


def test_no_relative_imports() -> None:
    for name, path in MODULES.items():
        for node in ast.walk(ast.parse(path.read_text())):
            assert not (isinstance(node, ast.ImportFrom) and node.level), (
                f"{name}:{node.lineno}: write it in full"
            )


@pytest.mark.parametrize(
    ("importer", "imported", "allowed"),
    [
        ("acausal.symbolic.alias", "acausal.lang.flat", True),
        ("acausal.symbolic.alias", "acausal.symbolic.graphs.blt", True),
        ("acausal.lang.flatten", "acausal.symbolic.expressions.expr", True),
        ("acausal.lang.flatten", "acausal.symbolic.alias", False),
        ("acausal.symbolic.graphs.blt", "acausal.symbolic.expressions.expr", False),
        ("acausal.symbolic.graphs.blt", "acausal.errors", False),
        ("acausal.symbolic.expressions.expr", "acausal.errors", True),
        ("acausal.codegen.functions", "acausal.runtime", False),
        ("acausal.simulate", "acausal.pipeline", False),
        ("acausal.cli.main", "acausal", True),
        ("acausal.lang.lexer", "acausal", False),
        ("acausal.lang.lexer", "acausal.misc", False),
    ],
)
def test_the_rule_itself(importer: str, imported: str, allowed: bool) -> None:
    assert is_allowed(Edge(importer, imported, 1)) is allowed


def test_every_form_of_import_is_seen() -> None:
    text = """
import acausal.api as api
from acausal.symbolic import alias, helper
def late():
    from acausal.cli import main
if TYPE_CHECKING:
    from acausal.pipeline import Stage
"""
    found = edges("acausal.lang.x", text, frozenset({"acausal.symbolic.alias"}))
    assert sorted(edge.imported for edge in found) == [
        "acausal.api",
        "acausal.cli",
        "acausal.pipeline",
        "acausal.symbolic",
        "acausal.symbolic.alias",
    ]


def test_modules_are_found(tmp_path: Path) -> None:
    (tmp_path / "acausal" / "lang").mkdir(parents=True)
    (tmp_path / "acausal" / "lang" / "__init__.py").touch()
    (tmp_path / "acausal" / "lang" / "ast.py").touch()
    assert list(modules(tmp_path)) == ["acausal.lang", "acausal.lang.ast"]
