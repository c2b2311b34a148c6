"""What the C run-time is told about a model: the constant `ac_plan` of acausal_host.h, in Python."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property

from casadi import Function

from acausal.codegen.c_text import run_functions
from acausal.codegen.casadi_expressions import FORWARD
from acausal.codegen.functions import Code, state_leaves
from acausal.codegen.program import ImplicitCode, Program, SegmentCode
from acausal.errors import Span
from acausal.export.outputs import Outputs
from acausal.export.tunables import Tunable
from acausal.lang.flat import STRING
from acausal.simulate.elimination import Elimination, eliminate
from acausal.simulate.messages import leaf_name
from acausal.simulate.options import Options
from acausal.symbolic.causal import BlockKind
from acausal.symbolic.expressions.expr import Expr, der, sym

MOST_PAST = 4096
"""Samples of the past; a run that needs more of them says so."""
NUMBERS_PER_BLOCK = 10
"""`n (10 n + 17)` numbers of scratch for a block of n unknowns (acausal_host: walk.c)."""


@dataclass(frozen=True)
class SegmentPlan:
    """One `ac_segment`: its kind, slots, and the names of its functions."""

    kind: int
    read: tuple[int, ...]
    write: tuple[int, ...]
    tearing: int
    run: str
    residual: str
    terms: str
    columns: tuple[int, ...]
    rows: tuple[int, ...]
    nominal: tuple[int, ...]
    guess: tuple[int, ...]


@dataclass(frozen=True)
class ProgramPlan:
    """One `ac_program`."""

    segments: tuple[SegmentPlan, ...]
    names: tuple[str, ...]
    places: tuple[str, ...]
    functions: Mapping[str, Function]


@dataclass(frozen=True)
class Plan:
    """A system with the settings of an export; what is derived from both is computed when it is asked for."""

    code: Code
    outputs: Outputs
    tunables: tuple[Tunable, ...]
    options: Options

    @cached_property
    def functions(self) -> dict[str, Function]:
        """All functions by the fields of `ac_plan`; those without results are left out."""
        code = self.code
        found = dict(run_functions(code))
        found["output"] = self.outputs.run
        if code.quick.ode is not None:
            found["robust"] = _renamed(code.ode, "robust")
        if code.quick.factors is not None:
            found["factors_of"] = code.quick.factors
        discrete = code.discrete
        found |= {
            "update": discrete.update,
            "memory_of": discrete.memory,
            "actions": discrete.actions,
            "delayed": discrete.delayed,
            "start_discrete": discrete.start,
            "parameters_of": code.parameters,
            "starts_of": code.starts,
            "nominals_of": code.nominals,
            "inputs_of": code.given_inputs,
            "schedule": discrete.schedule,
            "instants_of": code.instants,
            "start_roots": code.start_roots,
            "redundancy": code.checks.run,
        }
        return {name: f for name, f in found.items() if any(f.nnz_out(i) for i in range(f.n_out()))}

    @property
    def takes_solution(self) -> bool:
        """Whether the Jacobian takes the blocks as solved, and gives the rates too."""
        return self.code.quick.slopes is not None

    @property
    def factors(self) -> int:
        """Numbers that are computed once the parameters are known (`codegen.factors`)."""
        return 0 if self.code.quick.factors is None else self.code.quick.factors.nnz_out(0)

    @property
    def exact_rate(self) -> int:
        """Which function gives the derivative by time: 0 none (it is zero), 1 its own, 2 the Jacobian's."""
        slopes = self.code.quick.slopes
        if slopes is not None:
            return 2 if slopes.nnz_out(1) else 0
        return int("derivative" in self.functions)

    @cached_property
    def initial(self) -> ProgramPlan:
        starts = {value.name: i for i, value in enumerate(self.code.system.initial.values)}
        return self._program(self.code.initial, starts)

    @cached_property
    def dynamic(self) -> ProgramPlan:
        guesses = {leaf_name(leaf): i for i, leaf in enumerate(self.code.dynamic.guesses)}
        return self._program(self.code.dynamic, guesses)

    def _program(self, program: Program, guesses: Mapping[str, int]) -> ProgramPlan:
        functions: dict[str, Function] = {}
        segments = tuple([self._segment(code, program, guesses, functions) for code in program.codes])
        slots = program.slots
        places = {leaf: place_text(span) for leaf, span in _places(program)}
        return ProgramPlan(
            segments,
            tuple(map(leaf_name, slots)),
            tuple(places.get(leaf, "") for leaf in slots),
            functions,
        )

    def _segment(
        self,
        code: SegmentCode,
        program: Program,
        guesses: Mapping[str, int],
        functions: dict[str, Function],
    ) -> SegmentPlan:
        slots = program.slots
        read, write = (tuple(slots[leaf] for leaf in leaves) for leaves in (code.reads, code.writes))
        if not isinstance(code, ImplicitCode):
            return SegmentPlan(0, read, write, 0, _kept(functions, code.run), "", "", (), (), (), ())
        tearing = code.block.tearing
        is_linear = code.block.kind is BlockKind.LINEAR
        pattern = code.residual.sparsity_out(1)
        return SegmentPlan(
            1 if is_linear else 2,
            read,
            write,
            len(tearing),
            _kept(functions, code.rest),
            _kept(functions, code.residual),
            _kept(functions, _renamed(code.terms, f"{code.rest.name()}_terms")) if is_linear else "",
            tuple(pattern.colind()),
            tuple(pattern.row()),
            tuple(self._nominal_slots.get(leaf, -1) for leaf in tearing),
            tuple(guesses.get(leaf_name(leaf), -1) for leaf in tearing),
        )

    @cached_property
    def _nominal_slots(self) -> dict[Expr, int]:
        leaves = (*state_leaves(self.code.system), *self.code.dynamic.guesses)
        return {leaf: i for i, leaf in enumerate(leaves)}

    @cached_property
    def elimination(self) -> Elimination:
        """The pattern of a step's matrix and the order of its columns, fixed here."""
        return eliminate(self.code.pattern, len(self.code.system.states))

    @property
    def capacity(self) -> int:
        """Entries of L, and of U, whatever the pivots are."""
        size = len(self.code.system.states)
        return size * (size + 1) // 2 + size

    @property
    def past(self) -> int:
        """Samples of delayed expressions that a run keeps at most."""
        return MOST_PAST if self.code.system.delays else 0

    @property
    def segments(self) -> tuple[SegmentPlan, ...]:
        return (*self.initial.segments, *self.dynamic.segments)

    @property
    def largest(self) -> int:
        """Tearing variables of the largest block."""
        return max((segment.tearing for segment in self.segments), default=0)

    @property
    def widest(self) -> int:
        """Numbers that any function reads or writes at most, of those that are gathered."""
        part = self.code.discrete.actions
        widths = [max(len(s.read), len(s.write)) for s in self.segments]
        return max([*widths, len(self.code.checks.reads), self.redundant * 2, part.nnz_out(0), 1])

    @property
    def redundant(self) -> int:
        return len(self.code.system.initial.checks)

    @property
    def everything(self) -> dict[str, Function]:
        """All functions, by the names under which their C is."""
        found = [*self.functions.values(), *self.initial.functions.values(), *self.dynamic.functions.values()]
        named = {function.name(): function for function in found}
        assert len(named) == len(found), "two functions of one name"
        return named

    def sizes(self) -> tuple[int, int, int, int]:
        """Pointers and scratch that the functions need at most: arguments, results, integers, numbers."""
        functions = list(self.everything.values())
        return (
            max([8, *(f.sz_arg() for f in functions)]),
            max([3, *(f.sz_res() for f in functions)]),
            max([0, *(f.sz_iw() for f in functions)]) + 1,
            max([0, *(f.sz_w() for f in functions)]) + 1,
        )

    def slots(self, program: Program, leaves: Iterable[Expr]) -> tuple[int, ...]:
        """Where the leaves' values are, -1 where they are not."""
        return tuple(program.slots.get(leaf, -1) for leaf in leaves)

    @property
    def state_leaves(self) -> tuple[Expr, ...]:
        return state_leaves(self.code.system)

    @property
    def rate_leaves(self) -> tuple[Expr, ...]:
        return tuple(der(leaf) for leaf in self.state_leaves)

    @property
    def needed_parameters(self) -> tuple[int, ...]:
        """1 for every parameter that must be a finite number before the start is solved."""
        flat, free = self.code.system.flat, frozenset(self.code.initial.unknowns)
        return tuple(
            int(flat.by_name[leaf.name].type != STRING and leaf not in free) for leaf in self.parameter_leaves
        )

    @property
    def parameter_leaves(self) -> tuple[Expr, ...]:
        return tuple(sym(name) for name in self.code.system.parameters)


