"""Which Real variables are discrete, and the rules that need to know it of the whole model (4.5, 8.3.5).

A Real variable is discrete if a when-clause determines it. Only then may it stand under `pre` outside
when-clauses; one that is declared `discrete` must be. Two when-equations cannot determine one variable, nor
set one state, and what `reinit` sets must be a state: its derivative is in the model.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace

from acausal.errors import Span
from acausal.lang.arithmetic import type_error
from acausal.lang.base_reading import is_base_modelica
from acausal.lang.flat import REAL, Equation, StateSelect, Variability, Variable, When
from acausal.lang.translation import Translation
from acausal.symbolic.expressions import expr as ex
from acausal.symbolic.expressions.expr import Expr


class DiscreteVariables:
    """What when-clauses determine and set, collected clause by clause."""

    def __init__(self) -> None:
        self._real: dict[str, Span] = {}
        self._by_equation: dict[str, Span] = {}
        self._reset: dict[str, Span] = {}

    def assign(self, names: Iterable[str], span: Span) -> None:
        """Real variables that the when-statements of an algorithm section assign."""
        for name in names:
            self._real.setdefault(name, span)

    def when(self, when: When, translation: Translation) -> None:
        """A when-equation. Raises `when.several` and `reinit.several`."""
        for symbol in when.assigned:
            name = symbol.name
            if name in self._by_equation:
                message = f"two when-equations determine `{name}`; the other is at {self._by_equation[name]}"
                hint = "join them with `elsewhen`, which says who comes first"
                raise type_error("when.several", message, when.span, hint, (name,))
            self._by_equation[name] = when.span
            leaf = translation.leaf(name)
            if leaf is not None and leaf.type == REAL:
                self._real.setdefault(name, when.span)
        for reinit in dict.fromkeys([r.state.name for b in when.branches for r in b.reinits]):
            if reinit in self._reset:
                message = f"two when-equations set `{reinit}`; the other is at {self._reset[reinit]}"
                hint = "join them with `elsewhen`"
                raise type_error("reinit.several", message, when.span, hint, (reinit,))
            self._reset[reinit] = when.span

    def check_left_limits(self, used: Mapping[str, Span], variables: Sequence[Variable]) -> None:
        """Raise `type.pre` for continuous variables under `pre` outside when-clauses."""
        declared = frozenset(
            v.name
            for v in variables
            if v.variability is Variability.DISCRETE and is_base_modelica(v.span.source)
        )
        for name, span in used.items():
            if name not in self._real and name not in declared:
                message = f"pre needs a discrete variable, but `{name}` is continuous"
                hint = "use it in a when-clause, where every variable has a left limit"
                raise type_error("type.pre", message, span, hint, (name,))

    def check_states(self, equations: Sequence[Equation]) -> None:
        """Raise `reinit.state` for a variable that cannot be a state: none equal to it is differentiated."""
        if not self._reset:
            return
        differentiated = _differentiated(equations)
        for name, span in self._reset.items():
            if name in self._real:
                message = f"`{name}` is discrete, and `reinit` needs a continuous state"
                raise type_error("reinit.state", message, span, "", (name,))
            if not any(other in differentiated for other in _equal_to(name, equations)):
                message = f"`reinit` needs a state, but the derivative of `{name}` is not in the model"
                raise type_error("reinit.state", message, span, "", (name,))

    def check_declared(self, variables: Sequence[Variable], equations: Sequence[Equation]) -> None:
        """Raise `type.discrete-unassigned` for a Real declared `discrete` that no when-clause determines.

        Base Modelica that we write has equations with edges for what several when-statements assign.
        """
        for variable in variables:
            if variable.variability is not Variability.DISCRETE or variable.type != REAL:
                continue
            if is_base_modelica(variable.span.source):
                continue
            equal = _equal_to(variable.name, equations) if variable.name not in self._real else {}
            name = variable.name
            if equal and not variable.is_input and not any(other in self._real for other in equal):
                message = f"`{name}` is declared discrete, but no when-clause determines it"
                hint = "leave `discrete` out: a Real may be constant between events without it"
                raise type_error("type.discrete-unassigned", message, variable.span, hint, (name,))

    def mark(self, variable: Variable) -> Variable:
        """The variable as it is in the flat model."""
        if variable.name in self._real and variable.variability is Variability.CONTINUOUS:
            return replace(variable, variability=Variability.DISCRETE)
        if variable.name in self._reset:
            return replace(variable, state_select=StateSelect.ALWAYS)
        return variable


def _differentiated(equations: Sequence[Equation]) -> dict[str, None]:
    """Variables in the argument of `der`."""
    roots = [side for e in equations for side in (e.left, e.right)]
    return dict.fromkeys(
        [name for node in ex.postorder(roots) if node.op == "der" for name in ex.symbols(node.args)]
    )


def _equal_to(name: str, equations: Sequence[Equation]) -> dict[str, None]:
    """The variable and those that equations `a = b` and `a = -b` make equal to it."""
    neighbours: dict[str, list[str]] = {}
    for equation in equations:
        a, b = _bare(equation.left), _bare(equation.right)
        if a.op == b.op == "sym":
            neighbours.setdefault(a.name, []).append(b.name)
            neighbours.setdefault(b.name, []).append(a.name)
    found = {name: None}
    pending = [name]
    while pending:
        for other in neighbours.get(pending.pop(), ()):
            if other not in found:
                found[other] = None
                pending.append(other)
    return found


def _bare(side: Expr) -> Expr:
    return side.args[0] if side.op == "neg" else side
