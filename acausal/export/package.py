"""The files of an export: one folder that compiles by itself.

NAME.h, NAME.c   the model: indices, tables, functions; `NAME_instance` is all memory that a run needs
main.c, csv.*    the program for the command line; a shared library or an FMU would stand in its place
runtime/         the fixed C run-time that runs inside Python use too; its events are those of settle.c
Makefile, README.md
"""

from __future__ import annotations

from functools import cache
from pathlib import Path

from acausal.codegen.c_unit import unit_text
from acausal.export.names import comment, identifier, identifiers
from acausal.export.outputs import unit_of
from acausal.export.plan import Plan, ints_of, numbers_of
from acausal.export.readme import readme
from acausal.export.support import no_c
from acausal.export.tables import plan_text
from acausal.runtime import build

_UNITS = ("attach", "delay", "dense", "newton", "point", "run", "schedule", "settle", "start", "walk")
_HOST = ("acausal_host.h", *(f"{unit}.c" for unit in _UNITS))
_PROGRAM = ("csv.h", "csv.c", "main.c")

_INSIDE_PYTHON = ("cruise.c", "cruise.h", "event.c", "event.h", "iterate.c", "judge.c")
"""Files of the run-time that exports do without."""

_TAKEN = frozenset(
    "main csv clean makefile readme runtime assert complex ctype errno fenv float inttypes iso646 "
    "limits locale math setjmp signal stdarg stdbool stddef stdint stdio stdlib string tgmath time "
    "wchar wctype auto break case char const continue default do double else enum extern for goto if "
    "inline int long register restrict return short signed sizeof static struct switch typedef union "
    "unsigned void volatile while".split()
)
"""Names of files that C or the package has, and C's own words."""


@cache
def _host_file(name: str) -> str:
    return (Path(__file__).parent / "host" / name).read_text(encoding="utf-8")


def files(plan: Plan, name: str) -> dict[str, str]:
    """Texts by their paths in the package. Raises `UnsupportedProblem` where there is no C for a function."""
    found = {f"{name}.h": header(plan, name), f"{name}.c": model(plan, name)}
    for program in _PROGRAM:
        found[program] = _host_file(program).replace("MODEL", name)
    for file, text in build.run_time_sources().files.items():
        if file not in _INSIDE_PYTHON:
            found[f"runtime/{file}"] = text
    for file in _HOST:
        found[f"runtime/{file}"] = _host_file(file)
    found["Makefile"] = makefile(name, found)
    found["README.md"] = readme(plan, name)
    return found


def makefile(name: str, found: dict[str, str]) -> str:
    """Compiles every C file by the rules of `make`; the flags keep products and sums apart, as in Python."""
    objects = [file.removesuffix(".c") + ".o" for file in found if file.endswith(".c")]
    headers = [file for file in found if file.endswith(".h")]
    return (
        "CC ?= cc\n"
        "CFLAGS ?= -O2\n"
        "STRICT = -std=c99 -Wall -Wextra -Wconversion -Werror "
        "-ffp-contract=off -fno-math-errno -fno-trapping-math\n"
        f"OBJECTS = {' '.join(objects)}\n\n"
        f"{name}: $(OBJECTS)\n\t$(CC) $(CFLAGS) -o $@ $(OBJECTS) -lm\n\n"
        f"$(OBJECTS): {' '.join(headers)}\n\n"
        ".c.o:\n\t$(CC) $(STRICT) $(CFLAGS) -I. -Iruntime -c $< -o $@\n\n"
        f"clean:\n\trm -f {name} $(OBJECTS)\n"
    )


def model(plan: Plan, name: str) -> str:
    """The model's functions, its tables, and what ties them to memory."""
    try:
        functions = unit_text(plan.everything, f"{name}_casadi")
    except RuntimeError as problem:
        raise no_c(problem, plan.code) from None
    return (
        f"/* {comment(plan.code.system.flat.name)}: made by acausal export; see README.md. */\n"
        f'#include <stddef.h>\n\n#include "{name}.h"\n\n'
        f"{functions}\n{plan_text(plan, name)}\n{_create(name)}"
    )


