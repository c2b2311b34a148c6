"""C text of a model's functions for one translation unit of its own: nothing of it is seen from outside.

The text is that of `c_text`, with which runs inside Python are compiled, so that both compute the same to the
bit. What is only for CasADi's own loader is left out, and parameters that a function does not need are named
as such, so that the text compiles without warnings.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Collection, Iterator, Mapping

from casadi import Function

from acausal.codegen.c_text import c_text

_EXPORTED = "CASADI_SYMBOL_EXPORT "
_WRAPPER = re.compile(r"^CASADI_SYMBOL_EXPORT (int \w+\(const casadi_real\*\* arg, .*int mem\)\{)$")
_HEAD = re.compile(
    r"^((?:static )?int \w+\(const casadi_real\*\* arg, casadi_real\*\* res, casadi_int\* iw, "
    r"casadi_real\* w, int mem\) ?\{)"
)
_TABLE = re.compile(r"\bcasadi_s\d+\b")
_MENTIONS = 2
"""The macro and the definition of a table: used nowhere, since the loader's functions are gone."""
_PLAIN = (
    (re.compile(r"\( ?! ?(\w+) ?\)"), r"(\1==0)"),
    (re.compile(r"\( ?(\w+) ?\?"), r"(\1!=0?"),
    (re.compile(r"\( ?(\w+) ?(&&|\|\|) ?(\w+) ?\)"), r"(\1!=0\2\3!=0)"),
    (re.compile(r"= casadi_low\("), "= (casadi_real) casadi_low("),
    (re.compile(r"\*\(ng-1\)/"), "*(casadi_real) (ng-1)/"),
)
"""Numbers as conditions are compared with zero, which means the same, also for what is not a number; whole
numbers become others in so many words."""
_PREFIX = re.compile(r"(#define CASADI_PREFIX\(ID\) )model_\w+ ## ID")
_UNUSED = " (void)arg; (void)res; (void)iw; (void)w; (void)mem;"


def unit_text(functions: Mapping[str, Function], prefix: str) -> str:
    """The functions as static ones under their own names, `int f(arg, res, iw, w, mem)`.

    What CasADi adds begins with `prefix`, so that several units can be linked together.
    """
    text = _PREFIX.sub(rf"\g<1>{prefix}_ ## ID", c_text(functions))
    lines = list(_lines(text.splitlines()))
    used = Counter(name for line in lines for name in _TABLE.findall(line))
    unused = frozenset(name for name, count in used.items() if count <= _MENTIONS)
    return "\n".join(_without_unused(lines, unused)) + "\n"


def _without_unused(lines: list[str], names: Collection[str]) -> Iterator[str]:
    """Leaves out the definitions of these tables, which may go over several lines, and their macros."""
    skipping = False
    for line in lines:
        found = _TABLE.search(line)
        if found is not None and found[0] in names:
            skipping = line.startswith("static") and not line.endswith("};")
        elif skipping:
            skipping = not line.endswith("};")
        else:
            yield line


def _lines(lines: list[str]) -> Iterator[str]:
    skipping = False
    for line in lines:
        if skipping:
            skipping = line != "}"
            continue
        if line.startswith(_EXPORTED):
            found = _WRAPPER.match(line)
            if found is None:
                skipping = not line.endswith("}")
                continue
            yield f"static {found[1]}{_UNUSED}"
        else:
            for pattern, plain in _PLAIN:
                line = pattern.sub(plain, line)  # noqa: PLW2901
            yield _HEAD.sub(lambda m: m[1] + _UNUSED, line)
