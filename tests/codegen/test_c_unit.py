"""C text for a unit of its own: no warnings, nothing seen from outside, the same numbers."""

from __future__ import annotations

import subprocess
from pathlib import Path

import casadi as ca
import pytest
from casadi import MX, SX, Function

from acausal.codegen.c_unit import unit_text
from acausal.runtime.build import compiler


def functions() -> dict[str, Function]:
    """Every operation whose C text is changed."""
    x, y = SX.sym("x", 2), SX.sym("y")
    both = ca.logic_and(x[0] > 0, ca.logic_or(ca.logic_not(y), x[1] < y))
    scalar = Function("scalar", [x, y], [ca.if_else(both, ca.sqrt(x[0]), y), ca.fmax(x[1], y)])
    u = MX.sym("u")
    row = ca.low([0.0, 1.0, 2.0, 4.0], u, {"lookup_mode": "binary"})
    place = ca.low([0.0, 1.0, 2.0, 3.0], u, {"lookup_mode": "linear"})
    table = Function(
        "table", [u], [MX(ca.DM([5, 6, 7, 8]))[row] + place, ca.if_else(ca.logic_not(u > 1), u, 2)]
    )
    return {"scalar": scalar, "table": table}


def test_nothing_is_seen_from_outside() -> None:
    text = unit_text(functions(), "tank")
    assert "CASADI_SYMBOL_EXPORT " not in text.replace("define CASADI_SYMBOL_EXPORT ", "")
    assert "static int scalar(" in text
    assert "CASADI_PREFIX(ID) tank_ ## ID" in text


@pytest.mark.skipif(compiler() is None, reason="there is no C compiler")
def test_compiles_without_warnings_and_computes_the_same(tmp_path: Path) -> None:
    tool = compiler()
    assert tool is not None
    points = [(1.0, 2.0, 3.0), (1.0, 4.0, 0.0), (1.0, 4.0, 3.0), (-1.0, 2.0, 3.0)]
    lines = [
        f"a[0] = {x}; a[1] = {y}; b[0] = {z}; scalar(arg, res, iw, w, 0); show(2);"
        f" arg[0] = b; table(arg, res, iw, w, 0); show(2); arg[0] = a;"
        for x, y, z in points
    ]
    program = (
        unit_text(functions(), "tank")
        + "#include <stdio.h>\nstatic double a[2], b[1], c[1], d[1], w[100];\nstatic casadi_int iw[100];\n"
        "static const double *arg[20] = {a, b};\nstatic double *res[20] = {c, d};\n"
        'static void show(int n) { printf("%.17g %.17g %d\\n", c[0], d[0], n); }\n'
        "int main(void) {\n" + "\n".join(lines) + "\nreturn 0; }\n"
    )
    (tmp_path / "unit.c").write_text(program, encoding="utf-8")
    flags = ["-std=c99", "-Wall", "-Wextra", "-Wconversion", "-Wsign-conversion", "-Werror", "-O0"]
    subprocess.run([tool.path, *flags, "unit.c", "-o", "unit", "-lm"], cwd=tmp_path, check=True, timeout=120)
    out = subprocess.run(["./unit"], cwd=tmp_path, capture_output=True, text=True, check=True, timeout=20)
    found = [[float(v) for v in line.split()[:2]] for line in out.stdout.splitlines()]
    known = functions()
    expected = [
        [float(value) for value in results]
        for x, y, z in points
        for results in (known["scalar"]([x, y], z), known["table"](z))
    ]
    assert found == expected
