"""Packages of C: they compile without warnings and run as the model does inside Python."""

from __future__ import annotations

import csv
from pathlib import Path

import pytest

import acausal
from acausal.errors import LookupProblem, UnsupportedProblem, UsageProblem
from acausal.export.c_export import export_c
from tests.codegen.test_factors import LADDER
from tests.export.packages import Built, built, compiled, differences, exported, needs_compiler

LOOP = """
model Loop "A nonlinear loop, linear ones that switch, of which one is singular, and located events"
  parameter Real a = 2;
  parameter Real k = 1;
  input Real u(start = 0.5);
  Real x(start = 1, fixed = true);
  Real y(start = 1);
  Real f1; Real f2; Real f3; Real f4; Real f5;
  Real v[5] "Voltages of a network that floats while x is small";
  Real i = if time < 1.2 then x else 0;
equation
  2 * (v[1] - v[2]) + 0.5 * (v[1] - v[3]) + 0.2 * x * (v[1] - v[5]) = i;
  2 * (v[2] - v[1]) + (1 + x) * (v[2] - v[3]) + 0.3 * (v[2] - v[4]) = 0;
  0.5 * (v[3] - v[1]) + (1 + x) * (v[3] - v[2]) + (v[3] - v[4]) * x + (v[3] - v[5]) = 0;
  0.3 * (v[4] - v[2]) + (v[4] - v[3]) * x + (if time < 1.2 then v[4] else 0) + 0.7 * (v[4] - v[5]) = 0;
  0.2 * x * (v[5] - v[1]) + (v[5] - v[3]) + 0.7 * (v[5] - v[4]) = 0;
  der(x) = -y + f1 + u * sin(time) - 0.1 * v[1];
  y ^ 3 + k * y = x;
  f1 + 2 * f2 - f3 + f4 = x;
  f1 - f2 + f3 + f5 = y;
  f2 + 4 * f3 + f1 = 1;
  if x > 0.5 then f4 + f5 = f1; else f4 - f5 = 0.0; end if;
  f5 + f1 * a + f4 * 3 = f2;
  assert(a < 5, "a is too large");
  annotation(experiment(StopTime = 2));
end Loop;
"""

HYBRID = """
model Hybrid "Bounces, samples, counts, resets and ends"
  type Mode = enumeration(low, high);
  parameter Real e = 0.8;
  parameter Boolean on = true;
  parameter Integer most = 40;
  parameter Mode mode = Mode.high;
  Real h(start = 1, fixed = true);
  Real v(fixed = true);
  Boolean flying(start = true, fixed = true);
  Integer count(start = 0, fixed = true);
  discrete Real held(start = 0, fixed = true);
  Real lag(start = if mode == Mode.high then 2 else 1, fixed = true);
  Real late = delay(h, 0.05);
equation
  der(h) = v;
  der(v) = if flying and on then -9.81 else 0;
  der(lag) = held - lag + late;
  when h < 0 then
    reinit(v, -e * pre(v));
    flying = -e * pre(v) > 0.5;
    count = pre(count) + 1;
  end when;
  when sample(0.1, 0.1) then
    held = h;
  end when;
  when time > 1.25 then
    assert(count < most, "too many", AssertionLevel.warning);
  end when;
  when count > most then
    terminate("enough");
  end when;
  annotation(experiment(StopTime = 3));
end Hybrid;
"""


@pytest.fixture(scope="module")
def loop(tmp_path_factory: pytest.TempPathFactory) -> Built:
    return exported(compiled(LOOP), tmp_path_factory.mktemp("loop"), solver="rosenbrock", step=1e-3)


@pytest.fixture(scope="module")
def hybrid(tmp_path_factory: pytest.TempPathFactory) -> Built:
    settings = {"step": 1e-3, "tunable": ["e", "on", "most", "mode", "start(h)"]}
    flags = ("-O0", "-fsanitize=address,undefined", "-fno-sanitize-recover=all")
    return exported(compiled(HYBRID), tmp_path_factory.mktemp("hybrid"), *flags, **settings)