def _create(name: str) -> str:
    return f"""int {name}_create({name}_instance *instance)
{{
    int size[5];
    ac_memory(&{name}_plan, size);
    if (size[0] > {name}_MEMORY_NUMBERS || size[1] > {name}_MEMORY_INTS || size[2] > {name}_MEMORY_LONGS ||
        size[3] > {name}_MEMORY_ARGUMENTS || size[4] > {name}_MEMORY_RESULTS) {{
        return AC_MEMORY;
    }}
    ac_attach(&instance->run, &{name}_plan, instance->numbers, instance->ints, instance->longs,
              instance->arguments, instance->results, instance->inputs);
    return 0;
}}
"""


def header(plan: Plan, name: str) -> str:
    """Counts, indices by name, memory, and the model itself."""
    system = plan.code.system
    flat = system.flat
    groups = {
        "STATE": [(state, unit_of(plan.code, state)) for state in system.states],
        "INPUT": [(variable.name, variable.unit) for variable in flat.inputs],
        "OUTPUT": list(zip(plan.outputs.names, plan.outputs.units, strict=True)),
        "TUNABLE": [(t.name, t.unit) for t in plan.tunables],
    }
    parts = [f"enum {{ {', '.join(f'{name}_{g}S = {len(v)}' for g, v in groups.items())} }};"]
    parts += [_indices(name, group, variables) for group, variables in groups.items() if variables]
    guard = f"ACAUSAL_{name.upper()}_H"
    body = "\n\n".join([*parts, _memory(plan, name)])
    return (
        f"/* {comment(flat.name)}: made by acausal export; see README.md. Units are in brackets. */\n"
        f'#ifndef {guard}\n#define {guard}\n\n#include "acausal_host.h"\n\n{body}\n\n#endif\n'
    )


def _indices(name: str, group: str, variables: list[tuple[str, str]]) -> str:
    found = identifiers(variable for variable, _ in variables)
    lines = [
        f"    {name}_{group}_{index} = {i}, /* {comment(variable)} [{comment(unit)}] */"
        for i, (index, (variable, unit)) in enumerate(zip(found, variables, strict=True))
    ]
    return "enum {\n" + "\n".join(lines) + "\n};"


def _memory(plan: Plan, name: str) -> str:
    system = plan.code.system
    states, modes = len(system.states), len(system.zero_crossings)
    tearing = len(plan.code.dynamic.guesses)
    entries, capacity = plan.elimination.rows.size, plan.capacity
    arguments, results, integers, _ = plan.sizes()
    sizes = {
        "NUMBERS": f"{numbers_of(plan)} + "
        f"AC_DOUBLES({states}, {modes}, {tearing}, {plan.code.pattern.nnz()}) + "
        f"AC_LU_DOUBLES({states}, {entries}, {capacity})",
        "INTS": f"{ints_of(plan)} + {modes} + AC_LU_INTS({states}, {capacity}) + 1",
        "LONGS": f"{integers + states}",
        "ARGUMENTS": f"{8 * arguments}",
        "RESULTS": f"{8 * results}",
    }
    counts = ",\n".join(f"    {name}_MEMORY_{key} = {value}" for key, value in sizes.items())
    return f"""enum {{
{counts}
}};

/* All memory that a run needs; it may be static. */
typedef struct {{
    ac_run run;
    double numbers[{name}_MEMORY_NUMBERS];
    int ints[{name}_MEMORY_INTS];
    ac_long longs[{name}_MEMORY_LONGS];
    const double *arguments[{name}_MEMORY_ARGUMENTS];
    double *results[{name}_MEMORY_RESULTS];
    ac_series inputs[{len(system.flat.inputs) + 1}];
}} {name}_instance;

extern const ac_plan {name}_plan;
/* Ties an instance to its memory; parameters and inputs have their defaults. 0, or AC_MEMORY. */
int {name}_create({name}_instance *instance);"""


def package_name(model_name: str) -> str:
    """A C identifier from a model's full name, which is no name of a file that C or the package has."""
    name = identifier(model_name)
    return f"m_{name}" if not name[0].isalpha() or name.lower() in _TAKEN else name
