"""The Python interface: docs/python.md is run elsewhere; here are its corners."""

from __future__ import annotations

import doctest
import importlib
from pathlib import Path

import numpy as np
import pytest

import acausal
from acausal.errors import LookupProblem, SyntaxProblem, UsageProblem
from acausal.sources import ParameterValue, as_modelica

SPRING = """\
model Spring "A mass on a spring <b>"
  parameter Integer n = 2 "How many";
  parameter Real c[n] = {1, 2} "Stiffnesses";
  Real s(unit = "m", start = 1, fixed = true) "Position & more";
  Real v(unit = "m/s", start = 0, fixed = true);
  Real a(unit = "m/s2") = der(v);
equation
  der(s) = v;
  a = -sum(c)*s;
end Spring;
"""


@pytest.mark.parametrize("name", ["acausal", "acausal.api"])
def test_docstrings_are_true(name: str) -> None:
    failed, tried = doctest.testmod(importlib.import_module(name))
    assert tried > 0
    assert failed == 0


def test_everything_public_is_there() -> None:
    for name in acausal.__all__:
        assert getattr(acausal, name) is not None
        assert name in dir(acausal)
    with pytest.raises(AttributeError, match="no attribute 'nothing'"):
        _ = acausal.nothing


def test_text_becomes_a_model() -> None:
    model = acausal.loads(SPRING)
    assert repr(model) == "<Model Spring>"
    assert model.check() == ()
    compiled = model.compile()
    assert (compiled.name, compiled.states, compiled.index) == ("Spring", ("s", "v"), 0)
    assert repr(compiled) == "<CompiledModel Spring: index 0, 2 states (s, v)>"
    assert compiled.summary["equations"] == 3
    assert "causal system Spring" in compiled.show("causal")
    assert "model Spring" in model.show("ast")


PARAMETERS: list[dict[str, ParameterValue]] = [
    {"n": 1, "c": [9.0]},
    {"n": np.int64(1), "c": np.array([9.0])},
    {"n": "2-1", "c": "{9}"},
]


@pytest.mark.parametrize("parameters", PARAMETERS)
def test_parameters_of_every_kind(parameters: dict[str, ParameterValue]) -> None:
    result = acausal.loads(SPRING).compile(parameters).simulate(stop_time=np.pi / 3, rtol=1e-8)
    assert float(result["s"][-1]) == pytest.approx(-1, abs=1e-5)
    assert float(result["c[1]"][-1]) == 9.0


@pytest.mark.parametrize(
    ("value", "text"),
    [
        (True, "true"),
        (3, "3"),
        (-0.5, "-0.5"),
        (np.float64(0.1), "0.1"),
        ("Types.Mode.open", "Types.Mode.open"),
        ([1, (2.5, False)], "{1, {2.5, false}}"),
    ],
)
def test_values_become_modelica(value: ParameterValue, text: str) -> None:
    assert as_modelica(value) == text


@pytest.mark.parametrize("value", [float("nan"), float("inf")])
def test_not_a_number_is_no_value(value: float) -> None:
    with pytest.raises(UsageProblem, match="no value for `c`"):
        acausal.loads(SPRING).compile(c=value)


def test_classes_of_a_text() -> None:
    text = "package P model A Real x = 1; end A; model B Real x = 1; end B; end P; model C P.A a; end C;"
    assert acausal.loads(text).name == "C"
    assert acausal.loads(text, name="P.A").name == "P.A"
    with pytest.raises(LookupProblem):
        acausal.loads(text, name="D")
    with pytest.raises(SyntaxProblem, match="no class"):
        acausal.loads("// nothing")


def test_file_in_a_package_finds_its_siblings(tmp_path: Path) -> None:
    folder = tmp_path / "P"
    folder.mkdir()
    (folder / "package.mo").write_text("package P end P;")
    (folder / "A.mo").write_text("within P; model A Real x = 1; end A;")
    (folder / "B.mo").write_text("within P; model B A a; end B;")
    assert acausal.load(folder / "B.mo").compile().name == "P.B"
    assert acausal.load("P.B", path=[tmp_path]).compile().states == ()


@pytest.mark.parametrize("name", ["nothing.mo", "no class", "a/b", ".", "", "1x"])
def test_what_cannot_be_a_model(name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    with pytest.raises(UsageProblem):
        acausal.load(name)


def test_html_shows_the_system() -> None:
    html = acausal.loads(SPRING).compile()._repr_html_()  # pyright: ignore[reportPrivateUsage]
    assert "A mass on a spring &lt;b&gt;" in html
    assert "Position &amp; more" in html
    assert "<dt>index</dt><dd>0</dd>" in html
    assert html.count("<table>") == html.count("</table>") >= 2


def test_html_injects_nothing() -> None:
    evil = "<script>alert(1)</script>"
    text = f'model M "{evil}" Real \'{evil}\'(unit = "{evil}", start = 1) "{evil}"; Real y = \'{evil}\'; '
    html = acausal.loads(f"{text} equation der('{evil}') = -1; end M;").compile()._repr_html_()  # pyright: ignore[reportPrivateUsage]
    assert "<script" not in html
    assert "&lt;script&gt;" in html


def test_html_of_a_large_model_is_cut() -> None:
    text = "model Chain Real x[500](each start = 1); equation der(x) = -x; end Chain;"
    html = acausal.loads(text).compile()._repr_html_()  # pyright: ignore[reportPrivateUsage]
    assert "and 300 more lines" in html
