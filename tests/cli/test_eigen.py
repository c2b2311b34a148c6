"""`acausal eigen`: what it prints, what it writes, what it refuses."""

from __future__ import annotations

from pathlib import Path
from typing import cast

import pytest

from tests.cli.calls import Call

SPRING = """model Spring "A mass on a spring, which a stop makes stiffer below"
  parameter Real m(unit = "kg") = 1;
  parameter Real c(unit = "N/m") = 100, d(unit = "N.s/m") = 2, stop(unit = "N/m") = 900;
  Real s(unit = "m", start = 0.5, fixed = true), v(unit = "m/s", start = 0, fixed = true);
equation
  der(s) = v; m*der(v) = -c*s - d*v - (if s < 0 then stop*s else 0);
  annotation(experiment(StopTime = 1, Interval = 0.01));
end Spring;
"""

EIGENVALUE = {
    "re",
    "im",
    "frequency_hz",
    "damping_ratio",
    "participation",
}


@pytest.fixture(autouse=True)
def spring(working_directory: Path) -> None:
    (working_directory / "Spring.mo").write_text(SPRING, encoding="utf-8")
    (working_directory / "v.csv").write_text("c,d\n100,2\n400,2\n", encoding="utf-8")


def listed(value: object) -> list[dict[str, object]]:
    assert isinstance(value, list)
    return cast("list[dict[str, object]]", value)


def test_one_instant_is_an_object(call: Call) -> None:
    data = call("eigen", "Spring.mo", "--at", "steady", "--json").data
    assert set(data) >= {"time", "states", "eigenvalues", "max_step"}
    assert (data["time"], data["states"]) == (0.0, ["s", "v"])
    roots = listed(data["eigenvalues"])
    assert [set(root) >= EIGENVALUE for root in roots] == [True, True]
    assert roots[0]["re"] == pytest.approx(-1)
    assert roots[0]["im"] == pytest.approx(99**0.5)
    assert sum(cast("dict[str, float]", roots[0]["participation"]).values()) == pytest.approx(1)
    assert set(cast("dict[str, float]", data["max_step"])) == {"euler", "ab2", "heun", "rk3", "dopri5"}


def test_several_are_a_list(call: Call) -> None:
    data = listed(call("eigen", "Spring.mo", "--at", "initial,0.2", "--at", "0.3", "--json").json)
    assert [entry["time"] for entry in data] == [0.0, 0.2, 0.3]
    assert [len(listed(entry["warnings"])) > 0 for entry in data] == [True, True, True]


def test_the_table(call: Call) -> None:
    done = call("eigen", "Spring.mo", "--at", "steady")
    assert done.out.startswith("Spring in its steady state at 0 s: 2 states, at rest\n")
    assert "-1 ± 9.95i" in done.out
    assert "longest stable step: euler 0.02 s" in done.out
    assert done.err == ""
    assert "not at rest: der(v)" in call("eigen", "Spring.mo").err


def test_a_stored_result(call: Call) -> None:
    call("simulate", "Spring.mo", "-o", "r.csv")
    one = call("eigen", "Spring.mo", "--at", "0.2", "--result", "r.csv", "--json").data
    other = call("eigen", "Spring.mo", "--at", "0.2", "--json").data
    got, wanted = listed(one["eigenvalues"])[0], listed(other["eigenvalues"])[0]
    assert got["im"] == pytest.approx(wanted["im"], rel=1e-6)
    assert wanted["im"] == pytest.approx(999**0.5)  # on the stop
    assert call("eigen", "Spring.mo", "--at", "5", "--result", "r.csv").status == 2


def test_comparison(call: Call, working_directory: Path) -> None:
    stiff = SPRING.replace("model Spring", "model Stiff").replace("end Spring", "end Stiff")
    (working_directory / "Stiff.mo").write_text(stiff.replace("= 100", "= 121"), encoding="utf-8")
    done = call("eigen", "Spring.mo", "--compare", "Stiff.mo", "--plot", "c.html")
    assert "compared with Stiff at its start" in done.out
    assert "+10.0%" in done.out
    data = call("eigen", "Spring.mo", "--compare", "Stiff.mo", "--json").below("compare")
    assert listed(data["modes"])[0]["frequency_change"] == pytest.approx(0.1)


def test_sweep_and_variants(call: Call, working_directory: Path) -> None:
    done = call("eigen", "Spring.mo", "--sweep", "c=100:400:4", "--plot", "s.svg")
    assert "4 values of c from 100 to 400 N/m" in done.out
    data = call("eigen", "Spring.mo", "--sweep", "c=100:400:4", "--json").data
    assert listed(data["branches"])[0]["im"] == pytest.approx([99**0.5, 199**0.5, 299**0.5, 399**0.5])
    assert listed(data["variants"])[2]["parameters"] == {"c": 300.0}
    table = call("eigen", "Spring.mo", "--variants", "v.csv", "--plot", "v.png")
    assert "2 variants of 2 states" in table.out
    rows = listed(call("eigen", "Spring.mo", "--variants", "v.csv", "--json").data["variants"])
    assert listed(rows[1]["eigenvalues"])[0]["im"] == pytest.approx(399**0.5)
    assert {"s.svg", "v.png"} <= {path.name for path in working_directory.iterdir()}


def test_pictures_of_one_mode(call: Call, working_directory: Path) -> None:
    assert call("eigen", "Spring.mo", "--mode", "1", "--plot", "m.svg").status == 0
    assert call("eigen", "Spring.mo", "--animate-mode", "1", "--plot", "m.gif").status == 0
    assert call("eigen", "Spring.mo", "--animate-mode", "1", "--plot", "m.html").status == 0
    assert (working_directory / "m.gif").stat().st_size > 1000


@pytest.mark.parametrize(
    "arguments",
    [
        ("--at", "soon"),
        ("--at", "-1"),
        ("--sweep", "c=1:2"),
        ("--sweep", "c=1:2:3", "--at", "0.1,0.2"),
        ("--sweep", "c=1:2:3", "--variants", "v.csv"),
        ("--sweep", "s=1:2:3", "--compare", "Spring.mo"),
        ("--plot", "x.txt"),
        ("--mode", "1"),
        ("--mode", "9", "--plot", "x.svg"),
        ("--animate-mode", "1", "--plot", "x.svg"),
        ("--result", "none.csv"),
        ("--variants", "none.csv"),
    ],
)
def test_what_is_refused(call: Call, arguments: tuple[str, ...]) -> None:
    done = call("eigen", "Spring.mo", *arguments)
    assert done.status == 2
    assert "error: " in done.err
