"""Values that are no numbers, wherever they come up: all solvers name the place and keep the rows before."""

from __future__ import annotations

import numpy as np
import pytest

import acausal
from acausal.errors import SimulationProblem, UnsupportedProblem, UsageProblem

CASES = {
    "condition": (
        "der(x) = if log(0.5 - x) > -100 then 1 else 2;",
        "the condition `log(-x + 0.5) > -100`",
        "x",
    ),
    "when": (
        "der(x) = 1; when sqrt(0.5 - x) > 3 then k = 1; end when;",
        "the condition `sqrt(-x + 0.5) > 3`",
        "x",
    ),
    "assertion": (
        'der(x) = 1; assert(sqrt(0.5 - x) < 10, "x");',
        "the condition `sqrt(-x + 0.5) < 10`",
        "x",
    ),
    "body": ("der(x) = 1; when x > 0.5 then k = log(0.2 - x); end when;", "`k` is not a number", "k"),
    "reinit": (
        "der(x) = 1; when x > 0.5 then reinit(x, log(0.2 - x)); end when;",
        "`reinit(x, log(-x + 0.2))` gives nan",
        "x",
    ),
    "output": ("der(x) = 1; z = sqrt(0.5 - x);", "z is not a number", "z"),
    "loop": ("der(x) = 1; z + sqrt(0.5 - x) * y = 1; y - 2 * z = 1;", "`z + sqrt(-x + 0.5) * y = 1`", "z"),
}
SOLVERS = ["rodas", "cvode", "ida", "heun", "rosenbrock"]


@pytest.fixture(scope="module")
def compiled() -> dict[str, acausal.CompiledModel]:
    def text(name: str) -> str:
        equations = CASES[name][0]
        declared = [f"Real {n};" for n in ("y", "z") if f"{n} " in equations and name in ("output", "loop")]
        discrete = "discrete Real k(start = 0, fixed = true);" if "k =" in equations else ""
        variables = f"Real x(start = 0, fixed = true); {discrete} {' '.join(declared)}"
        return f"model M {variables} equation {equations} end M;"

    return {name: acausal.loads(text(name)).compile() for name in CASES}


@pytest.mark.parametrize("solver", SOLVERS)
@pytest.mark.parametrize("name", sorted(CASES))
def test_not_a_number_is_named(
    compiled: dict[str, acausal.CompiledModel],
    name: str,
    solver: str,
    capfd: pytest.CaptureFixture[str],
) -> None:
    kept: list[acausal.Result] = []
    with pytest.raises(SimulationProblem) as caught:
        compiled[name].simulate(solver=solver, step=0.02, interval=0.02, keep=kept.append, compiled=False)
    found = caught.value.diagnostics[0]
    _, text, variable = CASES[name]
    assert found.code == "simulate.not-finite"
    assert text in found.message
    assert "at time 0.5" in found.message
    assert variable in found.names
    assert found.span is not None
    assert 0.45 < kept[0].time[-1] < 0.53
    assert np.isfinite(kept[0].data).all()
    assert capfd.readouterr() == ("", "")


@pytest.mark.parametrize("solver", ["cvode", "ida", "rodas", "heun"])
@pytest.mark.parametrize("events", ["locate", "step"])
def test_integers_fall_and_rise_as_their_argument_does(solver: str, events: str) -> None:
    """A crossing changes the number once, whatever rounding leaves of the argument."""
    text = (
        "model W Integer up, down; Real x(start = 0, fixed = true); "
        "equation up = integer(40 * x); down = integer(-37 * x); der(x) = 1; end W;"
    )
    run = acausal.loads(text).compile().simulate(solver=solver, events=events, step=0.02, compiled=False)
    x = run.values("x")
    away = (np.abs(40 * x - np.round(40 * x)) > 1e-6) & (np.abs(37 * x - np.round(37 * x)) > 1e-6)
    assert away.sum() > 300
    late = 1 if events == "step" else 0  # until the step ends
    for name, factor in (("up", 40), ("down", -37)):
        off = np.abs(run.values(name) - np.floor(factor * x))[away]
        assert off.max() <= late


@pytest.mark.parametrize("solver", ["cvode", "ida", "rodas", "rk3"])
def test_ball_that_comes_to_rest_is_told_not_lost(solver: str) -> None:
    """Flights below the tolerance, which one step covers whole, do not let it fall through the floor."""
    text = """model B Real h(start = 1, fixed = true), v(start = 0, fixed = true); equation
    der(h) = v; der(v) = -9.81; when h <= 0 then reinit(v, -0.6 * pre(v)); end when; end B;"""
    kept: list[acausal.Result] = []
    with pytest.raises(SimulationProblem, match="events accumulate") as caught:
        acausal.loads(text).compile().simulate(
            stop_time=5.0, solver=solver, step=0.01, keep=kept.append, compiled=False
        )
    assert caught.value.codes == ("simulate.zeno",)
    assert kept[0].values("h").min() > -1e-6


