"""The benchmarks' models are what they say, and the targets set for them hold."""

from __future__ import annotations

import pytest

import acausal
from benchmarks.models import CASES, RELATIVE_CHAIN, relative_chain
from benchmarks.networks import DOMAINS, SHAPES, network
from tests.growth import Work, growth


def equations(text: str) -> int:
    compilation = acausal.loads(text, "Net.System").run({}, stop_after="flat")
    assert compilation.flat is not None
    return len(compilation.flat.equations)


@pytest.mark.parametrize("domain", DOMAINS)
@pytest.mark.parametrize("shape", SHAPES)
def test_a_network_is_the_smallest_with_the_equations_asked_for(domain: str, shape: str) -> None:
    count = equations(network(domain, shape, 200))
    assert count >= 200
    assert equations(network(domain, shape, count)) == count


@pytest.mark.parametrize("model", CASES)
def test_the_watched_variable_of_every_model_moves(model: str) -> None:
    case = CASES[model]
    run = acausal.loads(case.text(150), case.name).compile().simulate(stop_time=1.0)
    assert run[case.watched][-1] != run[case.watched][0]


def test_every_cell_of_the_relative_chain_is_index_reduced() -> None:
    assert equations(relative_chain(800)) == 10_404
    compiled = acausal.loads(relative_chain(7), "Net.System").compile()
    expected = [f"link[{i}].{name}" for i in range(1, 8) for name in ("s_rel", "v_rel")]
    assert sorted(compiled.states) == sorted(expected)


@pytest.mark.slow
def test_the_relative_chain_takes_no_longer_for_each_cell() -> None:
    """To the end of a second simulated; `benchmarks/` states the seconds for 800 cells."""

    def prepare(cells: int) -> Work:
        model = acausal.loads(relative_chain(cells), RELATIVE_CHAIN.name)
        return lambda: model.compile().simulate(stop_time=1.0)

    assert growth(prepare, 100, 800, repeats=2) < 2


@pytest.mark.slow
@pytest.mark.parametrize("domain", DOMAINS)
def test_compile_time_per_equation_hardly_grows(domain: str) -> None:
    """From 1,000 to 20,000 here, with room for a loaded machine; `benchmarks/` goes to 100,000."""

    def prepare(equations: int) -> Work:
        model = acausal.loads(network(domain, "grid", equations), "Net.System")
        return model.compile

    assert growth(prepare, 1_000, 20_000, repeats=2) < 1.7
