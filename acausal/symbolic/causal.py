"""CausalSystem: states chosen, blocks ordered, loops torn, events separated, initial problem separate.

An *unknown* is an expression leaf: a symbol `x`, its derivative `der(x)`, or a higher one `der(der(x))`.
A *dummy derivative* is such a `der(x)` that is solved for like any algebraic variable. Evaluating the
dynamic system at (time, states, parameters, modes) means running `blocks` in order; each gives the values
of its unknowns, and at the end every unknown and every `der(state)` is known.

A *mode* is the Boolean value of one zero crossing's relation. It is an input to the equations: constant
between events, updated at events, so that the equations stay smooth while the solver steps. So are the
*frozen* values of the discrete part: discrete variables, their values before the event (`pre(v)`), and the
whole numbers that `integer` holds between events.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum
from functools import cached_property
from typing import TYPE_CHECKING

from acausal.errors import Span
from acausal.lang.flat import Assertion, Equation, FlatModel, Termination
from acausal.symbolic.expressions.expr import Expr

if TYPE_CHECKING:
    from acausal.symbolic.index_reduction import Reduced
    from acausal.symbolic.outputs import Removed


@dataclass(frozen=True, slots=True)
class Alias:
    """An eliminated variable: `name = value`, where `value` is another unknown's symbol, its negation,
    or an expression in constants, parameters only."""

    name: str
    value: Expr
    equation: Equation
    """The equation that says so."""


@dataclass(frozen=True, slots=True)
class CausalEquation:
    """An equation after alias elimination; `differentiations` times differentiated from a flat equation."""

    left: Expr
    right: Expr
    flat: Equation
    differentiations: int = 0


@dataclass(frozen=True, slots=True)
class Assignment:
    """`unknown := value`, solved from one equation."""

    unknown: Expr
    value: Expr
    equation: CausalEquation


@dataclass(frozen=True, slots=True)
class Residual:
    """`value` must be zero; what is left of a torn block."""

    value: Expr
    equation: CausalEquation


class BlockKind(Enum):
    """How a block is solved."""

    EXPLICIT = "explicit"
    LINEAR = "linear"
    NONLINEAR = "nonlinear"


@dataclass(frozen=True, slots=True)
class Block:
    """One strong component, torn: guess `tearing`, run `assignments` in order, drive `residuals` to zero.

    Explicit blocks have one assignment and no tearing. Linear blocks are linear in their tearing
    variables for any value of everything known before the block.
    """

    kind: BlockKind
    assignments: tuple[Assignment, ...]
    tearing: tuple[Expr, ...] = ()
    residuals: tuple[Residual, ...] = ()

    @property
    def unknowns(self) -> tuple[Expr, ...]:
        return self.tearing + tuple(a.unknown for a in self.assignments)

    @property
    def size(self) -> int:
        """Number of scalar equations before tearing."""
        return len(self.assignments) + len(self.tearing)


@dataclass(frozen=True, slots=True)
class ZeroCrossing:
    """An event: `relation`, one of `< <= > >=` between Reals outside noEvent and smooth, changes value."""

    relation: Expr
    equation: CausalEquation | None
    """The first equation that holds it (None: an assertion)."""
    span: Span
    instant: Expr | None = None
    """The time at which it changes, from parameters and frozen values; None if it must be located."""


@dataclass(frozen=True, slots=True)
class Reset:
    """`reinit`: where `condition` holds at an event, the state takes the new value."""

    condition: Expr
    state: str
    value: Expr
    span: Span


@dataclass(frozen=True, slots=True)
class Check:
    """An assertion inside a when-clause: it must hold at the events at which `condition` does."""

    condition: Expr
    assertion: Assertion


@dataclass(frozen=True, slots=True)
class Stop:
    """`terminate`: where `condition` holds at an event, the run ends."""

    condition: Expr
    termination: Termination


@dataclass(frozen=True)
class DiscretePart:
    """What changes at events only, apart from modes.

    `assignments` give, in order, every discrete variable and every `integer(...)` that generates events, from
    the modes, the continuous unknowns, the values before the event and each other; where some form a loop,
    they use what was found last. An event is settled by evaluating the continuous blocks, the modes and
    these, until nothing changes; then `memory` takes new values, and all is evaluated once more until that
    does not change either (Modelica 3.6, appendix B).
    """

    assignments: tuple[Assignment, ...] = ()
    memory: tuple[Expr, ...] = ()
    """`pre(e)` for every `e` whose value before the event is used: variables and when-conditions."""
    samples: tuple[Expr, ...] = ()
    """`sample(start, interval)`: 1 at its instants, else 0."""
    phases: tuple[Expr, ...] = ()
    """Those of `initial()` and `terminal()` that occur."""
    resets: tuple[Reset, ...] = ()
    checks: tuple[Check, ...] = ()
    stops: tuple[Stop, ...] = ()
    initial: tuple[Assignment, ...] = ()
    """The same at the start, where `pre(v)` of every discrete variable in use is unknown too."""

    @cached_property
    def unknowns(self) -> tuple[Expr, ...]:
        """What `assignments` determine."""
        return tuple(assignment.unknown for assignment in self.assignments)

    @property
    def equations(self) -> tuple[CausalEquation, ...]:
        """The equations of the discrete variables."""
        return tuple(a.equation for a in self.assignments if a.unknown.op == "sym")

    @cached_property
    def frozen(self) -> tuple[Expr, ...]:
        """Everything that is constant between events, apart from modes, in the order of the vector `d`."""
        return self.unknowns + self.memory + self.samples + self.phases


@dataclass(frozen=True, slots=True)
class InitialValue:
    """One start value in the initial problem: `name = start`."""

    name: str
    value: Expr
    reason: str
    """`fixed`, `assumed` (not fixed, but used as an initial equation) or `guess` (iteration start)."""


@dataclass(frozen=True, slots=True)
class InitialCondition:
    """What the model says about the start only: an initial equation, or `x = start` of a variable `start`."""

    equation: CausalEquation
    start: str = ""


@dataclass(frozen=True, slots=True)
class InitialConflict:
    """`condition` is one too many beside `others`: without any one of them all there would be room for it."""

    condition: InitialCondition
    others: tuple[InitialCondition, ...]
    equations: tuple[CausalEquation, ...] = ()
    """The first of the model's equations through which they compete."""


