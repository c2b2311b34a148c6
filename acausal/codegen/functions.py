"""Code: everything the run-time calls, as CasADi Functions with named inputs and outputs.

Vectors: `t` time, `x` states, `p` all parameters and constants in `CausalSystem.parameters` order, `m`
modes in `zero_crossings` order (0 or 1), `u` inputs in `FlatModel.inputs` order and then
`CausalSystem.delays`, `d` the frozen values in `DiscretePart.frozen` order (discrete variables, values before
the event, whole numbers), `s` start values in `InitialProblem.values` order, `z` the tearing variables of the
implicit blocks: a guess for `ode` and `jac`, which solve for them, and the solution (`z_out` of `ode` at the
same point) for everything else. `m` and `d` are constant between events.

Integrators look for sign changes only in the entries `located` of `events`, shifted by `Evaluator.shift`
(`Evaluator.crossings` gives these); the other crossings happen at known instants (`instants`), which the
event loop passes as the end of `advance`. What happens at an event is the event loop's (`simulate.run`): an
integrator stops there and is restarted with new `x`, `m` and `d`.

All Functions but `parameters`, `starts`, `given_inputs` and `nominals` can be generated as C from here
(`casadi.CodeGenerator`); a C run-time takes the pieces in `dynamic.codes` and brings its own Newton method.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import casadi as ca
from casadi import MX, Function, Sparsity

from acausal.codegen.casadi_expressions import FORWARD, jacobian
from acausal.codegen.constants import function_of_parameters, parameter_function
from acausal.codegen.discrete import DiscreteCode, discrete_code
from acausal.codegen.lazy import guarded_values
from acausal.codegen.program import ImplicitCode, Program, implicit_code
from acausal.codegen.quick import Quick, quick
from acausal.codegen.scope import Scope
from acausal.codegen.segments import Segment, reads
from acausal.codegen.solvers import Nominals
from acausal.codegen.starts import OpenStarts, open_starts, start_leaf
from acausal.codegen.stitch import Goal, Stitching
from acausal.symbolic.causal import BlockKind, CausalSystem, Residual
from acausal.symbolic.expressions.expr import (
    ONE,
    TIME,
    ZERO,
    Expr,
    add,
    der,
    function,
    postorder,
    sub,
    sym,
)
from acausal.symbolic.expressions.text import to_text

_FLOOR = 1e-3
MOST_JUDGED = 100
"""Tearing variables of a block of the initial system whose rank is looked at."""
_STARTING = frozenset({"sym", "der", "pre", "sample", "initial", "terminal"})


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
    closed_starts: frozenset[str]
    """Names in `s` whose start value depends on what the initial problem determines: not to be overridden."""
    start_roots: Function
    """`(t, p, u, s) -> root` with every variable at its start value (0 where it has none)."""
    given_inputs: Function
    """`p -> u`, the start attributes of the inputs; not-a-number where none is given."""
    nominals: Function
    """`p -> (x, z)`: nominal values of the states and of the tearing variables."""
    ode: Function
    """`(t, x, p, m, u, d, z) -> (xdot, z_out)`; `z` is a guess."""
    outputs: Function
    """`(t, x, p, m, u, d, z) -> y`: the values in `output_leaves` order."""
    events: Function
    """`(t, x, p, m, u, d, z) -> root`: left minus right side of every zero crossing."""
    sizes: Function
    """`(t, x, p, m, u, d, z) -> size`: sum of the absolute values of both sides, to judge what a zero is."""
    conditions: Function
    """`(t, x, p, m, u, d, z) -> ok`: the assertions' conditions, 0 or 1."""
    discrete: DiscreteCode
    instants: Function
    """`(p, d) -> t`: when the crossings that are not `located` happen; not finite or past where never."""
    located: tuple[int, ...]
    """The zero crossings that must be found by their roots; those of monitors are the last."""
    checks: Checks

    @cached_property
    def start_blocks(self) -> tuple[ImplicitCode, ...]:
        """The implicit blocks of the initial system that give states, to judge whether they are regular."""
        states = {sym(name) for name in self.system.states}
        blocks = [
            block
            for block in self.system.initial.blocks
            if block.kind is not BlockKind.EXPLICIT
            and len(block.tearing) <= MOST_JUDGED
            and not states.isdisjoint(block.unknowns)
        ]
        slots = self.initial.slots
        return tuple(implicit_code(Segment((b,), True), slots, f"start{i}") for i, b in enumerate(blocks))

    @cached_property
    def jac(self) -> Function:
        """`(t, x, p, m, u, d, z) -> J`, the sparse exact d xdot / d x; `z` is a guess."""
        return _jacobian(self.ode)

    @cached_property
    def quick(self) -> Quick:
        """What integrators call where it is quicker than `ode` and `jac`."""
        rates = tuple(der(state) for state in state_leaves(self.system))
        return quick(self.dynamic, rates, nominals_of(self.system))

    @cached_property
    def fitting_jac(self) -> Function:
        """`jac` with its entries in the places of `pattern`."""
        inputs = [MX.sym(name, *self.ode.size_in(i)) for i, name in enumerate(self.ode.name_in())]
        matrix = ca.project(self.jac.call(inputs)[0], self.pattern)
        return Function("fitting_jacobian", inputs, [matrix], self.ode.name_in(), ["J"], FORWARD)

    @cached_property
    def pattern(self) -> Sparsity:
        """Where d xdot / d x has entries."""
        slopes = self.quick.slopes
        return self.jac.sparsity_out(0) if slopes is None else slopes.sparsity_out(0)

    @cached_property
    def events_need_blocks(self) -> bool:
        """Whether `events` depends on what the implicit blocks determine."""
        last = self.events.n_in() - 1
        return self.events.nnz_in(last) > 0 and self.events.jac_sparsity(0, last).nnz() > 0

    @cached_property
    def delays_are_steady(self) -> bool:
        """Whether what is delayed changes at events only, and by how much it is delayed never."""
        delayed = self.discrete.delayed
        moving = {"t": (0, 1, 2), "x": (0, 1, 2), "u": (0, 1, 2), "z": (0, 1, 2), "m": (1, 2), "d": (1, 2)}
        return not any(
            delayed.jac_sparsity(output, delayed.index_in(name)).nnz()
            for name, outputs in moving.items()
            for output in outputs
        )

    @cached_property
    def output_leaves(self) -> tuple[Expr, ...]:
        """States, inputs, every unknown of the blocks, discrete variables: what `outputs` returns."""
        return output_leaves(self.system)

    @cached_property
    def output_names(self) -> tuple[str, ...]:
        """The names of `output_leaves`."""
        return tuple(to_text(leaf) for leaf in self.output_leaves)

    @cached_property
    def relations(self) -> tuple[Expr, ...]:
        return tuple(crossing.relation for crossing in self.system.zero_crossings)

    def describe(self) -> str:
        """One line per Function: its inputs and outputs with their sizes, and its number of instructions."""
        derivatives, slopes = self.quick.ode or self.ode, self.quick.slopes or self.jac
        functions = (derivatives, slopes, self.outputs, self.events, self.sizes, self.conditions)
        return "\n".join(map(_described, functions))


