"""Code: everything the run-time calls, as CasADi Functions with named inputs and outputs.

Vectors: `t` time, `x` states, `p` all parameters and constants in `CausalSystem.parameters` order, `m` modes in
`zero_crossings` order (0 or 1), `s` start values in `InitialProblem.values` order, `guess` first values of the
nonlinear blocks' tearing variables. All Functions but `parameters` and `starts` can be generated as C from here
(`casadi.CodeGenerator`); a C run-time takes the pieces in `dynamic.codes` and brings its own Newton method.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property

import casadi as ca
from casadi import SX, Function

from acausal.codegen.casadi_expressions import FORWARD, Converter, jacobian
from acausal.codegen.program import Program
from acausal.codegen.scope import Scope, column, split
from acausal.codegen.segments import reads
from acausal.codegen.stitch import Goal, Nominals, Stitching
from acausal.lang.flat import STRING
from acausal.symbolic.causal import Assignment, Block, CausalSystem
from acausal.symbolic.expressions.expr import ONE, TIME, Expr, add, der, function, make, sub, sym

_NOT_A_NUMBER = float("nan")
_FLOOR = 1e-3


@dataclass(frozen=True)
class Checks:
    """`run(u) -> (value, size)` of the initial problem's redundant equations, from the values of `reads`.

    `size` sums the terms of a linearisation, `sum_j |d value / d u_j| max(|u_j|, nominal_j)`,
    where an undeclared nominal value counts as 1e-3.
    """

    reads: tuple[Expr, ...]
    run: Function


@dataclass(frozen=True)
class Code:
    """A causalised system as compiled functions; see the module's text for the vectors."""

    system: CausalSystem
    dynamic: Program
    initial: Program
    parameters: Function
    """`(given, override) -> p`: bindings in order, except where `override` is 1: there the given value."""
    starts: Function
    """`p -> s`, the start values of the initial problem."""
    nominals: Function
    """`p -> (x, z)`: nominal values of the states and of the guesses."""
    ode: Function
    """`(t, x, p, m, guess) -> (xdot, guess_out)`."""
    jac: Function
    """`(t, x, p, m, guess) -> J`, the sparse exact d xdot / d x."""
    outputs: Function
    """`(t, x, p, m, guess) -> y`: the unknowns in `output_leaves` order."""
    events: Function
    """`(t, x, p, m, guess) -> root`: left minus right side of every zero crossing."""
    sizes: Function
    """`(t, x, p, m, guess) -> size`: sum of the absolute values of both sides, to judge what a zero is."""
    conditions: Function
    """`(t, x, p, m, guess) -> ok`: the assertions' conditions, 0 or 1."""
    checks: Checks

    @cached_property
    def output_leaves(self) -> tuple[Expr, ...]:
        """States, then every unknown of the blocks: what `outputs` returns."""
        return output_leaves(self.system)

    @cached_property
    def relations(self) -> tuple[Expr, ...]:
        return tuple(crossing.relation for crossing in self.system.zero_crossings)


def output_leaves(system: CausalSystem) -> tuple[Expr, ...]:
    """States, then the unknowns of the dynamic blocks in order, each once."""
    found = dict.fromkeys(sym(name) for name in system.states)
    for block in system.blocks:
        found.update(dict.fromkeys(block.unknowns))
    return tuple(found)


def start_leaf(name: str) -> Expr:
    """The input of the initial problem that holds the start value of `name`."""
    return make("pre", (sym(name),))


def generate(system: CausalSystem) -> Code:
    """Compile `system` to CasADi Functions. Raises `UnsupportedProblem` for what has no numeric code."""
    parameters = tuple(sym(name) for name in system.parameters)
    states = tuple(sym(name) for name in system.states)
    modes = tuple(crossing.relation for crossing in system.zero_crossings)
    starts = tuple(start_leaf(value.name) for value in system.initial.values)
    known = (("p", parameters), ("m", modes))
    dynamic = Program((("t", (TIME,)), ("x", states), *known), system.blocks, "block")
    blocks = _open_starts(system)
    initial = Program((("t", (TIME,)), *known, ("s", starts)), blocks, "initial")
    nominals = _nominals(system)
    rates = Goal("xdot", tuple(der(state) for state in states))
    stitching = Stitching(dynamic, nominals)
    ode = stitching.function("ode", [rates], guess=True)

    def compiled(name: str, goal: Goal) -> Function:
        return stitching.function(name, [goal])

    crossings = [crossing.relation.args for crossing in system.zero_crossings]
    roots = Goal("root", tuple(sub(left, right) for left, right in crossings))
    sizes = Goal("size", tuple(add(function("abs", a), function("abs", b)) for a, b in crossings))
    return Code(
        system=system,
        dynamic=dynamic,
        initial=initial,
        parameters=_parameters(system, parameters),
        starts=_of_parameters("starts", parameters, [("s", tuple(v.value for v in system.initial.values))]),
        nominals=_nominal_function(parameters, nominals, states, dynamic.guesses),
        ode=ode,
        jac=_jacobian(ode),
        outputs=compiled("outputs", Goal("y", output_leaves(system))),
        events=compiled("events", roots),
        sizes=compiled("sizes", sizes),
        conditions=compiled("conditions", Goal("ok", tuple(a.condition for a in system.assertions), True)),
        checks=_checks(initial, nominals, system),
    )


