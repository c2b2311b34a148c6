"""Discrete variables and when-clauses, against closed forms and by counting."""

from __future__ import annotations

import numpy as np
import pytest

import acausal
from acausal.errors import InitializationProblem, SimulationProblem
from acausal.simulate.result import Result


def run(text: str, stop: float, rtol: float | None = None, interval: float | None = None) -> Result:
    return (
        acausal.loads(f"model M\n{text}\nend M;\n")
        .compile()
        .simulate(stop_time=stop, rtol=rtol, interval=interval)
    )


BALL = """
  parameter Real e = 0.9, g = 9.81;
  Real h(start = 1, fixed = true), v(start = 0, fixed = true);
  Integer n(start = 0, fixed = true);
  discrete Real last(start = 0, fixed = true);
equation
  der(h) = v;
  der(v) = -g;
  when h <= 0 then
    reinit(v, -e*pre(v));
    n = pre(n) + 1;
    last = time;
  end when;
"""


@pytest.mark.parametrize("solver", ["rodas", "cvode"])
def test_bouncing_ball_through_twenty_impacts(solver: str) -> None:
    e, g = 0.9, 9.81
    fall = np.sqrt(2 / g)
    impacts = fall + np.concatenate([[0.0], np.cumsum(2 * fall * e ** np.arange(1, 20))])
    stop = float(impacts[-1] + fall * e**20)
    result = (
        acausal.loads(f"model M {BALL} end M;").compile().simulate(stop_time=stop, rtol=1e-9, solver=solver)
    )
    assert result.values("n")[-1] == 20
    assert result.statistics.events == 20
    found = np.unique(result.values("last"))[1:]
    assert found == pytest.approx(impacts, rel=1e-6)
    assert result.values("v")[-1] == pytest.approx(0.0, abs=1e-4)


def test_both_sides_of_an_event_are_recorded() -> None:
    result = run(BALL, 1.0)
    time, n = result.time, result.values("n")
    jump = int(np.flatnonzero(np.diff(n))[0])
    assert time[jump] == time[jump + 1]
    assert result.values("v")[jump] == pytest.approx(-result.values("v")[jump + 1] / 0.9)


def test_accumulating_impacts_are_explained() -> None:
    with pytest.raises(SimulationProblem) as caught:
        run(BALL.replace("e = 0.9", "e = 0.5"), 3.0)
    assert caught.value.codes[0] == "simulate.zeno"
    assert "h" in caught.value.diagnostics[0].names


def test_hysteresis_turns_back_at_its_bounds() -> None:
    result = run(
        """Real x(start = 0, fixed = true); Boolean up(start = true, fixed = true);
        equation der(x) = if up then 1 else -1; up = if pre(up) then x < 1 else x < 0.5;""",
        5.0,
    )
    x = result.values("x")
    assert x.max() == pytest.approx(1.0, abs=1e-8)
    assert x[result.time > 1].min() == pytest.approx(0.5, abs=1e-8)
    assert result.statistics.events == 9


def test_sampled_controller_follows_its_recursion() -> None:
    result = run(
        """Real x(start = 1, fixed = true); discrete Real u(start = 0, fixed = true);
        equation der(x) = u; when sample(0, 0.1) then u = -2*x; end when;""",
        1.0,
    )
    assert result.values("x")[-1] == pytest.approx(0.8**10, rel=1e-7)
    assert result.statistics.events == 10  # and one at the start


def test_sample_instants_are_exact() -> None:
    result = run(
        """discrete Real at(start = -1, fixed = true); Integer k(start = 0, fixed = true);
        equation when sample(0.05, 0.1) then at = time; k = pre(k) + 1; end when;""",
        1.0,
    )
    assert np.unique(result.values("at"))[1:] == pytest.approx(0.05 + 0.1 * np.arange(10), abs=1e-15)
    assert result.values("k")[-1] == 10


