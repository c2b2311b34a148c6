import pytest

from acausal.symbolic.graphs.types import check_incidence, equations, transpose, variables
from tests.symbolic.graphs.samples import rows_of


def test_transpose_names_each_equation_once() -> None:
    assert transpose(rows_of([1, 0, 1], [], [1, 3]), 4) == [[0], [0, 2], [], [2]]


def test_all_indices() -> None:
    assert (equations(3), variables(2)) == ([0, 1, 2], [0, 1])


def test_variables_must_exist() -> None:
    check_incidence(rows_of([], [0, 2]), 3)
    for row in ([0, 3], [-1, 0]):
        with pytest.raises(ValueError, match=r"equation 1 names a variable outside 0\.\.2"):
            check_incidence(rows_of([0], row), 3)