@dataclass(frozen=True, slots=True)
class InitialProblem:
    """Gives the states, all other unknowns and parameters with `fixed = false` at the start time.

    `blocks` are evaluated in order like the dynamic ones, knowing only time and parameters. `checks` are
    equations (redundant with the rest) that must hold to tolerance at the result. `values` is the report:
    which starts were used and how.
    """

    blocks: tuple[Block, ...]
    values: tuple[InitialValue, ...]
    checks: tuple[Residual, ...] = ()
    needed: int = 0
    """How many conditions the start needs beside the equations: its degrees of freedom."""
    equations: int = 0
    """How many of them are initial equations; the others are start values."""
    conflicts: tuple[InitialConflict, ...] = ()
    """For each of the first of `checks` what it competes with."""
    unused: tuple[str, ...] = ()
    """Unknowns with a start value of their own that is used nowhere, because they follow from the rest."""


@dataclass(frozen=True, slots=True)
class StateChoice:
    """Why a variable is a state or a dummy derivative, for the explanation."""

    name: str
    is_state: bool
    reason: str


@dataclass(frozen=True, slots=True)
class StateMonitor:
    """A choice of states that is good only near the present point: it holds while `relation` is true.

    `constraints` are solved for the variables `solved_for`; any of `alternatives` might do instead.
    `threshold` is the quality (see `monitors`) at which the relation becomes false.
    """

    relation: Expr
    threshold: float
    constraints: tuple[CausalEquation, ...]
    solved_for: tuple[str, ...]
    alternatives: tuple[str, ...]


@dataclass(frozen=True, eq=False)
class DynamicStates:
    """No choice of states is valid everywhere: what to watch, and what a new choice is made from.

    When the mode of one of `monitors` becomes false, `reselect` gives the system with other states, whose
    equations, unknowns and parameters are the same.
    """

    monitors: tuple[StateMonitor, ...]
    """Their relations are the last of `CausalSystem.zero_crossings`, in this order, and in no equation."""
    reduced: Reduced


@dataclass(frozen=True)
class CausalSystem:
    """The causalised model; see the module's text for how it is evaluated."""

    flat: FlatModel
    parameters: tuple[str, ...]
    """Parameters and constants in an order in which each binding uses earlier ones only."""
    aliases: tuple[Alias, ...]
    equations: tuple[CausalEquation, ...]
    """All after alias elimination and index reduction, differentiated ones included."""
    states: tuple[str, ...]
    dummy_derivatives: tuple[Expr, ...]
    index: int
    """contract.md: 0 explicit ODE, 1 with algebraic parts, +1 per level of differentiation."""
    blocks: tuple[Block, ...]
    zero_crossings: tuple[ZeroCrossing, ...]
    assertions: tuple[Assertion, ...]
    initial: InitialProblem
    choices: tuple[StateChoice, ...] = ()
    dynamic: DynamicStates | None = None
    """None where one choice of states is valid everywhere."""
    discrete: DiscretePart = DiscretePart()
    delays: tuple[Expr, ...] = ()
    """Every `delay(...)` in use: known at any time from the past of the run."""
    evaluated: tuple[str, ...] = ()
    """Parameters and constants whose values were put into the equations (see `parameters`)."""
    homotopy: FlatModel | None = None
    """The model as it came, if it holds the operator `homotopy`: what a continuation starts from."""
    removed: Removed | None = None
    """What was left out of `flat` because the chosen outputs do not need it; None where none were chosen."""

    @property
    def equation_count(self) -> int:
        """Scalar equations of the flat model, with what was left out."""
        return self.flat.equation_count + (self.removed.equation_count if self.removed is not None else 0)

    @property
    def unknown_count(self) -> int:
        """Unknowns of the flat model, with what was left out."""
        return len(self.flat.unknowns) + (len(self.removed.variables) if self.removed is not None else 0)

    @property
    def events(self) -> tuple[ZeroCrossing, ...]:
        """The model's own zero crossings, without those that watch the choice of states."""
        watched = len(self.dynamic.monitors) if self.dynamic is not None else 0
        return self.zero_crossings[: len(self.zero_crossings) - watched]

    @cached_property
    def alias_values(self) -> dict[str, Expr]:
        return {alias.name: alias.value for alias in self.aliases}