def _renamed(function: Function, name: str) -> Function:
    """The same under a name that no other function has."""
    if function.is_a("SXFunction"):
        symbols = function.sx_in()
        values = function.call(symbols, True, False)
        return Function(name, symbols, values, function.name_in(), function.name_out(), FORWARD)
    inputs = function.mx_in()
    outputs = function.call(inputs, True, False)
    return Function(name, inputs, outputs, function.name_in(), function.name_out(), FORWARD)


def _kept(functions: dict[str, Function], function: Function) -> str:
    """The name of a function that has results; it is noted."""
    if not any(function.nnz_out(i) for i in range(function.n_out())):
        return ""
    functions[function.name()] = function
    return function.name()


def _places(program: Program) -> Iterable[tuple[Expr, Span]]:
    """Which equation determines which unknown; residuals of a torn block stand for its tearing variables."""
    for block in program.blocks:
        for assignment in block.assignments:
            yield assignment.unknown, assignment.equation.flat.span
        for leaf, residual in zip(block.tearing, block.residuals, strict=False):
            yield leaf, residual.equation.flat.span


def place_text(span: Span) -> str:
    """`Tank.mo:12`, the same wherever the file is."""
    return f"{span.file.replace(chr(92), '/').rsplit('/', 1)[-1]}:{span.line}"