def _described(function: Function) -> str:
    taken = [f"{function.name_in(i)}[{function.nnz_in(i)}]" for i in range(function.n_in())]
    given = [f"{function.name_out(i)}[{function.nnz_out(i)}]" for i in range(function.n_out())]
    left, right = ", ".join(taken), ", ".join(given)
    return f"{function.name()}({left}) -> ({right}), {function.n_instructions()} instructions"


def state_leaves(system: CausalSystem) -> tuple[Expr, ...]:
    """The states as leaves, in order."""
    return tuple(sym(name) for name in system.states)


def input_leaves(system: CausalSystem) -> tuple[Expr, ...]:
    """The model's inputs as leaves, in order."""
    return tuple(sym(variable.name) for variable in system.flat.inputs)


def discrete_variables(system: CausalSystem) -> tuple[Expr, ...]:
    """The discrete variables as leaves, in the order in which they are assigned."""
    return tuple(leaf for leaf in system.discrete.unknowns if leaf.op == "sym")


def output_leaves(system: CausalSystem) -> tuple[Expr, ...]:
    """States, inputs, then the unknowns of the dynamic blocks and discrete variables in order, each once."""
    found = dict.fromkeys((*state_leaves(system), *input_leaves(system)))
    for block in system.blocks:
        found.update(dict.fromkeys(block.unknowns))
    found.update(dict.fromkeys(discrete_variables(system)))
    return tuple(found)


def nominals_of(system: CausalSystem) -> Nominals:
    """The nominal values that unknowns are declared with."""
    return Nominals({sym(v.name): v.nominal for v in system.flat.unknowns if v.nominal is not None})


