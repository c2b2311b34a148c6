from collections.abc import Callable, Sequence

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from acausal.symbolic.graphs.dummy_derivatives import (
    BadChoice,
    Choose,
    Selection,
    constraint_sets,
    select_dummies,
)
from acausal.symbolic.graphs.matching import Matcher, maximum_matching
from acausal.symbolic.graphs.pantelides import Reduction
from acausal.symbolic.graphs.types import Eq, Var
from tests.symbolic.graphs.systems import (
    HIDDEN,
    INTEGRATORS,
    LINEAR,
    PENDULUM,
    REACTOR,
    System,
    all_names,
    cells,
    random_signature,
    system,
)


def structural_choice(reduction: Reduction, preference: Callable[[Var], int]) -> Choose:
    """A `choose` without numbers: the candidates of least `preference` that can be matched structurally.

    Greedy in the transversal matroid (Edmonds and Fulkerson, "Transversals and matroid partition", 1965).
    """

    def choose(equations: Sequence[Eq], candidates: Sequence[Var]) -> Sequence[Var]:
        columns = [
            [Var(i) for i, eq in enumerate(equations) if var in reduction.incidence[eq]] for var in candidates
        ]
        matcher = Matcher(columns, len(equations))
        order = sorted(range(len(candidates)), key=lambda i: (preference(candidates[i]), i))
        return [candidates[i] for i in order if not matcher.augment([Eq(i)])]

    return choose


def named(sample: System, reduction: Reduction, selection: Selection) -> tuple[set[str], set[str]]:
    names = all_names(sample, reduction)
    return {names[var] for var in selection.dummies}, {names[var] for var in selection.states}


def first_names(sample: System, reduction: Reduction, *preferred: str) -> Selection:
    """Select preferring the derivatives of the named quantities as dummies."""
    names = all_names(sample, reduction)
    return select_dummies(
        reduction, structural_choice(reduction, lambda var: names[var].rstrip("'") not in preferred)
    )


@pytest.mark.parametrize(
    ("sample", "preferred", "dummies", "states"),
    [
        (PENDULUM, "x", {"x'", "x''"}, {"y", "y'"}),
        (PENDULUM, "y", {"y'", "y''"}, {"x", "x'"}),
        (HIDDEN, "x", {"x'"}, {"y"}),
        (HIDDEN, "y", {"y'"}, {"x"}),
        (REACTOR, "", {"C'", "C''", "R'", "T'"}, set[str]()),
        (INTEGRATORS, "", {"x'", "x''", "y'"}, set[str]()),
    ],
)
def test_examples_of_the_papers(sample: System, preferred: str, dummies: set[str], states: set[str]) -> None:
    reduction = sample.reduce()
    assert named(sample, reduction, first_names(sample, reduction, preferred)) == (dummies, states)


def test_linear_example_with_numeric_pivoting() -> None:
    """Mattsson and Soederlind 1993: with its numbers x1 and x2 exclude each other on every level."""
    reduction = LINEAR.reduce()
    names = all_names(LINEAR, reduction)
    coefficients = {"x1": (1, 1, 0, 2), "x2": (1, 1, 0, 1), "x3": (0, 1, 1, 1), "x4": (0, 0, 1, 1)}
    original = {Eq(i): i for i in range(4)}
    for eq, derived in enumerate(reduction.equation_derivative):
        if derived is not None:
            original[derived] = original[Eq(eq)]
    asked: list[tuple[list[int], list[str]]] = []

    def choose(equations: Sequence[Eq], candidates: Sequence[Var]) -> Sequence[Var]:
        asked.append(([original[eq] for eq in equations], [names[var] for var in candidates]))
        chosen: list[Var] = []
        for var in candidates:
            columns = [coefficients[names[v].rstrip("'")] for v in (*chosen, var)]
            jacobian = np.array(columns, dtype=float).T[[original[eq] for eq in equations]]
            if np.linalg.matrix_rank(jacobian) == len(columns):
                chosen.append(var)
        return chosen

    found = named(LINEAR, reduction, select_dummies(reduction, choose))
    assert found == ({"x1'", "x1''", "x3'", "x3''", "x4'"}, {"x2", "x2'"})
    assert [(sorted(eqs), variables) for eqs, variables in asked] == [
        ([0, 1, 2], ["x4'", "x1''", "x2''", "x3''"]),
        ([0, 1], ["x1'", "x3'"]),
    ]