def results(package: Built) -> list[dict[str, str]]:
    with (package.folder / "results.csv").open(encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


@needs_compiler
def test_loops_run_as_in_python(loop: Built) -> None:
    assert differences(compiled(LOOP), loop, "rosenbrock", 1e-3) < 1e-9


@needs_compiler
def test_events_run_as_in_python_under_sanitizers(hybrid: Built) -> None:
    assert differences(compiled(HYBRID), hybrid, "heun", 1e-3) == 0.0


@needs_compiler
def test_matrices_that_no_run_changes_are_factored_for_every_variant(tmp_path: Path) -> None:
    model = acausal.loads(LADDER).compile(G=2.0)
    assert model.code.quick.factors is not None
    package = exported(model, tmp_path, solver="rosenbrock", step=1e-2)
    (tmp_path / "table.csv").write_text("G\n2\n0.3\n", encoding="utf-8")
    package.run("-p", "table.csv", "-r", "results.csv", "--stop", "0.5")
    for g, row in zip((2.0, 0.3), results(package), strict=True):
        run = model.simulate(solver="rosenbrock", step=1e-2, stop_time=0.5, parameters={"G": g})
        assert float(row["x"]) == pytest.approx(run.values("x")[-1], rel=1e-10)


@needs_compiler
def test_table_of_variants(hybrid: Built) -> None:
    table = "e,on,mode,start(h)\n0.5,true,high,1\n0.5,false,Mode.low,2\n0.5,2,low,1\n0.5,true\n"
    (hybrid.folder / "table.csv").write_text(table, encoding="utf-8")
    done = hybrid.run("-p", "table.csv", "-r", "results.csv", "--stop", "0.5", code=1)
    rows = results(hybrid)
    assert [row["status"][:5] for row in rows] == ["ok", "ok", "error", "error"]
    assert float(rows[1]["h"]) == 2.0
    model = compiled(HYBRID)
    same = model.simulate(solver="heun", step=1e-3, stop_time=0.5, interval=3 / 500, parameters={"e": 0.5})
    assert float(rows[0]["lag"]) == same.final(["lag"])["lag"]
    assert "on: it must be true or false" in rows[2]["status"]
    assert "4 variants, 2 failed" in done.stdout
    assert "worst step" in done.stdout


@needs_compiler
def test_model_ends_the_run(hybrid: Built) -> None:
    (hybrid.folder / "few.csv").write_text("most\n2\n", encoding="utf-8")
    done = hybrid.run("-p", "few.csv", "-r", "results.csv")
    assert "variant 1: warning: too many" in done.stderr
    assert "variant 1: ended: enough" in done.stderr
    row = results(hybrid)[0]
    assert row["status"] == "ended"
    assert row["count"] == "3"


@needs_compiler
def test_failing_row_says_what_and_when(loop: Built) -> None:
    (loop.folder / "table.csv").write_text("a,k\n6,1\n2,1\n", encoding="utf-8")
    loop.run("-p", "table.csv", "-r", "results.csv", code=1)
    first, second = results(loop)
    assert "a is too large" in first["status"]
    assert "<string>:24" in first["status"]
    assert second["status"] == "ok"


@needs_compiler
def test_inputs_over_time(loop: Built) -> None:
    (loop.folder / "u.csv").write_text("time,u\n0,0\n0.7,1\n2,1\n", encoding="utf-8")
    names, data = loop.rows("-t", "u.csv")
    inputs = {"u": ([0, 0.7, 2], [0, 1, 1])}
    result = compiled(LOOP).simulate(solver="rosenbrock", step=1e-3, inputs=inputs)
    assert abs(data[-1, names.index("x")] - result.final(["x"])["x"]) < 1e-9
    names, data = loop.rows("-u", "u=0.25")
    constant = compiled(LOOP).simulate(solver="rosenbrock", step=1e-3, inputs={"u": 0.25})
    assert abs(data[-1, names.index("x")] - constant.final(["x"])["x"]) < 1e-9


@needs_compiler
def test_wrong_requests_of_the_program(loop: Built) -> None:
    (loop.folder / "unknown.csv").write_text("b\n1\n", encoding="utf-8")
    for words in (["-p", "unknown.csv"], ["-p", "missing.csv"], ["-u", "w=1"], ["--step", "0"], ["-x", "1"]):
        assert loop.run(*words, code=2).stderr.startswith("error: ")


TYPED = """
model Typed
  input Real u(start = 0), w(start = 0); input Boolean on(start = false); input Integer n(start = 0);
  parameter Real k = 1;
  Real x(start = 1, fixed = true);
equation
  der(x) = -1e4 * k * x ^ 3 + u + w + (if on then 1 else 0) + n;
end Typed;
"""


@needs_compiler
def test_wrong_tables_and_inputs_under_sanitizers(tmp_path: Path) -> None:
    flags = ("-O1", "-fsanitize=address,undefined", "-fno-sanitize-recover=all")
    program = exported(compiled(TYPED), tmp_path, *flags, solver="lieuler", step=0.01, tunable=["k"])
    tables = {
        "u,w\n0,1\n1,1\n": "first column",
        "time,u,u\n0,1,1\n0.5,0,1\n1,1,1\n": "named twice: u",
        "time,u\n0,1\n1,2,3\n": "times must increase",
        "time,u\n0,1\n0,2\n1,3\n": "times must increase",
    }
    for text, message in tables.items():
        (tmp_path / "t.csv").write_text(text, encoding="utf-8")
        assert message in program.run("-t", "t.csv", code=2).stderr
    (tmp_path / "t.csv").write_text("time,on\n0,0\n1,1\n", encoding="utf-8")
    assert "input on is no Real" in program.run("-t", "t.csv", code=1).stderr
    assert "true or false" in program.run("-u", "on=2", code=1).stderr
    assert "a whole number" in program.run("-u", "n=1.5", code=1).stderr
    (tmp_path / "t.csv").write_text("time,u,w\n0,1,0\n0.5,0,1\n1,1,0\n", encoding="utf-8")
    (tmp_path / "p.csv").write_text("\ufeffk\n1\n2\n", encoding="utf-8")
    assert program.run("-p", "p.csv", "-t", "t.csv").stdout.count(",ok,") == 2
    assert "may exceed the stability limit" in program.run("--solver", "heun", code=1).stderr
    assert "no such solver: foo" in program.run("--solver", "foo", code=2).stderr


def test_only_the_program_may_use_the_heap() -> None:
    files = export_c(compiled(HYBRID).code, step=1e-3).files
    assert [path for path, text in files.items() if "alloc(" in text] == ["main.c"]


def test_two_exports_are_the_same() -> None:
    first, second = (export_c(compiled(HYBRID).code, step=1e-3).files for _ in range(2))
    assert first == second


def test_hostile_names_stay_in_their_place(tmp_path: Path) -> None:
    text = r"""
model 'a*/ b" // ??/ %s \\'
  parameter Real '*/ int x; /*' = 1 "??/ */ \" %d";
  parameter Real 'int x' = 2;
  Real '"; } #error'(start = 1, fixed = true);
equation
  der('"; } #error') = -'*/ int x; /*' * 'int x';
  assert('"; } #error' > -1e9, "\"%s%n??/\\ */ \n \t");
end 'a*/ b" // ??/ %s \\';
"""
    package = export_c(compiled(text).code, step=0.1, tunable=["all"])
    package.write(tmp_path)
    header = package.files[f"{package.name}.h"]
    assert "TUNABLE_int_x = 0" in header
    assert "TUNABLE_int_x_2 = 1" in header
    if acausal.runtime.build.compiler() is not None:
        found = built(tmp_path, package.name, "-O0", "-trigraphs", "-Wcomment")
        assert "output '\"; } #error'" in found.run("--list").stdout


REFUSED = {
    "export.kernel": """
function f input Real x; output Real y; algorithm y := 0; while y * y < x loop y := y + 0.1; end while; end f;
model M discrete Real x(start = 1, fixed = true);
equation
  when sample(0.1, 0.1) then x = f(time); end when;
end M;""",
    "export.dynamic-states": """
model Pendulum
  Real x(start = 1); Real y(start = 0); Real v; Real w; Real T;
equation
  der(x) = v; der(y) = w; der(v) = T * x; der(w) = T * y - 9.81;
  x ^ 2 + y ^ 2 = 1;
end Pendulum;""",
}


@pytest.mark.parametrize("code", sorted(REFUSED))
def test_refused_with_the_line(code: str) -> None:
    with pytest.raises(UnsupportedProblem) as caught:
        export_c(compiled(REFUSED[code]).code)
    diagnostic = caught.value.diagnostics[0]
    assert diagnostic.code == code
    assert diagnostic.span is not None
    assert diagnostic.span.line in (5, 6)


def test_what_cannot_be_asked() -> None:
    code = compiled(LOOP).code
    with pytest.raises(UsageProblem, match="steps of one length"):
        export_c(code, solver="rodas")
    with pytest.raises(LookupProblem, match="no parameter `b`"):
        export_c(code, tunable=["b"])
    with pytest.raises(LookupProblem, match="no variable `b`"):
        export_c(code, variables=["b"])
