"""The C text of a plan: constant tables, and the `ac_plan` that points to them."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from acausal.export.names import literal, literals
from acausal.export.plan import Plan, ProgramPlan, SegmentPlan, place_text
from acausal.export.tunables import kind_of
from acausal.lang.flat import Assertion, Variable
from acausal.runtime.binding import METHODS
from acausal.simulate.messages import leaf_name
from acausal.simulate.settle import is_whole
from acausal.symbolic.causal import Residual
from acausal.symbolic.describe import cut, equation_text
from acausal.symbolic.expressions.expr import Expr
from acausal.symbolic.expressions.text import to_text

_WIDTH = 100


class Tables:
    """Static arrays so far; every method gives the name of one, or NULL where there is nothing in it."""

    def __init__(self) -> None:
        self.lines: list[str] = []

    def ints(self, name: str, values: Iterable[int]) -> str:
        return self._array("int", name, ", ".join(str(int(v)) for v in values))

    def texts(self, name: str, values: Sequence[str]) -> str:
        return self._array("char *const", name, literals(values))

    def rows(self, kind: str, name: str, values: Sequence[str]) -> str:
        return self._array(kind, name, ",\n    ".join(values))

    def _array(self, kind: str, name: str, values: str) -> str:
        if not values:
            return "NULL"
        self.lines.append(f"static const {kind} {name}[] = {{\n    {_wrapped(values)}}};")
        return name


def _wrapped(values: str) -> str:
    """Long lines of numbers are broken; texts have their own lines."""
    if '"' in values or len(values) <= _WIDTH:
        return values
    lines, current = [""], 0
    for value in values.split(", "):
        if current + len(value) > _WIDTH:
            lines.append("")
            current = 0
        lines[-1] += value + ", "
        current += len(value) + 2
    return "\n    ".join(line.rstrip() for line in lines).rstrip(",")


def plan_text(plan: Plan, name: str) -> str:
    """All tables, and `const ac_plan NAME_plan`."""
    tables = Tables()
    fields = [*_counts(plan), *_programs(plan, tables), *_places(plan, tables), *_texts(plan, tables)]
    fields += [*_functions(plan), *_step_matrix(plan, tables), *_settings(plan)]
    body = ",\n".join(f"    .{field} = {value}" for field, value in fields)
    constants = "\n".join(tables.lines)
    title = literal(plan.code.system.flat.name)
    return f"{constants}\n\nconst ac_plan {name}_plan = {{\n    .name = {title},\n{body}}};\n"


_Field = tuple[str, str | int]


def _counts(plan: Plan) -> Iterator[_Field]:
    code = plan.code
    system, part = code.system, code.system.discrete
    yield from (
        ("states", len(system.states)),
        ("inputs", len(system.flat.inputs)),
        ("delays", len(system.delays)),
        ("parameters", len(system.parameters)),
        ("modes", len(system.zero_crossings)),
        ("located", len(code.located)),
        ("frozen", len(part.frozen)),
        ("unknowns", len(part.unknowns)),
        ("memory", len(part.memory)),
        ("samples", len(part.samples)),
        ("phases", len(part.phases)),
        ("resets", len(part.resets)),
        ("checks", len(part.checks)),
        ("stops", len(part.stops)),
        ("assertions", len(system.assertions)),
        ("outputs", len(plan.outputs.names)),
        ("guesses", len(code.dynamic.guesses)),
        ("entries", code.pattern.nnz()),
        ("starts", len(system.initial.values)),
        ("instants", code.instants.nnz_out(0)),
        ("redundant", plan.redundant),
        ("redundant_reads", len(code.checks.reads)),
        ("tunables", len(plan.tunables)),
        ("factors", plan.factors),
        ("exact_rate", plan.exact_rate),
        ("takes_solution", int(plan.takes_solution)),
        ("past", plan.past),
        ("largest", plan.largest),
        ("widest", plan.widest),
    )
    for phase in ("initial", "terminal"):
        places = [i for i, leaf in enumerate(part.frozen) if leaf.op == phase]
        yield f"{phase}_phase", places[0] if places else -1


def _programs(plan: Plan, tables: Tables) -> Iterator[_Field]:
    for label, program in (("initial", plan.initial), ("dynamic", plan.dynamic)):
        segments = [_segment(s, f"{label}_{i}", tables) for i, s in enumerate(program.segments)]
        yield f"{label}.count", len(segments)
        yield f"{label}.slots", len(program.names)
        yield f"{label}.segment", tables.rows("ac_segment", f"{label}_segments", segments)
        yield from _program_texts(program, label, tables)


def _program_texts(program: ProgramPlan, label: str, tables: Tables) -> Iterator[_Field]:
    yield f"{label}.name", tables.texts(f"{label}_names", program.names)
    yield f"{label}.place", tables.texts(f"{label}_places", program.places)


def _segment(segment: SegmentPlan, label: str, tables: Tables) -> str:
    arrays = ("read", "write", "columns", "rows", "nominal", "guess")
    values: dict[str, Sequence[int]] = {name: getattr(segment, name) for name in arrays}
    given = {name: tables.ints(f"{label}_{name}", value) for name, value in values.items()}
    functions = {name: getattr(segment, name) or "NULL" for name in ("run", "residual", "terms")}
    counts = {"kind": segment.kind, "reads": len(segment.read), "writes": len(segment.write)}
    fields = {**counts, "tearing": segment.tearing, **given, **functions}
    return "{" + ", ".join(f".{name} = {value}" for name, value in fields.items()) + "}"


def _places(plan: Plan, tables: Tables) -> Iterator[_Field]:
    code = plan.code
    system, part = code.system, code.system.discrete
    relations = [crossing.relation for crossing in system.zero_crossings]
    states = {name: i for i, name in enumerate(system.states)}
    starts = {value.name: i for i, value in enumerate(system.initial.values)}
    free = [int(leaf in code.initial.unknowns) for leaf in plan.parameter_leaves]
    known = frozenset(part.unknowns)
    given: dict[str, Iterable[int]] = {
        "located_at": code.located,
        "above": [int(relation.op in ("gt", "ge")) for relation in relations],
        "at_zero": [int(relation.op in ("ge", "le")) for relation in relations],
        "judged": [
            int(leaf.args[0] in known or leaf.args[0].op not in ("sym", "der")) for leaf in part.memory
        ],
        "whole": [int(is_whole(crossing)) for crossing in system.zero_crossings],
        "reset_state": [states[reset.state] for reset in part.resets],
        "suggested": [_suggested(leaf, starts) for leaf in part.frozen],
        "initial_x": plan.slots(code.initial, plan.state_leaves),
        "initial_p": plan.slots(code.initial, plan.parameter_leaves),
        "initial_z": plan.slots(code.initial, code.dynamic.guesses),
        "free_p": free,
        "dynamic_xdot": plan.slots(code.dynamic, plan.rate_leaves),
        "dynamic_z": plan.slots(code.dynamic, code.dynamic.guesses),
        "redundant_read": plan.slots(code.initial, code.checks.reads),
        "parameter_needed": plan.needed_parameters,
    }
    for name, values in given.items():
        yield name, tables.ints(name, values)


def _suggested(leaf: Expr, starts: dict[str, int]) -> int:
    """Which start value a frozen value begins with; -1 is zero, -2 one."""
    if leaf.op not in ("sym", "pre"):
        return -2 if leaf.op == "initial" else -1
    base = leaf.args[0] if leaf.op == "pre" else leaf
    return starts.get(base.name, -1) if base.op == "sym" else -1


def _texts(plan: Plan, tables: Tables) -> Iterator[_Field]:
    code = plan.code
    system, part = code.system, code.system.discrete
    assigned = {a.unknown: a for a in part.assignments}
    by_name = system.flat.by_name
    texts: dict[str, Sequence[str]] = {
        "discrete_name": [leaf_name(leaf) for leaf in part.unknowns],
        "discrete_place": [place_text(assigned[leaf].equation.flat.span) for leaf in part.unknowns],
        "memory_name": [cut(to_text(leaf.args[0])) for leaf in part.memory],
        "parameter_name": system.parameters,
        "parameter_place": [place_text(by_name[name].span) for name in system.parameters],
        "redundant_text": [_check_text(check) for check in system.initial.checks],
        "delay_name": [cut(to_text(node)) for node in system.delays],
        "sample_name": [cut(to_text(leaf)) for leaf in part.samples],
    }
    for name, values in texts.items():
        yield name, tables.texts(name, values)
    variables = {
        "state": [(name, by_name[name].unit if name in by_name else "") for name in system.states],
        "variable": list(zip(plan.outputs.names, plan.outputs.units, strict=True)),
    }
    for name, pairs in variables.items():
        rows = [f"{{{literal(variable)}, {literal(unit)}, 0, 0}}" for variable, unit in pairs]
        yield name, tables.rows("ac_variable", f"{name}s", rows)
    yield "input", tables.rows("ac_variable", "inputs", [_input(v) for v in system.flat.inputs])
    yield from _notices(plan, tables)
    yield "tunable", tables.rows("ac_tunable", "tunables", list(_tunables(plan, tables)))


def _input(variable: Variable) -> str:
    name, unit = literal(variable.name), literal(variable.unit)
    return f"{{{name}, {unit}, {kind_of(variable)}, {len(variable.type.literals)}}}"


def _check_text(check: Residual) -> str:
    flat = check.equation.flat
    return f"{cut(equation_text(flat))} ({place_text(flat.span)})"


def _notices(plan: Plan, tables: Tables) -> Iterator[_Field]:
    system, part = plan.code.system, plan.code.system.discrete
    crossings = [_notice(cut(to_text(c.relation)), place_text(c.span), False) for c in system.zero_crossings]
    rows = {
        "assertion": [_asserted(assertion) for assertion in system.assertions],
        "check": [_asserted(check.assertion) for check in part.checks],
        "stop": [
            _notice(_message(stop.termination.message), place_text(stop.termination.span), False)
            for stop in part.stops
        ],
        "crossing": crossings,
    }
    for name, values in rows.items():
        yield name, tables.rows("ac_notice", f"{name}s", values)


def _asserted(assertion: Assertion) -> str:
    text = f"{_message(assertion.message)}; {cut(to_text(assertion.condition))} is false"
    return _notice(text, place_text(assertion.span), assertion.level.endswith("warning"))


def _message(message: Expr) -> str:
    """A constant text; what is put together from values stands as it is written."""
    return str(message.value) if message.is_const else to_text(message)


def _notice(text: str, place: str, warning: bool) -> str:
    return f"{{{literal(text)}, {literal(place)}, {int(warning)}}}"


def _tunables(plan: Plan, tables: Tables) -> Iterator[str]:
    for i, t in enumerate(plan.tunables):
        names = tables.texts(f"literals_{i}", t.literals)
        fields = [
            literal(t.name),
            literal(t.unit),
            t.kind,
            t.position,
            int(t.is_start),
            len(t.literals),
            names,
        ]
        yield "{" + ", ".join(map(str, fields)) + "}"


_RENAMED = {"assertions": "conditions"}


def _functions(plan: Plan) -> Iterator[_Field]:
    for field, function in plan.functions.items():
        yield _RENAMED.get(field, field), function.name()
    for field, size in zip(("sz_arg", "sz_res", "sz_iw", "sz_w"), plan.sizes(), strict=True):
        yield field, size


def _step_matrix(plan: Plan, tables: Tables) -> Iterator[_Field]:
    found = plan.elimination
    yield "w_entries", found.rows.size
    yield "capacity", plan.capacity
    arrays = {
        "columns": found.columns,
        "rows": found.rows,
        "order": found.order,
        "places": found.entries,
        "diagonal": found.diagonal,
    }
    for name, values in arrays.items():
        yield f"w_{name}", tables.ints(f"w_{name}", values.tolist())


def _settings(plan: Plan) -> Iterator[_Field]:
    options = plan.options
    yield "method", METHODS[options.solver]
    yield "locate", int(options.locate)
    for name in ("start_time", "stop_time", "interval", "step"):
        yield name, repr(float(getattr(options, name)))