def generate(system: CausalSystem) -> Code:
    """Compile `system` to CasADi Functions. Raises `UnsupportedProblem` for what has no numeric code."""
    parameters = tuple(sym(name) for name in system.parameters)
    states = state_leaves(system)
    modes = tuple(crossing.relation for crossing in system.zero_crossings)
    starts = tuple(start_leaf(value.name) for value in system.initial.values)
    inputs = (*input_leaves(system), *system.delays)
    known = (("p", parameters), ("m", modes), ("u", inputs), ("d", system.discrete.frozen))
    opened = open_starts(system)
    dynamic = Program((("t", (TIME,)), ("x", states), *known), system.blocks, "block")
    initial = Program((("t", (TIME,)), *known, ("s", starts)), opened.blocks, "initial")
    nominals = nominals_of(system)
    stitching = Stitching(dynamic, nominals)
    ode = stitching.closed("ode", [Goal("xdot", tuple(der(state) for state in states))])
    roots, sizes = _sides(system)
    values = tuple(value.value for value in system.initial.values)
    given = tuple(variable.start for variable in system.flat.inputs)
    return Code(
        system=system,
        dynamic=dynamic,
        initial=initial,
        parameters=parameter_function(system, parameters),
        starts=function_of_parameters("starts", parameters, [("s", values)]),
        closed_starts=opened.closed,
        start_roots=_start_roots(system, roots, starts),
        given_inputs=function_of_parameters("given_inputs", parameters, [("u", given)]),
        nominals=_nominal_function(parameters, nominals, states, dynamic.guesses),
        ode=ode,
        outputs=stitching.function("outputs", Goal("y", output_leaves(system))),
        events=stitching.function("events", Goal("root", roots)),
        sizes=stitching.function("sizes", Goal("size", sizes)),
        conditions=stitching.function("conditions", Goal("ok", _conditions(system), True)),
        discrete=discrete_code(system, stitching, parameters),
        instants=_instants(system, parameters),
        located=tuple(i for i, crossing in enumerate(system.zero_crossings) if crossing.instant is None),
        checks=_checks(initial, nominals, opened),
    )


def _sides(system: CausalSystem) -> tuple[tuple[Expr, ...], tuple[Expr, ...]]:
    """Of every zero crossing, left minus right side, and the sum of their absolute values (at least 1 where
    whole numbers are compared)."""
    crossings = [crossing.relation.args for crossing in system.zero_crossings]
    held = {leaf for leaf in system.discrete.unknowns if leaf.op == "integer"}
    roots = tuple(sub(left, right) for left, right in crossings)
    units = [ONE if right in held or not held.isdisjoint(right.args) else ZERO for _, right in crossings]
    sizes = [
        add(function("abs", a), function("abs", b), u) for (a, b), u in zip(crossings, units, strict=True)
    ]
    return roots, tuple(sizes)


def _conditions(system: CausalSystem) -> tuple[Expr, ...]:
    return tuple(guarded_values([assertion.condition for assertion in system.assertions]))


def _start_roots(system: CausalSystem, roots: tuple[Expr, ...], starts: tuple[Expr, ...]) -> Function:
    """The zero crossings' roots with start values put in for the variables."""
    inputs = (*input_leaves(system), *system.delays)
    parameters = tuple(sym(name) for name in system.parameters)
    scope = Scope([("t", (TIME,)), ("p", parameters), ("u", inputs), ("s", starts)])
    leaves = scope.convert.leaves
    given = {value.name: leaves[leaf] for value, leaf in zip(system.initial.values, starts, strict=True)}
    for node in postorder(roots):
        if node in leaves or node.op not in _STARTING:
            continue
        base = node if node.op == "sym" else node.args[0] if node.op == "pre" else None
        name = base.name if base is not None and base.op == "sym" else ""
        variable = system.flat.by_name.get(name)
        start = variable.start if variable is not None and variable.start is not None else ZERO
        leaves[node] = given[name] if name in given else scope.convert(start)
    return scope.function("start_roots", [("root", scope.column(roots))])


def _instants(system: CausalSystem, parameters: tuple[Expr, ...]) -> Function:
    scope = Scope([("p", parameters), ("d", system.discrete.frozen)])
    instants = [crossing.instant for crossing in system.zero_crossings if crossing.instant is not None]
    return scope.function("instants", [("t", scope.column(instants))])


def _nominal_function(
    parameters: tuple[Expr, ...], nominals: Nominals, states: tuple[Expr, ...], guesses: tuple[Expr, ...]
) -> Function:
    def of(leaves: tuple[Expr, ...]) -> tuple[Expr, ...]:
        return tuple(function("abs", nominals.of.get(leaf, ONE)) for leaf in leaves)

    return function_of_parameters("nominals", parameters, [("x", of(states)), ("z", of(guesses))])


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


def _checks(initial: Program, nominals: Nominals, opened: OpenStarts) -> Checks:
    residuals: tuple[Residual, ...] = opened.checks
    roots = [check.value for check in residuals]
    known = reads(roots, initial.slots)
    sized = [nominals.of[leaf] for leaf in known if leaf in nominals.of]
    known = reads([*roots, *sized], initial.slots)
    scope = Scope([("u", known)])
    value = scope.column(roots)
    sizes = ca.fmax(ca.fabs(scope.inputs[0]), nominals.column(scope, known, _FLOOR))
    total = ca.densify(ca.mtimes(ca.fabs(jacobian(value, scope.inputs[0])), sizes))
    return Checks(known, scope.function("checks", [("value", value), ("size", total)]))
