"""A Jacobian at a point, with names on its rows and columns."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, cast, get_args

import numpy as np
from scipy.sparse import csc_array, diags_array, eye_array
from scipy.sparse.linalg import spsolve_triangular

from acausal.codegen.functions import Code, input_leaves, state_leaves
from acausal.codegen.jacobians import (
    By,
    Of,
    binding_slopes,
    explicit_jacobian,
    jacobian_function,
    residual_unknowns,
)
from acausal.errors import LookupProblem, UsageProblem, fail
from acausal.lang.flat import REAL
from acausal.simulate.evaluator import Evaluator
from acausal.simulate.initialize import initialize
from acausal.simulate.inputs import InputValue
from acausal.simulate.matrices import Vector
from acausal.simulate.names import did_you_mean
from acausal.simulate.overrides import Override
from acausal.symbolic.describe import equation_text
from acausal.symbolic.expressions.expr import der
from acausal.symbolic.expressions.text import to_text

if TYPE_CHECKING:
    import xarray as xr


@dataclass(frozen=True)
class Jacobian:
    """`matrix[i, j]` is d `rows[i]` / d `columns[j]`, in SI units of both.

    `colours`: how many directions were differentiated for all columns together.
    """

    rows: tuple[str, ...]
    columns: tuple[str, ...]
    matrix: csc_array
    colours: int

    def __getitem__(self, names: tuple[str, str]) -> float:
        """One entry by the names of its row and column. Raises `LookupProblem`."""
        row, column = (
            _index(known, name) for known, name in zip((self.rows, self.columns), names, strict=True)
        )
        return float(self.matrix[row, column])

    def to_xarray(self) -> xr.DataArray:
        """As a dense labelled array over `of` and `wrt`."""
        import xarray as xr  # a quarter of a second that most runs do not need

        return xr.DataArray(self.matrix.toarray(), {"of": list(self.rows), "wrt": list(self.columns)})


def _index(known: Sequence[str], name: str) -> int:
    if name not in known:
        message = f"the Jacobian has no row or column `{name}`"
        raise fail(
            LookupProblem, "jacobian.unknown-name", message, names=[name], hint=did_you_mean(name, known)
        )
    return known.index(name)


def jacobian_at(
    code: Code,
    of: str,
    wrt: str,
    *,
    time: float = 0.0,
    states: Mapping[str, float] | None = None,
    parameters: Mapping[str, Override] | None = None,
    start: Mapping[str, float] | None = None,
    inputs: Mapping[str, InputValue] | None = None,
) -> Jacobian:
    """The Jacobian at the initial point of `time`, with some of its `states` replaced.

    Raises `UsageProblem`, `LookupProblem`, and what solving the initial problem and the equations raises.
    """
    target, by = _choice(of, get_args(Of), "of"), _choice(wrt, get_args(By), "wrt")
    if by == "unknowns" and target != "residuals":
        message = f"only residuals are functions of the unknowns, `{of}` are not"
        raise fail(
            UsageProblem, "jacobian.choice", message, hint='use wrt="states", "inputs" or "parameters"'
        )
    point = initialize(code, time, parameters, start, inputs)
    evaluator, x = point.evaluator, point.x.copy()
    names = list(code.system.states)
    for name, value in (states or {}).items():
        x[_index(names, name)] = value
    evaluator.at(time, x)
    evaluator.settle()
    function = jacobian_function(code, cast("Of", target), cast("By", by))
    known = [evaluator.t, evaluator.x, evaluator.p, evaluator.m, evaluator.u, evaluator.d, evaluator.z]
    if target == "residuals":
        known.append(_unknowns(code, evaluator))
    found = function.call([np.asarray(value) for value in known])[0]
    matrix = csc_array(found.sparse())
    if not np.isfinite(matrix.data).all():
        other = explicit_jacobian(code, cast("Of", target), cast("By", by))
        matrix = (
            matrix if other is None else csc_array(other.call([np.asarray(v) for v in known])[0].sparse())
        )
    colours = int(found.sparsity().uni_coloring().size2())
    columns = _columns(code, by)
    if by == "parameters":
        matrix, columns = _through_bindings(code, evaluator, matrix, frozenset(parameters or ()))
    return Jacobian(_rows(code, target), columns, matrix, colours)


def _choice(given: str, known: Sequence[str], what: str) -> str:
    if given not in known:
        message = f"`{given}` is no choice for `{what}`"
        raise fail(UsageProblem, "jacobian.choice", message, hint=f"there are {', '.join(known)}")
    return given


def _unknowns(code: Code, evaluator: Evaluator) -> Vector:
    evaluator.output()
    values = dict(zip(code.output_leaves, evaluator.output.outputs[0].tolist(), strict=True))
    return np.array([values[leaf] for leaf in residual_unknowns(code)])


def _rows(code: Code, of: str) -> tuple[str, ...]:
    if of == "derivatives":
        return tuple(to_text(der(leaf)) for leaf in state_leaves(code.system))
    if of == "events":
        return tuple(to_text(relation) for relation in code.relations)
    if of == "outputs":
        return tuple(to_text(leaf) for leaf in code.output_leaves)
    return tuple(equation_text(equation) for equation in code.system.equations)


def _columns(code: Code, by: str) -> tuple[str, ...]:
    if by == "states":
        return code.system.states
    if by == "inputs":
        return tuple(to_text(leaf) for leaf in (*input_leaves(code.system), *code.system.delays))
    if by == "unknowns":
        return tuple(to_text(leaf) for leaf in residual_unknowns(code))
    return code.system.parameters


def _through_bindings(
    code: Code, evaluator: Evaluator, matrix: csc_array, given: frozenset[str]
) -> tuple[csc_array, tuple[str, ...]]:
    """With respect to the Real parameters that a run can change; others follow them by their bindings."""
    names, by_name = code.system.parameters, code.system.flat.by_name
    evaluated = frozenset(code.system.evaluated)
    slopes = csc_array(binding_slopes(code).call([evaluator.p])[0].sparse())
    free = np.array([name not in given and by_name[name].is_fixed for name in names], dtype=float)
    lower = eye_array(len(names), format="csr") - diags_array(free) @ slopes
    follow = spsolve_triangular(lower.tocsr(), np.eye(len(names)), lower=True, unit_diagonal=True)
    tunable = [
        i
        for i, name in enumerate(names)
        if by_name[name].type == REAL
        and name not in evaluated
        and not (by_name[name].final or by_name[name].structural)
        and by_name[name].is_fixed
        and by_name[name].is_parameter
    ]
    return csc_array(matrix @ csc_array(follow[:, tunable])), tuple(names[i] for i in tunable)
