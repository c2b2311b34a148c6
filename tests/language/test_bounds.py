"""Small texts that stand for huge models end in an error that says which bound and where."""

from __future__ import annotations

import pytest

from acausal.errors import AcausalError
from tests.language.models import flat_model

_LEVELS = range(1, 31)
_ENDLESS = "function f input Real u; output Real y; algorithm y := u; while true loop end while; end f;"
_TREE = "class C0 Real x = 1; end C0; "


def _package(classes: str, model: str) -> str:
    return f"package P {classes} model Test {model} end Test; end P;"


CASES = {
    "conditional components": (
        "instance.too-large",
        _package(
            _TREE
            + " ".join(
                f"class C{i} parameter Boolean b = true; C{i - 1} a if b; C{i - 1} c if b; end C{i};"
                for i in _LEVELS
            ),
            "C30 c;",
        ),
    ),
    "arrays in arrays": (
        "instance.too-large",
        _package(_TREE + " ".join(f"class C{i} C{i - 1} a[2]; end C{i};" for i in _LEVELS), "C30 c;"),
    ),
    "recursion that branches": (
        "instance.too-large",
        _package(
            "class A parameter Integer n = 0; A a(n = n + 1) if n < 28; A b(n = n + 1) if n < 28; end A;",
            "A a;",
        ),
    ),
    "nested reductions": (
        "model.too-much-work",
        "model Test Real x = sum(sum(sum(i * j * k for i in 1:50) for j in 1:50) for k in 1:9999); end Test;",
    ),
    "a comprehension of three": (
        "model.too-much-work",
        "model Test Real x[:, :, :] = {i * j * k for i in 1:50, j in 1:50, k in 1:9999}; end Test;",
    ),
    "connections of each with each": (
        "model.too-much-work",
        _package(
            "connector C Real v; flow Real i; end C;",
            "C c[2000]; equation for i in 1:2000 loop for j in 1:2000 loop connect(c[i], c[j]); "
            "end for; end for;",
        ),
    ),
    "sums of all in all": (
        "model.too-much-work",
        "model Test Real x[9000]; equation for i in 1:9000 loop x[i] = sum(x) - time; end for; end Test;",
    ),
    "a loop without end": (
        "function.too-long",
        _package(_ENDLESS, "Real y = f(1);"),
    ),
    "branches": (
        "equation.too-many-branches",
        "model Test Real x; equation if time > 1 then x = 1;"
        + " ".join(f"elseif time > {i} then x = {i};" for i in range(2001))
        + " else x = 0; end if; end Test;",
    ),
    "dimensions": ("array.dimensions", f"model Test Real x[{', '.join(['1'] * 101)}]; end Test;"),
    "parameters in a chain": (
        "model.too-deep",
        "model Test parameter Integer p0 = 1;"
        + " ".join(f"parameter Integer p{i} = p{i - 1};" for i in range(1, 4000))
        + " Real x[p3999]; end Test;",
    ),
    "an Integer that squares": (
        "parameter.arithmetic",
        "model Test Integer y; algorithm y := 3; " + "y := y * y; " * 60 + "end Test;",
    ),
    "a text": (
        "call.arguments",
        'model Test Real x[if String(1.0, format = "1000000000.5f") == "" then 1 else 2]; end Test;',
    ),
}


@pytest.mark.parametrize("name", CASES)
def test_a_bound_is_named(name: str) -> None:
    code, text = CASES[name]
    with pytest.raises(AcausalError) as problem:
        flat_model(text)
    assert problem.value.codes[0] == code


def test_messages_show_the_beginning_of_huge_expressions() -> None:
    """Doubling an expression a hundred times makes a small graph, whose text would fill the memory."""
    steps = "if y > 1 then y := y * y + y; else y := y - y * sin(y); end if; " * 100
    with pytest.raises(AcausalError) as problem:
        flat_model(f"model Test Real y; algorithm y := time; {steps} end Test;")
    assert problem.value.codes[0] == "unit.clash"
    assert len(problem.value.diagnostics) <= 10
    assert all(len(d.message) < 400 for d in problem.value.diagnostics)
