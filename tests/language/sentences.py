"""Texts made from a grammar of the language: valid and nearly valid models that no person would write.

A rule's alternatives are strings; words in capitals are rules, all else is text. Choices prefer the first
alternative (which ends) the deeper they are. Names come from a small pool, so that they often exist.
"""

from __future__ import annotations

import re

from tests.language.mutations import Choices

_RULES: dict[str, tuple[str, ...]] = {
    "FILE": (
        "FRAME equation EQUATION; end Test; end T;",
        "FRAME TYPE z = EXPR; end Test; end T;",
        "FRAME PREFIX TYPE z(MODS) = EXPR; TYPE y[SIZE]; equation EQUATION; EQUATION; end Test; end T;",
        "FRAME CLASS; equation EQUATION; end Test; end T;",
        "FRAME CLASS; TYPE z(MODS); algorithm STATEMENT; STATEMENT; end Test; end T;",
        "FRAME extends A(MODS); REAL z = EXPR; end Test; end T;",
        "FRAME redeclare CLASS; extends M(MODS); end Test; end T;",
        "FRAME CLAUSE; CLAUSE; initial equation EQUATION; equation EQUATION; end Test; end T;",
        "FRAME function g extends f; end g; REAL z = g(EXPR); end Test; end T;",
        "FRAME function g FUNCTION end g; TYPE z = g(EXPR); TYPE y = g(NUMBER); end Test; end T;",
        "FRAME A d(MODS); C k; equation connect(CREF, CREF); connect(CREF, CREF); end Test; end T;",
        "package T BODY model Test BODY equation EQUATIONS end Test; end T;",
    ),
    "FRAME": (
        ("package T record R Real a; Real b = 2; end R; type E = enumeration(a, b, c);"
        " connector C Real a; flow Real b; end C; function f input Real a; input Real b = 1; output Real c;"
        " output Real x; algorithm c := a + b; x := a; end f; model A parameter Real n = 1; Real x; C c;"
        " replaceable model M = B; M m; equation x = n*time; c.a = x; end A; model B Real x = 1; end B;"
        " package M constant Integer n = 2; model A = B; end M;"
        " model Test Real a = time; Real b[3] = {1, 2, 3}; parameter Integer n = 3; R r; A c; C k; "
        "Boolean t = a > 1;"),
    ),
    "BODY": ("CLAUSES", "CLASS; CLAUSES", "CLAUSES CLAUSES", "extends NAME; CLAUSES",
             "import NAME.*; CLAUSES",
             "CLASS; CLASS; extends NAME(MODS); CLAUSES", "protected CLAUSES public CLAUSES"),
    "CLAUSES": ("CLAUSE;", "CLAUSE; CLAUSE;", "CLAUSE; CLAUSES"),
    "CLAUSE": ("REAL NEW", "PREFIX TYPE NEW", "PREFIX REAL NEW = EXPR", "TYPE NEW[SIZE](MODS)",
               "REAL[SIZE] NEW = EXPR", "PREFIX TYPE NEW(MODS) if EXPR",
             "TYPE z(each MODS), y(MODS) = EXPR",
               "replaceable TYPE z constrainedby TYPE", "redeclare TYPE NAME(MODS)"),
    "NEW": ("z", "y", "w", "v"),
    "PREFIX": ("", "parameter", "constant", "input", "output", "flow", "final parameter", "inner", "outer",
               "discrete", "stream", "inner outer", "replaceable"),
    "REAL": ("Real", "parameter Real", "Integer", "constant Real"),
    "TYPE": ("Real", "Integer", "Boolean", "String", "A", "R", "C", "E", "M", "M.A", "T.A", "B"),
    "NAME": ("a", "b", "c", "k", "n", "r", "t", "c.x", "r.a", "z", "y", "A", "R", "C", "M", "f", "x"),
    "SIZE": ("2", "n", ":", "EXPR", "E", "2, 3", "size(b, 1)", "0", "Boolean", "n, n"),
    "MODS": ("start = 1", "NAME = EXPR", "NAME(MODS)", "start = EXPR, fixed = true", "redeclare TYPE NAME",
             "each NAME = EXPR", "final n = EXPR", "redeclare model M = TYPE(MODS)", 'unit = "m"',
             "min = EXPR, max = EXPR", "x = EXPR, n = EXPR", "NAME = break", "x(start = EXPR)"),
    "CLASS": ("model D CLAUSES SECTIONS end D", "record D REAL z; REAL y; end D",
             "connector D CLAUSES end D",
              "type D = enumeration(a, b, c)", "type D = Real(MODS)", "package D BODY end D",
              "function g FUNCTION end g", "model D = B(MODS)", "replaceable model D = A",
              "partial model D CLAUSES end D", "model D BODY end D",
             "block D extends B(MODS); SECTIONS end D",
              "operator record D CLAUSES end D", "expandable connector D end D", "connector D = input Real",
              "model A CLAUSES end A", "function D = f(a = EXPR)", "function D = der(f, a)",
             "model extends M end M"),
    "FUNCTION": ("input Real a; output Real b; algorithm b := EXPR;",
                 "input Real a[:]; output Real b[size(a, 1)]; protected CLAUSES algorithm STATEMENTS",
                 "input TYPE a; input TYPE b = EXPR; output TYPE c; output TYPE n; algorithm STATEMENTS",
                 "extends f; algorithm STATEMENTS", 'input Real a; output Real b; external "C" b = h(a);'),
    "SECTIONS": ("equation EQUATIONS", "equation EQUATIONS initial equation EQUATIONS",
                 "algorithm STATEMENTS", "equation EQUATIONS algorithm STATEMENTS", ""),
    "EQUATIONS": ("EQUATION;", "EQUATION; EQUATION;", "EQUATION; EQUATIONS"),
    "EQUATION": ("REF = EXPR", "EXPR = EXPR", "der(REF) = EXPR", "connect(CREF, CREF)",
             'assert(EXPR, "no")',
                 "if EXPR then EQUATION; else EQUATION; end if", "for i in EXPR loop EQUATION; end for",
                 "when EXPR then EQUATION; end when", "reinit(REF, EXPR)", "(REF, REF) = f(EXPR)",
             "f(EXPR)",
                 "when {EXPR, EXPR} then EQUATIONS elsewhen EXPR then EQUATIONS end when",
             'terminate("end")'),
    "STATEMENTS": ("STATEMENT;", "STATEMENT; STATEMENT;", "STATEMENT; STATEMENTS"),
    "STATEMENT": ("REF := EXPR", "if EXPR then STATEMENT; else STATEMENT; end if",
                  "for i in EXPR loop STATEMENT; end for", "while EXPR loop STATEMENT; end while",
                  "(REF, REF) := f(EXPR)", "return", "break", "when EXPR then STATEMENT; end when"),
    "CREF": ("k", "c.c", "d.c", "CREF[EXPR]", "NAME"),
    "REF": ("NAME", "NAME.NAME", "b[EXPR]", "NAME[EXPR].NAME", "b[:]", "b[end]", ".T.NAME",
             "NAME[EXPR, EXPR]"),
    "NUMBER": ("1", "time", "2.5", "n", "a", "0", "-1", "1e300", "9223372036854775807", "b[1]", "c.x"),
    "EXPR": ("NUMBER", "b", "t", "REF", "true", '"text"', "(EXPR + EXPR)", "(EXPR * EXPR)", "(EXPR / EXPR)",
             "(NUMBER ^ NUMBER)", "(-EXPR)", "(not EXPR)", "(EXPR and EXPR)", "(NUMBER < NUMBER)",
             "(EXPR == EXPR)",
             "(if EXPR then EXPR else EXPR)", "{EXPR, EXPR}", "[EXPR, EXPR; EXPR, EXPR]",
             "{EXPR for i in EXPR}",
             "(EXPR:EXPR)", "(1:2:NUMBER)", "BUILTIN(EXPR)", "BUILTIN(EXPR, EXPR)",
             "BUILTIN(EXPR for i in EXPR)",
             "f(EXPR)", "f(a = EXPR)", "R(EXPR, EXPR)", "E.a", "(EXPR .* EXPR)", "i", "b[i]"),
    "BUILTIN": (
        *"sin der pre edge change sum product max min size ndims zeros ones fill identity diagonal".split(),
        *"transpose cat array vector scalar matrix cross skew symmetric linspace outerProduct "
        "noEvent".split(),
        *"smooth sample initial delay homotopy semiLinear div mod rem floor ceil integer abs sign".split(),
        *"sqrt exp log Integer String inStream actualStream cardinality spatialDistribution "
        "previous".split(),
    ),
}  # fmt: skip
_FREE = ("FILE", "NEW", "NAME", "TYPE", "BUILTIN", "NUMBER")


_WORD = re.compile("|".join(rf"\b{rule}\b" for rule in _RULES))


def sentence(seed: str, most_depth: int = 8) -> str:
    """One text; the same seed gives the same text."""
    return _expand("FILE", Choices(seed), most_depth)


def _expand(rule: str, choices: Choices, depth: int) -> str:
    alternatives = _RULES[rule]
    count = len(alternatives) if depth > 2 else min(depth + 1, len(alternatives))
    words = choices.of(alternatives if rule in _FREE else alternatives[: max(1, count)])
    out: list[str] = []
    start = 0
    for found in _WORD.finditer(words):
        out += [words[start : found.start()], _expand(found[0], choices, depth - 1)]
        start = found.end()
    return "".join([*out, words[start:]])
