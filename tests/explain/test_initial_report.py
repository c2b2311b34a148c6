"""What is told of the initial point, of lines that differ in an index only, and of a singular model."""

from __future__ import annotations

import pytest

import acausal
from acausal.explain.folding import folded
from acausal.explain.singular import singular_text
from acausal.explain.singular_plot import singular_page
from acausal.explain.start import InitialReport, initial_report
from acausal.explain.text import explanation_text
from tests.explain.models import explained

TEXT = """\
model Falls
  Real s[3](each start = 2, fixed = {true, true, false}), v[3](start = {1, 1, 5}), f(start = 1);
  Real rest;
equation
  for i in 1:3 loop
    der(s[i]) = v[i];
    der(v[i]) = f - 2;
  end for;
  f^3 + f = 10 + der(rest);
  der(rest) = 0;
end Falls;
"""


@pytest.fixture(scope="module")
def report() -> InitialReport:
    return initial_report(acausal.loads(TEXT).compile().code)


def test_starts_are_told_by_their_use(report: InitialReport) -> None:
    uses = {start.name: start.use for start in report.starts}
    assert uses["s[1]"] == "fixed"
    assert uses["s[3]"] == uses["v[1]"] == "assumed"
    assert uses["rest"] == "nobody"
    (guess,) = [start for start in report.starts if start.use == "guess"]
    assert (guess.name, guess.start) == ("f", 1)
    assert guess.value == pytest.approx(2)


def test_motion_and_residuals(report: InitialReport) -> None:
    assert dict(report.moving) == pytest.approx({"s[1]": 1, "s[2]": 1, "s[3]": 5}, abs=1e-12)
    assert report.moving[0][0] == "s[3]"  # 5 for a value of 2
    (held,) = report.held
    assert held.residual < 1e-12
    assert held.equation.flat.span.line == 9


def test_residuals_are_relative_to_the_terms() -> None:
    text = "model Root Real x(start = 1); equation 0 = x^3 + x*exp(x) - 2.3; end Root;"
    (held,) = initial_report(acausal.loads(text).compile().code).held
    assert 0 < held.residual < 1e-12


def test_its_text_folds_what_is_alike(report: InitialReport) -> None:
    assert "\n  s[1:2] = 2\n" in report.text()
    assert "\n  s[1] = 2\n  s[2] = 2\n" in report.text(everything=True)
    assert "  f = 1  ->  2\n" in report.text()


def test_lines_that_differ_in_indices_only() -> None:
    assert folded(["a[1].x = b[1]", "c", "a[2].x = b[2]"]) == ["a[1:2].x = b[1:2]", "c"]
    assert folded(["a[1].x[2]", "a[2].x[2]"]) == ["a[1:2].x[2]"]
    assert folded(["a[2] = b[1]", "a[3] = b[2]"]) == ["a[2:3] = b[1:2]"]
    assert folded(["a[1]", "a[3]"]) == ["a[1]  (and 1 more of other indices)"]
    assert folded(["a[1, 2]", "a[1, 3]"]) == ["a[1, 2]  (and 1 more of other indices)"]
    assert folded(["a[1]", "a[1].b"]) == ["a[1]", "a[1].b"]


def test_an_explanation_counts_all_and_tells_each_once() -> None:
    text = explanation_text(explained(TEXT))
    assert "7 states" in text
    assert "  v[1:3]  its derivative appears" in text


def test_a_singular_model_shows_its_parts() -> None:
    model = acausal.loads("model M Real x, y, z; equation x = 1; x = 2; z = 3; end M;")
    found = model.run({}, "flat").flat
    assert found is not None
    text = singular_text(found)
    assert "3 equations in 3 unknowns, 1 equation of which" in text
    assert "Too many equations: 2 equations for 1 unknown\n  `x = 1`" in text
    assert "Too few equations: 0 equations for 1 unknown\n  unknown y" in text
    page = singular_page(found, "the error <1>")
    assert "the error &lt;1&gt;" in page
    assert "<svg" in page
    assert "Too many equations" in page


def test_connectors_that_may_be_forgotten_are_listed() -> None:
    text = """model M
      Mechanics.Rotational.Components.Inertia a[2](each J = 1);
      Mechanics.Rotational.Components.IdealGear gear(ratio = 2);
    equation connect(a[1].flange_b, gear.flange_a); connect(a[2].flange_b, gear.flange_a); end M;"""
    explanation = explained(text)
    assert explanation.to_json()["unconnected"] == ["a[1].flange_a", "a[2].flange_a", "gear.flange_b"]
    assert "no flow passes: a[1:2].flange_a, gear.flange_b\n" in explanation.text
