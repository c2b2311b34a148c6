"""FlatModel: scalar variables and equations only, as the front end hands it to the symbolic core.

Connections are equations, `if`-equations are `if`-expressions or decided, functions are inlined, arrays
are gone; names are the model's own (`line.cell[3].p`). `verify` proves what every later stage relies on.
`base_modelica.print_flat` shows it as Base Modelica (MCP-0031).
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from enum import Enum, IntEnum
from functools import cached_property

from acausal.errors import Diagnostic, Span
from acausal.lang.light import light_value
from acausal.symbolic.expressions.expr import Expr


class Variability(IntEnum):
    """Ordered as in Modelica 3.6, 4.5: constant < parameter < discrete < continuous."""

    CONSTANT = 0
    PARAMETER = 1
    DISCRETE = 2
    CONTINUOUS = 3


class StateSelect(IntEnum):
    """Modelica 3.6, 4.9.7.1; `literal` gives the name in source."""

    NEVER = 1
    AVOID = 2
    DEFAULT = 3
    PREFER = 4
    ALWAYS = 5

    @property
    def literal(self) -> str:
        return self.name.lower()


class Causality(Enum):
    """The prefixes `input` and `output`."""

    LOCAL = "local"
    INPUT = "input"
    OUTPUT = "output"


@dataclass(frozen=True, slots=True)
class ScalarType:
    """`Real`, `Integer`, `Boolean`, `String`, or an enumeration with its literals."""

    name: str
    literals: tuple[str, ...] = ()
    external: bool = False
    """The class of external objects: no variable of a flat model is one."""

    @property
    def is_enumeration(self) -> bool:
        return bool(self.literals)

    @property
    def is_numeric(self) -> bool:
        return self.name in ("Real", "Integer") and not self.literals

    def __str__(self) -> str:
        return self.name


REAL = ScalarType("Real")
INTEGER = ScalarType("Integer")
BOOLEAN = ScalarType("Boolean")
STRING = ScalarType("String")


@light_value
class Variable:
    """A scalar variable, parameter or constant with its attributes.

    `start`, `nominal`, `min`, `max` are expressions in parameters (None: not given). `binding` is the
    declaration's `= value` of a parameter or constant; that of any other variable is an `Equation`.
    """

    name: str
    type: ScalarType
    variability: Variability
    span: Span
    causality: Causality = Causality.LOCAL
    """Of the model's own interface only: inputs of components are determined by connections."""
    binding: Expr | None = None
    start: Expr | None = None
    fixed: bool | None = None
    nominal: Expr | None = None
    min: Expr | None = None
    max: Expr | None = None
    unit: str = ""
    display_unit: str = ""
    quantity: str = ""
    state_select: StateSelect = StateSelect.DEFAULT
    flow: bool = False
    protected: bool = False
    final: bool = False
    structural: bool = False
    """A parameter whose value shaped the model (an array size, an `if`-equation), or that is to be evaluated
    (`annotation(Evaluate = true)`): changing it re-flattens."""
    top_level: bool = False
    """Declared (or inherited) by the model itself or its own connectors, not by one of its components."""
    description: str = ""
    start_span: Span | None = None
    """The modification that gives `fixed` or `start`, where it is not in the declaration."""
    value_span: Span | None = None
    """The modification that gives a parameter its value, likewise."""

    @property
    def is_parameter(self) -> bool:
        """A parameter or constant."""
        return self.variability <= Variability.PARAMETER

    @property
    def is_unknown(self) -> bool:
        """Neither parameter nor constant: it varies with time."""
        return self.variability > Variability.PARAMETER

    @property
    def is_input(self) -> bool:
        """Known from outside as a function of time: an `input` of the model itself without a value."""
        return (
            self.causality is Causality.INPUT and self.top_level and self.variability > Variability.PARAMETER
        )

    @property
    def is_fixed(self) -> bool:
        """`fixed` with Modelica's default: true for parameters and constants, false for variables."""
        return self.fixed if self.fixed is not None else self.is_parameter


class Origin(Enum):
    """How an equation came to be, for messages."""

    EQUATION = "equation"
    BINDING = "binding"
    CONNECTION = "connection"
    FLOW_BALANCE = "flow balance"
    UNCONNECTED = "unconnected flow"
    ALGORITHM = "algorithm"