def test_time_events_that_set_the_next_one() -> None:
    result = run(
        """discrete Real next(start = 0.1, fixed = true); Integer k(start = 0, fixed = true);
        equation when time >= pre(next) then next = 2*pre(next); k = pre(k) + 1; end when;""",
        3.0,
    )
    assert result.values("k")[-1] == 5
    assert result.statistics.steps == 0


def test_the_first_branch_that_fires_acts() -> None:
    result = run(
        """Integer a(start = 0, fixed = true); Real x(start = 0, fixed = true);
        equation der(x) = 1;
        when x > 0.5 then a = 1; elsewhen time >= 0.5 then a = 2; elsewhen x > 0.75 then a = 3; end when;""",
        1.0,
    )
    assert result.values("a")[result.time == 0.6].tolist() == [1.0]
    assert result.values("a")[-1] == 3


def test_simultaneous_events_are_one() -> None:
    result = run(
        """Integer a(start = 0, fixed = true), b(start = 0, fixed = true), c(start = 0, fixed = true);
        equation
        when sample(0, 0.1) then a = pre(a) + 1; end when;
        when sample(0, 0.3) then b = pre(b) + 1; end when;
        when time >= 0.3 then c = pre(a) + 10*b; end when;""",
        1.0,
    )
    assert result.statistics.events == 10  # and one at the start
    assert result.values("a")[-1] == 11
    assert result.values("b")[-1] == 4
    assert result.values("c")[-1] == 3 + 10 * 2


def test_edge_change_and_pre() -> None:
    result = run(
        """Boolean b; Integer ups(start = 0, fixed = true), both(start = 0, fixed = true);
        equation b = sin(10*time) > 0.1;
        when edge(b) then ups = pre(ups) + 1; end when;
        when change(b) then both = pre(both) + 1; end when;""",
        3.0,
    )
    assert result.values("ups")[-1] == 5
    assert result.values("both")[-1] == 10


def test_an_event_without_end_names_its_variable() -> None:
    with pytest.raises(SimulationProblem) as caught:
        run(
            """Boolean b(start = false, fixed = true); Real x(start = 0, fixed = true);
            equation der(x) = 1; b = if x > 0.5 then not pre(b) else pre(b);""",
            1.0,
        )
    assert caught.value.codes == ("simulate.event-iteration",)
    assert caught.value.diagnostics[0].names == ("b",)


@pytest.mark.parametrize(
    ("text", "code", "hint"),
    [
        (
            "when x > 0.5 then i = j + 1; end when; when x > 0.5 then j = i + 1; end when;",
            "event-iteration",
            "pre(j)",
        ),
        (
            "y = x - i; when y > 0.5 then i = j + 1; end when; when y < 0.2 then j = i + 1; end when;",
            "mode-cycle",
            "pre(i)",
        ),
        ("y = if y > 0.5 then x - 1 else x; i = 0; j = 0;", "mode-cycle", "without a jump"),
    ],
)
def test_the_hint_fits_what_goes_round(text: str, code: str, hint: str) -> None:
    declared = (
        "Real x(start = 0, fixed = true), y; Integer i(start = 0, fixed = true), j(start = 0, fixed = true);"
    )
    rest = "" if "y =" in text else "y = x;"
    with pytest.raises(SimulationProblem) as caught:
        run(f"{declared} equation der(x) = 1; {rest} {text}", 1.0)
    assert caught.value.codes == (f"simulate.{code}",)
    assert hint in (caught.value.diagnostics[0].hint or "")


def test_whole_numbers_change_both_ways() -> None:
    result = run(
        """Real x = 3*sin(time); Real low, up, whole, turned;
        equation low = floor(x); up = ceil(x); whole = div(x, 1.5); turned = mod(time, 0.7);""",
        6.0,
    )
    x = result.values("x")
    inside = np.abs(x - np.round(x)) > 1e-6
    assert (result.values("low") == np.floor(x))[inside].all()
    assert (result.values("up") == np.ceil(x))[inside].all()
    parts = np.abs(x / 1.5 - np.round(x / 1.5)) > 1e-6
    assert (result.values("whole") == np.trunc(x / 1.5))[parts].all()
    turned = np.mod(result.time, 0.7)
    away = (turned > 1e-6) & (turned < 0.7 - 1e-6)
    assert result.values("turned")[away] == pytest.approx(turned[away], abs=1e-12)
    assert result.statistics.events == 9 + 4 + 8  # at whole numbers, at +-1.5, at multiples of 0.7