@pytest.mark.parametrize("solver", ["cvode", "rodas"])
def test_accumulation_is_told_before_it_is_passed(solver: str) -> None:
    """Two tanks with one pipe (Johansson et al., On the regularization of Zeno hybrid automata, 1999)."""
    text = """model T Real a(start = 1, fixed = true), b(start = 1, fixed = true);
      Boolean first(start = true, fixed = true); equation
      der(a) = (if first then 1.8 else 0) - 1; der(b) = (if first then 0 else 1.8) - 1;
      when a < 0 then first = true; elsewhen b < 0 then first = false; end when; end T;"""
    with pytest.raises(SimulationProblem, match="apart, all by the conditions `a < 0`") as caught:
        acausal.loads(text).compile().simulate(stop_time=20.0, solver=solver, compiled=False)
    assert set(caught.value.diagnostics[0].names) >= {"a", "b"}


def test_samples_and_delays_that_cannot_be_are_shown_where_they_stand() -> None:
    for call, code in (
        ("when sample(0, q) then reinit(x, 0); end when;", "simulate.sample-interval"),
        ("when sample(0, sqrt(q)) then reinit(x, 0); end when;", "simulate.sample-interval"),
        ("z = delay(x, q);", "simulate.delay"),
        ("when sample(0, 1e-9) then reinit(x, 0); end when;", "simulate.zeno"),
    ):
        declared = "Real z; " if "z =" in call else ""
        declared += "Real x(start = 0, fixed = true); parameter Real q = -1;"
        text = f"model S {declared} equation\nder(x) = 1;\n{call} end S;"
        with pytest.raises(SimulationProblem) as caught:
            acausal.loads(text).compile().simulate(compiled=False)
        found = caught.value.diagnostics[0]
        assert found.code == code
        assert found.span is not None
        assert found.span.line == 3


def test_a_solver_that_gives_up_shows_the_equation() -> None:
    text = "model E Real x(start = 1, fixed = true); equation der(x) = exp(x) - 1; end E;"
    for solver in ("rodas", "cvode", "ida"):
        with pytest.raises(SimulationProblem) as caught:
            acausal.loads(text).compile().simulate(solver=solver, compiled=False)
        found = caught.value.diagnostics[0]
        assert found.code == "simulate.step-too-small"
        assert "`der(x) = exp(x) - 1`" in found.message
        assert "escapes to infinity" in found.hint


@pytest.mark.parametrize(
    ("settings", "code"),
    [
        ({"step": 1e-300, "solver": "heun"}, "simulate.step"),
        ({"max_step": 1e-12}, "simulate.max-step"),
        ({"rtol": 1.0}, "simulate.rtol"),
        ({"rtol": 1e-20}, "simulate.rtol"),
        ({"stop_time": float("nan")}, "simulate.stop-time"),
        ({"stop_time": 1e-320}, "simulate.stop-time"),
        ({"start_time": 1e15, "stop_time": 1e15 + 1}, "simulate.stop-time"),
    ],
)
def test_what_no_run_can_have_is_refused_before_it(settings: dict[str, object], code: str) -> None:
    compiled = acausal.loads("model N Real x(start = 0, fixed = true); equation der(x) = 1; end N;").compile()
    with pytest.raises(UsageProblem) as caught:
        compiled.simulate(**settings)  # pyright: ignore[reportArgumentType]
    assert caught.value.codes == (code,)


def test_steps_that_were_asked_for_are_no_collapse() -> None:
    """More of them than a run that chooses its own may take."""
    compiled = acausal.loads("model N Real x(start = 0, fixed = true); equation der(x) = 1; end N;").compile()
    run = compiled.simulate(stop_time=1e5, max_step=1e5 / 2.0e5, interval=1e4, compiled=False)
    assert run.statistics.steps >= 2e5


def test_strings_that_change_are_refused_and_those_that_decide_are_structural() -> None:
    head = "model M Real x(start = 0, fixed = true); parameter Boolean q = true;"
    changing = f'{head} String s; equation der(x) = 1; s = if x > 0.5 then "a" else "b"; end M;'
    with pytest.raises(UnsupportedProblem, match="the String `s` would have to be computed") as caught:
        acausal.loads(changing).compile()
    assert caught.value.diagnostics[0].span is not None
    decisive = (
        f'{head} parameter String s = if q then "a" else "b"; '
        'equation der(x) = if s == "a" then 1 else 2; end M;'
    )
    compiled = acausal.loads(decisive).compile()
    assert compiled.simulate(compiled=False).values("x")[-1] == pytest.approx(1.0)
    with pytest.raises(UsageProblem, match="`q` is structural"):
        compiled.simulate(parameters={"q": False})
    other = acausal.loads(decisive).compile(q=False)
    assert other.simulate(compiled=False).values("x")[-1] == pytest.approx(2.0)
