"""Roots followed over a parameter: through crossings, veering, and where two meet."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import acausal
from acausal.analysis.sweep import spaced, sweep, table_of
from acausal.errors import AcausalError, UsageProblem

THREE = """model Three "Two oscillators that are coupled, one that is not"
  parameter Real k(unit = "N/m") = 1, c = 0, e = 0.01, d = 0.05;
  Real x(start = 0), v(start = 0), y(start = 0), w(start = 0), a(start = 0), b(start = 0);
equation
  der(x) = v; der(v) = -k*x - e*(x - y) - d*v; der(y) = w; der(w) = -y - e*(y - x) - d*w;
  der(a) = b; der(b) = -1.2*a - c*b;
end Three;"""


def test_crossing_and_veering() -> None:
    locus = acausal.loads(THREE).compile().root_locus("k", np.linspace(0.5, 2, 16).tolist())
    frequencies = np.abs(locus.roots[:, ::2])
    assert not locus.branches.in_doubt
    alone = np.abs(frequencies - np.sqrt(1.2)).max(axis=0) < 1e-9
    assert alone.tolist() == [False, False, True]  # a branch crosses it, and neither notices
    low, high = frequencies[:, 0], frequencies[:, 1]
    assert (low < high).all()  # the coupled two turn away from each other
    assert low[-1] == pytest.approx(np.sqrt(1.01), rel=1e-2)
    assert locus.unit == "N/m"


def test_where_a_pair_becomes_real_is_said() -> None:
    locus = acausal.loads(THREE).compile().root_locus("c", np.linspace(0, 4, 21).tolist())
    assert locus.branches.in_doubt == (pytest.approx(2.2),)
    ends = np.sort(locus.roots[-1].real)[:1]
    assert ends[0] == pytest.approx(-2 - np.sqrt(4 - 1.2))
    assert locus.to_xarray().dims == ("c", "branch")


def test_fixed_settings_and_start_values() -> None:
    text = "model N Real x(start = 1, fixed = true); parameter Real a = 1; equation der(x) = -a*x^2; end N;"
    compiled = acausal.loads(text).compile()
    locus = compiled.root_locus("x", [1.0, 2.0, 3.0], parameters={"a": 2.0})
    np.testing.assert_allclose(locus.roots[:, 0], [-4, -8, -12])


def test_ranges_and_tables(tmp_path: Path) -> None:
    assert spaced("a.k=1:2:3") == ("a.k", (1.0, 1.5, 2.0))
    for wrong in ("k=1:2", "k=1:2:1", "=1:2:3", "k=1:x:3", "k=1:inf:3", "k=1:2:3:4"):
        with pytest.raises(UsageProblem, match="name=a:b:n"):
            spaced(wrong)
    table = tmp_path / "t.csv"
    table.write_text("k, c\n1,2\n3,4\n", encoding="utf-8")
    assert table_of(table) == {"k": (1.0, 3.0), "c": (2.0, 4.0)}
    for text in ("", "k\n", "k,k\n1,2\n", "k,c\n1\n", "k\nx\n"):
        table.write_text(text, encoding="utf-8")
        with pytest.raises(UsageProblem, match="no table of variants"):
            table_of(table)


def test_the_value_that_fails_is_named() -> None:
    model = acausal.loads(
        "model E parameter Real k = 1; Real x(start = 1, fixed = true), w; "
        "equation w = log(2 - k); der(x) = -x * w; end E;"
    ).compile()
    with pytest.raises(AcausalError, match=r"\(variant 4: k = 2\)") as caught:
        sweep(model.code, "k", [0.5, 1.0, 1.5, 2.0, 2.5])
    assert "k" in caught.value.diagnostics[0].names