def test_choose_sees_one_constraint_set_and_one_level() -> None:
    sample = system(
        [
            *({"x": [2], "T": [0]}, {"y": [2], "T": [0]}, {"x": [0], "y": [0]}),
            *({"u": [2], "S": [0]}, {"v": [2], "S": [0]}, {"u": [0], "v": [0], "x": [0]}),
            *({"p": [0]}, {"p": [1], "q": [0]}),
        ]
    )
    reduction = sample.reduce()
    names = all_names(sample, reduction)
    asked: list[list[str]] = []

    def choose(equations: Sequence[Eq], candidates: Sequence[Var]) -> Sequence[Var]:
        asked.append([names[var] for var in candidates])
        return candidates[: len(equations)]

    select_dummies(reduction, choose)
    assert asked == [["p'"], ["x''", "y''", "u''", "v''"], ["x'", "y'"]]


@given(st.integers(1, 12), st.floats(0.1, 2), st.integers(0, 3), st.integers(0, 10**6))
@settings(max_examples=300, deadline=None)
def test_selected_system_is_solvable_and_counts_agree(n: int, extra: float, order: int, seed: int) -> None:
    sample = system(random_signature(n, extra, order, seed))
    reduction = sample.reduce()
    selection = select_dummies(reduction, structural_choice(reduction, lambda var: (var * 31 + seed) % 7))
    dummies, states = set(selection.dummies), set(selection.states)
    assert len(dummies) == sum(reduction.differentiations)
    derivatives = {var for var in reduction.derivative_of if var is not None}
    assert dummies <= derivatives
    assert len(states) == len(derivatives) - len(dummies)
    assert not states & dummies
    unknowns = [[var for var in row if var not in states] for row in reduction.incidence]
    assert reduction.n_vars - len(states) == len(unknowns)
    assert maximum_matching(unknowns, reduction.n_vars).size == len(unknowns)


@given(st.integers(1, 12), st.floats(0.1, 2), st.integers(0, 10**6))
@settings(max_examples=100, deadline=None)
def test_dummies_of_a_constraint_set_stay_in_it(n: int, extra: float, seed: int) -> None:
    reduction = system(random_signature(n, extra, 2, seed)).reduce()
    set_of = {
        var: at
        for at, equations in enumerate(constraint_sets(reduction))
        for eq in equations
        for var in reduction.incidence[eq]
        if reduction.derivative_of[var] is None
    }
    differentiated = {eq for eq in reduction.equation_derivative if eq is not None}

    def choose(equations: Sequence[Eq], candidates: Sequence[Var]) -> Sequence[Var]:
        assert set(equations) <= differentiated
        assert len(candidates) >= len(equations)
        assert len({set_of[var] for var in candidates if var in set_of}) <= 1
        return structural_choice(reduction, lambda var: -var)(equations, candidates)

    assert len(select_dummies(reduction, choose).dummies) == sum(reduction.differentiations)


@pytest.mark.parametrize("answer", ["none", "many", "twice", "foreign", "singular"])
def test_bad_choice_is_refused(answer: str) -> None:
    sample = system([{"x": [0], "y": [0]}, {"y": [0], "z": [0]}, {"x": [1], "y": [1], "z": [1]}])
    if answer == "singular":
        sample = system(
            [
                {"x": [0], "y": [0], "z": [0], "w": [0]},
                {"z": [0], "w": [0]},
                {"x": [1], "y": [1], "z": [1]},
                {"x": [1], "w": [1], "y": [1]},
            ]
        )
    reduction = sample.reduce()
    names = all_names(sample, reduction)
    picks = {
        "none": [],
        "many": ["x'", "y'", "z'"],
        "twice": ["x'", "x'"],
        "foreign": ["x'", "y"],
        "singular": ["x'", "y'"],
    }[answer]

    def choose(equations: Sequence[Eq], candidates: Sequence[Var]) -> Sequence[Var]:
        assert len(equations) == 2
        return [Var(names.index(name)) for name in picks]

    with pytest.raises(BadChoice) as caught:
        select_dummies(reduction, choose)
    assert [names[var] for var in caught.value.chosen] == picks
    assert len(caught.value.equations) == 2 < len(caught.value.candidates)


def test_nothing_to_select_in_an_explicit_system() -> None:
    sample = system([{"x": [1], "y": [0]}, {"y": [1], "x": [0]}])

    def choose(_equations: Sequence[Eq], _candidates: Sequence[Var]) -> Sequence[Var]:
        raise AssertionError("nobody was differentiated")

    assert select_dummies(sample.reduce(), choose) == Selection((), (Var(0), Var(1)))


def test_prescribed_cells_have_no_states() -> None:
    reduction = cells(50, linked=True).reduce()
    selection = select_dummies(reduction, structural_choice(reduction, lambda _: 0))
    assert (len(selection.dummies), selection.states) == (150, ())
