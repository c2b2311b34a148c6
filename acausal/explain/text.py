"""An explanation as text: one section for each stage, in the order in which things happened."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from acausal.explain.collect import unconnected
from acausal.explain.explanation import Explanation
from acausal.explain.folding import folded
from acausal.explain.words import (
    by_whom,
    conditions_text,
    counted,
    cut,
    kind_of,
    often,
    short,
    surplus_text,
    unknown_texts,
    use,
    when_not,
    where,
)
from acausal.lang.flat import Equation, Origin
from acausal.symbolic.causal import BlockKind, InitialProblem
from acausal.symbolic.describe import equation_text, leaf_texts, place
from acausal.symbolic.expressions.text import to_text

MOST_ROWS, MOST_NAMES, MOST_TEXT = 20, 12, 160


def explanation_text(explanation: Explanation, *, everything: bool = False) -> str:
    """All sections. Lists end after `MOST_ROWS` rows unless `everything` is asked for."""
    rows = None if everything else MOST_ROWS
    sections = (
        ("Flat model", _flat(explanation), None),
        ("Left out", _left_out(explanation), None),
        ("Evaluated", _evaluated(explanation, everything), None),
        _section("Aliases", "variable", _aliases(explanation), rows),
        _section("Index reduction", "equation", _differentiated(explanation), rows, _index(explanation)),
        _section("States", "state", _states(explanation), rows, _freedom(explanation)),
        _section("Not states", "variable", _not_states(explanation), rows),
        ("States chosen anew while the model runs", _dynamic(explanation), None),
        ("Blocks", _block_counts(explanation), None),
        _section("Loops", "loop", _loops(explanation, everything), rows),
        ("Initial problem", _initial_counts(explanation), None),
        _section("Start values", "start", _starts(explanation), rows),
        _section("Zero crossings", "crossing", _crossings(explanation), rows),
        _section("At events", "discrete value", _discrete(explanation), rows),
        ("Warnings", [warning.render() for warning in explanation.warnings], None),
        ("Seconds", [", ".join(f"{k} {v:.3f}" for k, v in explanation.seconds.items())], None),
    )
    return "\n".join([_title(explanation), *[line for section in sections for line in _printed(*section)]])


def _title(explanation: Explanation) -> str:
    description = explanation.system.flat.description
    return f"{explanation.name}: {description}" if description else explanation.name


def _section(
    title: str, what: str, lines: Sequence[str], most: int | None, head: Sequence[str] = ()
) -> tuple[str, Sequence[str], str | None]:
    """A title that counts, the first lines, and how many are left out."""
    more = None
    counted_title = f"{title}: {counted(len(lines), what)}" if lines or head else title
    if most is not None:
        lines = folded(lines)
        more = None if len(lines) <= most else f"and {len(lines) - most} more; --all shows them"
    return counted_title, [*head, *lines[: most if most is not None else len(lines)]], more


def _printed(title: str, lines: Sequence[str], more: str | None) -> Iterator[str]:
    if lines:
        yield ""
        yield title
        for line in lines:
            yield from ("  " + part for part in line.split("\n"))
        if more:
            yield f"  {more}"


def _flat(explanation: Explanation) -> list[str]:
    flat, loose = explanation.system.flat, unconnected(explanation.system)
    kinds = [(origin, sum(e.origin is origin for e in flat.equations)) for origin in Origin]
    origins = ", ".join(f"{count} {origin.value}" for origin, count in kinds if count)
    parameters = counted(len(flat.parameters), "parameter or constant", "parameters and constants")
    equations = counted(explanation.system.equation_count, "equation")
    size = f"{equations} in {counted(explanation.system.unknown_count, 'unknown')}"
    return [
        f"{size}, {parameters}, {counted(len(flat.inputs), 'input')}",
        *([f"where the equations come from: {origins}"] if origins else []),
        *([f"not connected, so that no flow passes: {cut(folded(loose), MOST_NAMES)}"] if loose else []),
    ]


def _left_out(explanation: Explanation) -> list[str]:
    removed = explanation.system.removed
    if removed is None:
        return []
    gone = f"{counted(removed.equation_count, 'equation')} and {counted(len(removed.variables), 'variable')}"
    verb = "needs" if len(removed.outputs) == 1 else "need"
    checks = counted(len(removed.assertions), "assertion")
    initial = counted(len(removed.initial_equations), "initial equation")
    names = cut([v.name for v in removed.variables], MOST_NAMES)
    needless = f"{cut(removed.outputs, MOST_NAMES)} {verb} nothing of them"
    return [f"{gone}, {initial} and {checks}, because {needless}: {names}"]


def _evaluated(explanation: Explanation, everything: bool) -> list[str]:
    names = explanation.system.evaluated
    text = "constants, final and structural parameters whose values stand in the equations"
    return [f"{text}: {', '.join(names) if everything else cut(folded(names), MOST_NAMES)}"] if names else []


def _aliases(explanation: Explanation) -> list[str]:
    return [
        f"{alias.name} = {short(to_text(alias.value), MOST_TEXT)}  by {_flat_text(alias.equation)}"
        for alias in explanation.system.aliases
    ]


def _flat_text(equation: Equation) -> str:
    return f"`{short(equation_text(equation), MOST_TEXT)}` ({where(equation)})"


def _index(explanation: Explanation) -> list[str]:
    index = explanation.system.index
    meaning = {0: "explicit differential equations", 1: "with algebraic parts, nothing to differentiate"}
    more = f"{counted(index - 1, 'level')} of differentiation"
    return [f"index {index}: {meaning.get(index, more)}"]


def _differentiated(explanation: Explanation) -> list[str]:
    return [
        f"{_flat_text(entry.equation)} {often(entry.times)}, {by_whom(entry)}"
        for entry in explanation.differentiated
    ]


def _freedom(explanation: Explanation) -> list[str]:
    return [] if explanation.system.states else ["none: everything follows from time and parameters"]


def _states(explanation: Explanation) -> list[str]:
    reasons = {choice.name: choice.reason for choice in explanation.system.choices}
    return [f"{name}  {reasons.get(name, '')}".rstrip() for name in explanation.system.states]


def _not_states(explanation: Explanation) -> list[str]:
    return [f"{choice.name}  {choice.reason}" for choice in explanation.system.choices if not choice.is_state]


def _dynamic(explanation: Explanation) -> list[str]:
    dynamic = explanation.system.dynamic
    lines: list[str] = []
    for monitor in dynamic.monitors if dynamic is not None else ():
        relation, change, constraints = when_not(monitor)
        lines.append(f"while {short(relation, MOST_TEXT)}; then {change}\n  by {constraints}")
    return lines


def _block_counts(explanation: Explanation) -> list[str]:
    blocks = explanation.system.blocks
    if not blocks:
        return []
    kinds = ", ".join(f"{explanation.count(kind)} {kind.value}" for kind in BlockKind)
    largest = max(blocks, key=lambda block: block.size)
    return [f"{counted(len(blocks), 'block')} solved in order: {kinds}; the largest has size {largest.size}"]


def _loops(explanation: Explanation, everything: bool) -> list[str]:
    most = None if everything else MOST_NAMES
    return [
        f"block {number}: {kind_of(block)}: {cut(leaf_texts(block.tearing), most)}"
        + (f"\n  then {cut(unknown_texts(block)[len(block.tearing) :], most)}" if block.assignments else "")
        for number, block in explanation.loops
    ]


def _initial_counts(explanation: Explanation) -> list[str]:
    initial = explanation.system.initial
    kinds = ", ".join(f"{sum(b.kind is kind for b in initial.blocks)} {kind.value}" for kind in BlockKind)
    return [
        f"{counted(len(initial.blocks), 'block')}: {kinds}",
        conditions_text(explanation.system),
        *[surplus_text(conflict) for conflict in initial.conflicts][:MOST_ROWS],
        *(
            [f"start values not used, because the rest determines these: {_unused(initial)}"]
            if initial.unused
            else []
        ),
        *[f"may continue from the simplified side of {_flat_text(e)}" for e in explanation.homotopies][
            :MOST_ROWS
        ],
    ]


def initial_text(explanation: Explanation) -> str:
    """The title and the section on the initial problem."""
    return "\n".join([_title(explanation), *_printed("Initial problem", _initial_counts(explanation), None)])


def _unused(initial: InitialProblem) -> str:
    return cut(folded(initial.unused), MOST_NAMES)


def _starts(explanation: Explanation) -> list[str]:
    return [
        f"{value.name} = {short(to_text(value.value), MOST_TEXT)}  {use(value, explanation.system)}"
        for value in explanation.system.initial.values
    ]


def _discrete(explanation: Explanation) -> list[str]:
    return [
        f"{to_text(a.unknown)} := {short(to_text(a.value), MOST_TEXT)}  ({place(a.equation.flat.span)})"
        for a in explanation.system.discrete.assignments
    ]


def _crossings(explanation: Explanation) -> list[str]:
    return [
        f"{short(to_text(crossing.relation), MOST_TEXT)}  ({place(crossing.span)})"
        for crossing in explanation.system.events
    ]
