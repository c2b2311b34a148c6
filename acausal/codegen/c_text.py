"""The functions that an integrator calls, and their C text.

`time_rates` adds what `Code` lacks for Rosenbrock methods: the exact d xdot / d t. Which functions there are
depends on the model: one without entries is left out.
"""

from __future__ import annotations

import re
from collections.abc import Mapping

import casadi as ca
from casadi import Function

from acausal.codegen.casadi_expressions import FORWARD
from acausal.codegen.functions import Code


def time_rates(code: Code) -> Function | None:
    """`(...) -> rate`, the derivative of `xdot` by time with everything else held; None where it is zero."""
    ode = code.ode
    if ode.nnz_out(0) == 0:
        return None
    options = {"helper_options": FORWARD}
    if ode.is_a("SXFunction"):
        symbols = ode.sx_in()
        rate = ca.jacobian(ode.call(symbols)[0], symbols[0], options)
        outputs, known = [ca.densify(rate)], rate.nnz()
        return Function("rates", symbols, outputs, ode.name_in(), ["rate"], FORWARD) if known else None
    inputs = ode.mx_in()
    graph = ca.jacobian(ode.call(inputs, True, False)[0], inputs[0], options)
    if graph.nnz() == 0:
        return None
    return Function("rates", inputs, [ca.densify(graph)], ode.name_in(), ["rate"], FORWARD)


def run_functions(code: Code) -> dict[str, Function]:
    """What an integrator calls, by the run-time's names; those without results are left out.

    `jac` gives the rates too, as `Quick.slopes`, and `derivative` is left out, unless `Code` has no slopes.
    """
    quick = code.quick
    found = {
        "ode": quick.ode or code.ode,
        "jac": quick.slopes or code.jac,
        "events": code.events,
        "scales": code.sizes,
        "output": code.outputs,
        "assertions": code.conditions,
    }
    rates = time_rates(code) if quick.slopes is None else None
    if rates is not None:
        found["derivative"] = rates
    return {name: f for name, f in found.items() if any(f.nnz_out(i) for i in range(f.n_out()))}


def event_functions(code: Code) -> dict[str, Function]:
    """What else is called at an event; those without results are left out."""
    part = code.discrete
    found = {"update": part.update, "memory": part.memory, "actions": part.actions}
    return {name: function for name, function in found.items() if function.nnz_out(0)}


def c_text(functions: Mapping[str, Function]) -> str:
    """One C file with all functions under their own names, for `long long` integers and doubles.

    What it defines beside them begins with `model_` and the first name: such files can be linked together.
    """
    options = {"with_header": False, "casadi_int": "long long int", "main": False, "mex": False}
    generator = ca.CodeGenerator(f"model_{next(iter(functions))}.c", options)
    for function in functions.values():
        generator.add(function)
    return _without_calls(_without_null_tests(generator.dump()))


_SMALL = re.compile(r"^(casadi_real casadi_\w+\(casadi_real x(?:, casadi_real y)?\) *\{)", re.MULTILINE)
_CHOICES = (("return fmin(x, y);", "x < y"), ("return fmax(x, y);", "x > y"))


def _without_calls(text: str) -> str:
    """Functions of one or two numbers in the line; the smaller and the larger without the library's help."""
    for call, test in _CHOICES:
        text = text.replace(call, f"return {test} || y != y ? x : y;")
    return _SMALL.sub(r"static inline \1", text)


_OUTER = re.compile(r"^  return (casadi_f\d+)\(arg, res, iw, w, mem\);$", re.MULTILINE)
_TAKEN = re.compile(r"arg\[(\d+)\]\? arg\[\1\]\[(\d+)\] : 0")
_GIVEN = re.compile(r"if \(res\[(\d+)\]!=0\) res\[\1\]\[(\d+)\]=")


def _without_null_tests(text: str) -> str:
    """Functions that are only called from outside get all their arrays: no test of each, and no aliasing.

    Makes the derivatives of a chain of 46 valves faster by a factor of 1.5.
    """
    for name in _OUTER.findall(text):
        begin = text.find(f"static int {name}(")
        body = text.find("{\n", begin) + 2
        end = text.find("\n}\n", body)
        if begin < 0 or text.count(f"{name}(") != 2:
            continue
        inside = text[body:end]
        if "arg" in _TAKEN.sub("", inside) or "res" in _GIVEN.sub("", inside):
            continue
        taken = sorted({int(m[1]) for m in _TAKEN.finditer(inside)})
        given = sorted({int(m[1]) for m in _GIVEN.finditer(inside)})
        arrays = [f"  const casadi_real *restrict arg{i} = arg[{i}];\n" for i in taken]
        arrays += [f"  casadi_real *restrict res{i} = res[{i}];\n" for i in given]
        inside = _GIVEN.sub(r"res\1[\2]=", _TAKEN.sub(r"arg\1[\2]", inside))
        text = text[:body] + "".join(arrays) + inside + text[end:]
    return text
