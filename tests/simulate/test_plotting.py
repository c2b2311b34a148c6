"""Plots: panels by unit, display units, deterministic files."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from acausal.codegen.functions import generate
from acausal.errors import LookupProblem, UsageProblem
from acausal.plotting import DISPLAY_FACTORS, plot
from acausal.simulate.result import Result
from acausal.simulate.simulate import simulate
from acausal.symbolic.expressions import expr as e
from acausal.symbolic.expressions.expr import const, sym
from tests.codegen.systems import explicit, hand_system, rate


def result() -> Result:
    system = hand_system(
        {"p": 1e5, "w": 1.0},
        [explicit(sym("$_q"), sym("p")), rate("p", const(0.0)), rate("w", e.neg(sym("w")))],
        units={"p": "Pa", "w": "rad/s", "$_q": "Pa"},
    )
    variables = tuple(replace(v, display_unit="bar") if v.name == "p" else v for v in system.flat.variables)
    return simulate(generate(replace(system, flat=replace(system.flat, variables=variables))))


def test_panels_are_units_and_known_display_units_are_used() -> None:
    figure = plot(result(), ["p", "w"])
    first, second = figure.axes
    assert [first.get_ylabel(), second.get_ylabel()] == ["p [bar]", "w [rad/s]"]
    assert np.asarray(first.lines[0].get_ydata())[0] == pytest.approx(1.0)
    assert second.get_xlabel() == "time [s]"


@pytest.mark.parametrize("suffix", [".png", ".svg", ".pdf"])
def test_files_are_deterministic(tmp_path: Path, suffix: str) -> None:
    paths = [tmp_path / f"{name}{suffix}" for name in "ab"]
    for path in paths:
        plot(result(), ["p", "w", "$_q"], path)
    assert paths[0].read_bytes() == paths[1].read_bytes()
    assert len(paths[0].read_bytes()) > 2000


def test_wrong_names_and_file_types() -> None:
    with pytest.raises(LookupProblem):
        plot(result(), ["pp"])
    with pytest.raises(UsageProblem):
        plot(result(), ["p"], "plot.docx")


def test_factors_are_consistent() -> None:
    assert DISPLAY_FACTORS["rad/s", "rpm"] == pytest.approx(60 / (2 * np.pi))
    assert DISPLAY_FACTORS["m3/s", "l/min"] == 1000 * 60
