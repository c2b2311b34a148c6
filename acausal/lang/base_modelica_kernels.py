"""Tables that a flat model calls, as functions of Base Modelica.

They come in the package before the model, with their data as constants. Functions that are kept as a unit at
events (`expr.call` of other kernels) have no text of their own.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from acausal.symbolic.expressions.expr import Expr, postorder
from acausal.symbolic.expressions.kernel import Kernel
from acausal.symbolic.expressions.kernels.patches import Patches
from acausal.symbolic.expressions.kernels.piecewise import Piecewise
from acausal.symbolic.expressions.text import constant_text, quoted_name


def kernel_lines(roots: Iterable[Expr]) -> list[str]:
    """The functions of the tables in expressions, in order of first use."""
    found: dict[str, Kernel] = {}
    for node in postorder(roots):
        if node.op == "call":
            found.setdefault(node.kernel.name, node.kernel)
    lines: list[str] = []
    for kernel in found.values():
        if isinstance(kernel, Piecewise):
            lines += _piecewise(kernel)
        elif isinstance(kernel, Patches):
            lines += _patches(kernel)
    return lines


def _piecewise(kernel: Piecewise) -> list[str]:
    width = max(map(len, kernel.coefficients))
    rows = [[*piece, *[0.0] * (width - len(piece))] for piece in kernel.coefficients]
    body = _wrapped("s", kernel.period, ["s", "x"], "p")
    body += _interval("k", "s", "b", len(kernel.breaks))
    body.append("d := x - o[k];")
    value = _horner([f"c[k,{power + 1}]" for power in range(width)], "d")
    drift = f" + p * {_number(kernel.drift)}" if kernel.drift else ""
    result = f"{value}{drift}"
    body.append(f"y := integer({result} + 0.5);" if kernel.result == "Integer" else f"y := {result};")
    data = [_vector("b", kernel.breaks), _vector("o", kernel.origins), _matrix("c", rows)]
    local = ["Real s = s0;", "Real x = x0;", "Real d;", "Real p = 0;", "Integer k;"]
    return _function(kernel.name, ["s0", "x0"], kernel.result, [*data, *local], body)


def _patches(kernel: Patches) -> list[str]:
    rows, columns = kernel.powers
    width = len(kernel.origins[1])
    body: list[str] = []
    for i, (name, breaks, period) in enumerate(zip("uv", kernel.breaks, kernel.periods, strict=True)):
        body += _wrapped(name, period, [name], "p")
        body += _interval("ij"[i], name, f"b{name}", len(breaks))
        body.append(f"d{name} := {name} - o{name}[{'ij'[i]}];")
    body.append(f"k := (i - 1) * {width} + j;")
    lines = [
        f"({_horner([f'c[k,{p * columns + q + 1}]' for q in range(columns)], 'dv')})" for p in range(rows)
    ]
    body.append(f"y := {_horner(lines, 'du')};")
    data = [_vector(f"b{n}", breaks) for n, breaks in zip("uv", kernel.breaks, strict=True)]
    data += [_vector(f"o{n}", origins) for n, origins in zip("uv", kernel.origins, strict=True)]
    data.append(_matrix("c", kernel.coefficients))
    local = ["Real u = u0;", "Real v = v0;", "Real du;", "Real dv;", "Real p = 0;"]
    local += ["Integer i;", "Integer j;", "Integer k;"]
    return _function(kernel.name, ["u0", "v0"], "Real", [*data, *local], body)


def _function(
    name: str, inputs: Sequence[str], result: str, local: Sequence[str], body: Sequence[str]
) -> list[str]:
    shown = quoted_name(name)
    lines = [f"function {shown}"]
    lines += [f"  input Real {i};" for i in inputs]
    lines += [f"  output {result} y;", "protected"]
    lines += [f"  {declaration}" for declaration in local if declaration]
    return [*lines, "algorithm", *[f"  {statement}" for statement in body], f"end {shown};"]


def _wrapped(name: str, period: tuple[float, float] | None, moved: Sequence[str], turns: str) -> list[str]:
    """Into the period: up to its start from below, down to its end from above."""
    if period is None:
        return []
    start, length = map(_number, period)
    ratio = f"({name} - {start}) / {length}"
    shift = f"{turns} * {length}"
    return [
        f"{turns} := if {name} < {start} then floor({ratio}) else max(0, ceil({ratio}) - 1);",
        *[f"{other} := {other} - {shift};" for other in moved],
    ]


def _interval(index: str, name: str, breaks: str, count: int) -> list[str]:
    """`index` is one more than the number of breaks that are not above the value."""
    if not count:
        return [f"{index} := 1;"]
    return [
        f"{index} := 1;",
        f"for n in 1:{count} loop",
        f"  {index} := if {name} >= {breaks}[n] then n + 1 else {index};",
        "end for;",
    ]


def _horner(coefficients: Sequence[str], distance: str) -> str:
    value = coefficients[-1]
    for coefficient in reversed(coefficients[:-1]):
        value = f"{coefficient} + {distance} * ({value})"
    return value


def _vector(name: str, values: Sequence[float]) -> str:
    if not values:
        return ""
    return f"constant Real {name}[{len(values)}] = {{{', '.join(map(_number, values))}}};"


def _matrix(name: str, rows: Sequence[Sequence[float]]) -> str:
    inner = ", ".join(f"{{{', '.join(map(_number, row))}}}" for row in rows)
    return f"constant Real {name}[{len(rows)},{len(rows[0])}] = {{{inner}}};"


def _number(value: float) -> str:
    text = constant_text(value)
    return f"({text})" if text.startswith("-") else text