def test_two_thousand_events_none_missed_or_doubled() -> None:
    result = run(
        """Real x(start = 0, fixed = true), v(start = 1000, fixed = true); Integer n(start = 0, fixed = true);
        equation der(x) = v; der(v) = -1e6*x; when x > 0.5 then n = pre(n) + 1; end when;""",
        6.2833,
        interval=0.1,
    )
    assert result.values("n")[-1] == 1000
    assert result.statistics.events == 2000


def test_reset_of_a_reduced_system() -> None:
    """Two masses behind a gear are one degree of freedom; their speeds are aliases."""
    result = run(
        """parameter Real J = 2; Real w1(start = 0, fixed = true), w2, t1, t2; Boolean hit;
        equation J*der(w1) = 3 - t1; J*der(w2) = t2; w2 = -w1; t2 = -t1; hit = w1 > 1;
        when hit then reinit(w1, -pre(w1)); end when;""",
        4.0,
    )
    period = 2.0 / 0.75
    t = result.time
    assert result.statistics.events >= 2
    expected = np.where(t * 0.75 < 1, t * 0.75, (t * 0.75 + 1) % (period * 0.75) - 1)
    away = np.abs(expected) < 0.999
    assert result.values("w1")[away] == pytest.approx(expected[away], abs=1e-6)
    assert result.values("w2") == pytest.approx(-result.values("w1"))


def test_initial_values_of_discrete_variables() -> None:
    result = run(
        """Integer a(start = 3), b, c(start = 5, fixed = true); Real x(start = 0, fixed = true); Boolean on;
        initial equation pre(b) = 7;
        initial algorithm a := 4;
        equation der(x) = 1; on = x > -1;
        when x > 0.5 then a = pre(a) + 1; b = pre(b) + 1; end when;
        when {initial(), x > 0.5} then c = pre(c) + 1; end when;""",
        1.0,
    )
    assert [result.values(n)[0] for n in "abc"] == [4, 7, 6]
    assert [result.values(n)[-1] for n in "abc"] == [5, 8, 7]
    assert result.values("on").all()


def test_too_many_initial_conditions_of_a_discrete_variable() -> None:
    with pytest.raises(InitializationProblem) as caught:
        run(
            """Integer a; initial equation a = 1; a = 2;
            equation when time > 1 then a = pre(a) + 1; end when;""",
            1.0,
        )
    assert caught.value.codes == ("initial.discrete-overdetermined",)


def test_terminate_ends_the_run_with_its_message() -> None:
    result = run(
        """Real x(start = 0, fixed = true);
        equation der(x) = 1; when x > 0.3 then terminate("full"); end when;""",
        1.0,
    )
    assert result.ended is not None
    assert result.ended.message == "full"
    assert result.time[-1] == pytest.approx(0.3, abs=1e-6)


def test_assertion_in_a_when_clause_counts_at_its_event_only() -> None:
    text = """Real x(start = 0, fixed = true); equation der(x) = 1;
        when x > 0.5 then assert(x < {}, "too far"); end when;"""
    assert run(text.format("0.6"), 1.0).values("x")[-1] == pytest.approx(1.0)
    with pytest.raises(SimulationProblem) as caught:
        run(text.format("0.4"), 1.0)
    assert caught.value.codes == ("simulate.assertion",)


def test_the_terminal_event() -> None:
    result = run("Boolean last(start = false); equation last = terminal();", 1.0)
    assert result.values("last").tolist()[-2:] == [0.0, 1.0]


def test_same_run_twice_gives_the_same_bytes() -> None:
    first, second = run(BALL, 2.0), run(BALL, 2.0)
    assert first.data.tobytes() == second.data.tobytes()
