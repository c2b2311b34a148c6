"""Names that a result is asked for: derivatives of aliases, and close matches for what does not exist."""

from __future__ import annotations

from collections.abc import Iterable
from difflib import get_close_matches

from acausal.codegen.functions import Code
from acausal.errors import Diagnostic, LookupProblem
from acausal.symbolic.causal import CausalSystem
from acausal.symbolic.expressions.text import to_text


def derivative_of_alias(system: CausalSystem, name: str) -> tuple[float, str] | None:
    """For `der(y)` of an alias `y = x` or `y = -x`: the sign, and `der(x)`; None for anything else."""
    if not (name.startswith("der(") and name.endswith(")")):
        return None
    sign, seen = 1.0, name[4:-1]
    for _ in range(len(system.aliases) + 1):
        value = system.alias_values.get(seen)
        if value is None:
            break
        if value.op == "neg":
            sign, value = -sign, value.args[0]
        if value.op != "sym":
            return None
        seen = value.name
    return (sign, f"der({seen})") if seen != name[4:-1] else None


def did_you_mean(name: str, known: Iterable[str]) -> str:
    """A hint with up to three close names; empty when nothing is close."""
    matches = get_close_matches(name, list(known), n=3, cutoff=0.5)
    return f"did you mean {' or '.join(matches)}?" if matches else ""


NAME_IT_TOO = "name it among the variables to compile for, or leave `only` out"


def left_out(name: str) -> str:
    """What is said about a variable that the chosen outputs do not need."""
    return f"`{name}` was left out: what was compiled for does not need it"


def check_names(code: Code, names: Iterable[str]) -> None:
    """Raises `LookupProblem` for a name that no result of the model will hold."""
    system = code.system
    removed = system.removed
    gone = frozenset(v.name for v in removed.variables) if removed is not None else frozenset[str]()
    known = dict.fromkeys(v.name for v in system.flat.variables if v.name not in gone)
    known |= dict.fromkeys(to_text(leaf) for leaf in code.output_leaves)
    problems = [
        Diagnostic(
            "result.unknown-name",
            left_out(name) if name in gone else f"the model {system.flat.name} has no variable `{name}`",
            names=(name,),
            hint=NAME_IT_TOO if name in gone else did_you_mean(name, known),
        )
        for name in names
        if (derivative_of_alias(system, name) or (1.0, name))[1] not in known
    ]
    if problems:
        raise LookupProblem(problems)
