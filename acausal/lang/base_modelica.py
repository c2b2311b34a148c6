"""A flat model as Base Modelica text (MCP-0031), which is Modelica 3.6 as well.

Names are upquoted as `name-mapping.md` says. What the MCP leaves open or would make hard to read:

- `start` and `fixed` are written as modifications, its syntactic sugar for `guess` equations;
- a final parameter keeps its declaration equation: Base Modelica has no `final`, and an initial equation
  instead would be read differently by a Modelica tool; `flow` does not exist after connections are gone;
- protected variables carry `annotation(Protected = true)`, and `input` and `output` are kept at the top only;
- enumerations, which flat types know by their literals, come first, in the order of their first use.

Numbers print exactly (`repr`), and the same model gives the same bytes.
"""

from __future__ import annotations

from collections.abc import Iterator

from acausal.lang.base_modelica_kernels import kernel_lines
from acausal.lang.base_modelica_when import assertion_text, when_lines, with_initial
from acausal.lang.flat import (
    REAL,
    Causality,
    Equation,
    Experiment,
    FlatModel,
    ScalarType,
    StateSelect,
    Variability,
    Variable,
)
from acausal.lang.triggers import without_triggers
from acausal.symbolic.expressions.expr import EnumValue, Expr, postorder
from acausal.symbolic.expressions.text import constant_text, quote_string, quoted_name, to_text

HEADER = "//! base 0.1.0"


def print_flat(flat: FlatModel) -> str:
    """The whole model as one Base Modelica text, ending in a line end."""
    flat = with_initial(without_triggers(flat))
    name = quoted_name(flat.name)
    lines = [HEADER, f"package {name}"]
    lines += [f"  {_enumeration(type_)};" for type_ in _enumerations(flat)]
    lines += [f"  {line}" for line in kernel_lines(_expressions(flat))]
    lines.append(f"  model {name}{_comment(flat.description)}")
    lines += [f"    {_declaration(variable)};" for variable in flat.variables]
    clauses = [when_lines(when) for when in flat.whens]
    lines += _section(
        "equation",
        [_equation(e) for e in flat.equations],
        [assertion_text(a.condition, a.message, a.level) for a in flat.assertions],
        ["\n    ".join(clause) for clause in clauses if clause],
    )
    lines += _section("initial equation", [_equation(e) for e in flat.initial_equations])
    lines += _experiment(flat.experiment)
    lines += [f"  end {name};", f"end {name};", ""]
    return "\n".join(lines)


def _text(value: Expr) -> str:
    return to_text(value, quoted_name)


def _comment(description: str) -> str:
    return f" {quote_string(description)}" if description else ""


# ------------------------------------------------------------------------------ types


def _enumerations(flat: FlatModel) -> Iterator[ScalarType]:
    """Enumerations of variables, and those met in expressions only, as far as their literals are used."""
    found: dict[str, ScalarType] = {}
    for variable in flat.variables:
        if variable.type.is_enumeration:
            found.setdefault(variable.type.name, variable.type)
    literals: dict[str, dict[int, str]] = {}
    for node in postorder(_expressions(flat)):
        if isinstance(node.value, EnumValue) and node.value.type_name not in found:
            literals.setdefault(node.value.type_name, {})[node.value.index] = node.value.literal
    yield from found.values()
    for name, by_index in literals.items():
        yield ScalarType(name, tuple(by_index[index] for index in sorted(by_index)))


def _expressions(flat: FlatModel) -> Iterator[Expr]:
    for v in flat.variables:
        yield from (value for value in (v.binding, v.start, v.min, v.max, v.nominal) if value is not None)
    for equation in (*flat.equations, *flat.initial_equations):
        yield equation.left
        yield equation.right
    for assertion in flat.assertions:
        yield assertion.condition
        yield assertion.message
    for when in flat.whens:
        for branch in when.branches:
            yield from branch.conditions
            yield from [equation.right for equation in branch.equations]
            yield from [reinit.value for reinit in branch.reinits]
            yield from [assertion.condition for assertion in branch.assertions]


def _enumeration(type_: ScalarType) -> str:
    name = quoted_name(type_.name)
    literals = [_literal(type_, index) for index in range(1, len(type_.literals) + 1)]
    return f"type {name} = enumeration({', '.join(literals)})"


def _literal(type_: ScalarType, index: int) -> str:
    """A literal as expressions write it behind its type's name."""
    value = EnumValue(type_.name, type_.literals[index - 1], index)
    return constant_text(value, quoted_name).removeprefix(quoted_name(type_.name) + ".")


# ------------------------------------------------------------------------------ variables


def _declaration(v: Variable) -> str:
    type_name = quoted_name(v.type.name) if v.type.is_enumeration else v.type.name
    attributes = ", ".join(f"{name} = {value}" for name, value in _attributes(v))
    parts = [*_prefixes(v), type_name, quoted_name(v.name) + (f"({attributes})" if attributes else "")]
    if v.binding is not None:
        parts.append(f"= {_text(v.binding)}")
    protected = " annotation(Protected = true)" if v.protected else ""
    return " ".join(parts) + _comment(v.description) + protected


def _prefixes(v: Variable) -> Iterator[str]:
    """Types other than Real are discrete without saying so."""
    if not v.is_unknown:
        yield v.variability.name.lower()
    elif v.variability is Variability.DISCRETE and v.type == REAL:
        yield "discrete"
    if v.causality is not Causality.LOCAL and v.top_level and not v.protected:
        yield v.causality.value


def _attributes(v: Variable) -> Iterator[tuple[str, str]]:
    for name, text in (("unit", v.unit), ("displayUnit", v.display_unit), ("quantity", v.quantity)):
        if text:
            yield name, quote_string(text)
    for name, value in (("min", v.min), ("max", v.max), ("start", v.start)):
        if value is not None:
            yield name, _text(value)
    if v.fixed is not None:
        yield "fixed", "true" if v.fixed else "false"
    if v.nominal is not None:
        yield "nominal", _text(v.nominal)
    if v.state_select is not StateSelect.DEFAULT:
        yield "stateSelect", f"StateSelect.{v.state_select.literal}"


# ------------------------------------------------------------------------------ equations


def _section(keyword: str, *groups: list[str]) -> list[str]:
    lines = [f"    {line};" for group in groups for line in group]
    return [f"  {keyword}", *lines] if lines else []


def _equation(equation: Equation) -> str:
    """The left side is a simple expression in the grammar: an `if` needs parentheses there."""
    left = _text(equation.left)
    return f"{f'({left})' if equation.left.op == 'if' else left} = {_text(equation.right)}"


def _experiment(experiment: Experiment) -> list[str]:
    settings = (
        ("StartTime", experiment.start_time),
        ("StopTime", experiment.stop_time),
        ("Tolerance", experiment.tolerance),
        ("Interval", experiment.interval),
    )
    given = ", ".join(f"{name} = {constant_text(value)}" for name, value in settings if value is not None)
    return [f"    annotation(experiment({given}));"] if given else []