@light_value
class Equation:
    """`left = right` between scalars; `component` is the path of the one that wrote it ("" at the top)."""

    left: Expr
    right: Expr
    span: Span
    component: str = ""
    origin: Origin = Origin.EQUATION


@light_value
class Assertion:
    """`assert(condition, message, level)`; `message` is an expression of type String."""

    condition: Expr
    message: Expr
    level: str
    span: Span
    component: str = ""


@light_value
class Reinit:
    """`reinit(state, value)`: a new value of a continuous state at an event; `state` is its symbol."""

    state: Expr
    value: Expr
    span: Span
    component: str = ""


@light_value
class Termination:
    """`terminate(message)`: the end of the simulation, which is no error; `message` is of type String."""

    message: Expr
    span: Span
    component: str = ""


@light_value
class WhenBranch:
    """What happens at the events at which one of the `conditions` becomes true (Modelica 3.6, 8.3.5).

    Left sides of `equations` are symbols of discrete variables. `pre(x)` of a continuous variable, which is
    allowed here only, is its value before the event.
    """

    conditions: tuple[Expr, ...]
    equations: tuple[Equation, ...]
    reinits: tuple[Reinit, ...]
    assertions: tuple[Assertion, ...]
    terminations: tuple[Termination, ...]
    span: Span


@light_value
class When:
    """`when ... elsewhen ... end when`: the first branch that fires acts; all assign the same variables."""

    branches: tuple[WhenBranch, ...]
    span: Span
    component: str = ""

    @property
    def assigned(self) -> tuple[Expr, ...]:
        """Symbols of the variables that the clause determines, in order of appearance: an equation each."""
        return tuple(dict.fromkeys([e.left for branch in self.branches for e in branch.equations]))


@dataclass(frozen=True, slots=True)
class Experiment:
    """The `experiment` annotation; None where it says nothing (contract: 1 s, 1e-6, 1/500)."""

    start_time: float | None = None
    stop_time: float | None = None
    tolerance: float | None = None
    interval: float | None = None


@dataclass(frozen=True)
class Places:
    """Where a model declares its components, by path; empty where there was no instance tree.

    An equation of a library's component stands in the library; what a user can change is the declaration of
    the component. Connectors and records are no components here.
    """

    components: Mapping[str, Span] = field(default_factory=dict[str, Span])

    def owner(self, name: str) -> str:
        """The innermost declared component that holds a variable; "" at the top."""
        path = name.rpartition(".")[0]
        while path and path not in self.components:
            path = path.rpartition(".")[0]
        return path


@dataclass(frozen=True)
class FlatModel:
    """The whole model as scalars. Order is the declaration order of the source, depth first."""

    name: str
    description: str
    variables: tuple[Variable, ...]
    equations: tuple[Equation, ...]
    initial_equations: tuple[Equation, ...]
    assertions: tuple[Assertion, ...]
    experiment: Experiment
    span: Span
    warnings: tuple[Diagnostic, ...] = ()
    whens: tuple[When, ...] = ()
    declared_units: tuple[tuple[Expr, str], ...] = ()
    """Results of inlined functions, and the unit that their output declares; inner calls first."""
    open_inputs: frozenset[str] = frozenset()
    """Inputs of components that have no value and no connection: an equation may still determine them."""
    places: Places = field(default_factory=Places, repr=False)

    @property
    def equation_count(self) -> int:
        """How many unknowns are determined: an equation for one, a when-clause for each that it assigns."""
        return len(self.equations) + sum(len(when.assigned) for when in self.whens)

    @cached_property
    def by_name(self) -> dict[str, Variable]:
        return {variable.name: variable for variable in self.variables}

    @cached_property
    def unknowns(self) -> tuple[Variable, ...]:
        """Variables that the equations must determine: neither parameters nor constants nor inputs."""
        return tuple(v for v in self.variables if v.is_unknown and not v.is_input)

    @cached_property
    def inputs(self) -> tuple[Variable, ...]:
        """Variables that are known from outside, as functions of time."""
        return tuple(v for v in self.variables if v.is_input)

    @cached_property
    def parameters(self) -> tuple[Variable, ...]:
        """Parameters and constants."""
        return tuple(v for v in self.variables if v.is_parameter)