def _open_starts(system: CausalSystem) -> tuple[Block, ...]:
    """The initial blocks with `x := start` reading the start from an input, so that it can be overridden."""
    values = {value.name: value.value for value in system.initial.values}

    def open_one(assignment: Assignment) -> Assignment:
        unknown = assignment.unknown
        if unknown.op == "sym" and values.get(unknown.name) is assignment.value:
            return replace(assignment, value=start_leaf(unknown.name))
        return assignment

    return tuple(
        replace(block, assignments=tuple(open_one(a) for a in block.assignments)) if not block.tearing else block
        for block in system.initial.blocks
    )


def _parameters(system: CausalSystem, parameters: tuple[Expr, ...]) -> Function:
    """`(given, override) -> p`; not-a-number for a parameter without a value."""
    given = SX.sym("given", len(parameters))
    override = SX.sym("override", len(parameters))
    convert = Converter({}, {})
    for leaf, value, chosen in zip(parameters, split(given), split(override), strict=True):
        variable = system.flat.by_name[leaf.name]
        default = variable.binding if variable.binding is not None else variable.start
        if variable.type == STRING or default is None:
            bound = SX(_NOT_A_NUMBER)
        else:
            bound = convert(default)
        convert.leaves[leaf] = ca.if_else(chosen, value, bound)
    total = column([convert.leaves[leaf] for leaf in parameters])
    return Function("parameters", [given, override], [total], ["given", "override"], ["p"], FORWARD)


def _of_parameters(
    name: str, parameters: tuple[Expr, ...], outputs: list[tuple[str, tuple[Expr, ...]]]
) -> Function:
    """A Function of the parameters alone."""
    p = SX.sym("p", len(parameters))
    convert = Converter(dict(zip(parameters, split(p), strict=True)), {})
    values = [column([convert(root) for root in roots]) for _, roots in outputs]
    return Function(name, [p], values, ["p"], [output for output, _ in outputs], FORWARD)


def _nominals(system: CausalSystem) -> Nominals:
    """Declared nominal values; a derivative has none."""
    declared = {sym(v.name): v.nominal for v in system.flat.unknowns if v.nominal is not None}
    return Nominals(declared)


def _nominal_function(
    parameters: tuple[Expr, ...], nominals: Nominals, states: tuple[Expr, ...], guesses: tuple[Expr, ...]
) -> Function:
    def of(leaves: tuple[Expr, ...]) -> tuple[Expr, ...]:
        return tuple(function("abs", nominals.of.get(leaf, ONE)) for leaf in leaves)

    return _of_parameters("nominals", parameters, [("x", of(states)), ("z", of(guesses))])


def _jacobian(ode: Function) -> Function:
    """`J = d xdot / d x`, differentiated forward with coloured columns, over the same inputs."""
    options = {"helper_options": FORWARD}
    if ode.is_a("SXFunction"):
        symbols = ode.sx_in()
        matrix = ca.jacobian(ode.call(symbols)[0], symbols[1], options)
        return Function("jacobian", symbols, [matrix], ode.name_in(), ["J"], FORWARD)
    inputs = ode.mx_in()
    jac = ca.jacobian(ode.call(inputs, True, False)[0], inputs[1], options)
    return Function("jacobian", inputs, [jac], ode.name_in(), ["J"], FORWARD)


def _checks(initial: Program, nominals: Nominals, system: CausalSystem) -> Checks:
    roots = [check.value for check in system.initial.checks]
    known = reads(roots, initial.slots)
    sized = [nominals.of[leaf] for leaf in known if leaf in nominals.of]
    known = reads([*roots, *sized], initial.slots)
    scope = Scope([("u", known)])
    value = scope.column(roots)
    sizes = ca.fmax(ca.fabs(scope.inputs[0]), nominals.column(scope, known, _FLOOR))
    total = ca.densify(ca.mtimes(ca.fabs(jacobian(value, scope.inputs[0])), sizes))
    return Checks(known, scope.function("checks", [("value", value), ("size", total)]))