def numbers_of(plan: Plan) -> int:
    """The numbers that attach.c hands out, without those of the integrator and its factors."""
    code = plan.code
    system = code.system
    states, modes, frozen = len(system.states), len(system.zero_crossings), len(system.discrete.frozen)
    guesses, parameters, located = len(code.dynamic.guesses), len(system.parameters), len(code.located)
    inputs, starts = len(system.flat.inputs) + len(system.delays), len(system.initial.values)
    slots = max(len(code.initial.slots), len(code.dynamic.slots), 2 * modes)
    outputs, samples = len(plan.outputs.names), len(system.discrete.samples)
    asserted, fired = len(system.assertions), len(system.discrete.checks) + len(system.discrete.stops)
    vectors: Sequence[int] = [
        *[parameters] * 3, inputs, modes, frozen, *[starts] * 3, states + guesses, plan.factors, slots,
        *[plan.widest] * 2, plan.largest * (NUMBERS_PER_BLOCK * plan.largest + 17), *[states] * 3, modes,
        states, modes, modes, frozen, modes, frozen, modes, frozen, modes, frozen,
        *[frozen] * 3, 2 * modes, modes, frozen, guesses, *[located] * 3, 2 * states + guesses,
        *[modes] * 2, outputs, fired, *[samples] * 3, len(system.zero_crossings) - located,
        plan.past, plan.past * 5 * len(system.delays), 6 * len(system.delays), states if system.delays else 0,
    ]  # fmt: skip
    model = 1 + 3 * states + 2 * guesses + code.pattern.nnz() + 2 * modes + outputs + asserted
    return sum(vectors) + len(vectors) + model + plan.sizes()[3]


def ints_of(plan: Plan) -> int:
    """The same for whole numbers."""
    system = plan.code.system
    notices = len(system.assertions) + len(system.discrete.checks)
    return plan.largest + 5 * len(system.zero_crossings) + notices
