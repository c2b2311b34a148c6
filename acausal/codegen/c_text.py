"""The functions that an integrator calls, and their C text.

`time_rates` adds what `Code` lacks for Rosenbrock methods: the exact d xdot / d t. Which functions there are
depends on the model: one without entries is left out.
"""

from __future__ import annotations

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
    """What an integrator calls, by the run-time's names; those without results are left out."""
    found = {
        "ode": code.ode,
        "jac": code.jac,
        "events": code.events,
        "scales": code.sizes,
        "output": code.outputs,
        "assertions": code.conditions,
    }
    rates = time_rates(code)
    if rates is not None:
        found["derivative"] = rates
    return {name: f for name, f in found.items() if any(f.nnz_out(i) for i in range(f.n_out()))}


def c_text(functions: Mapping[str, Function]) -> str:
    """One C file with all functions under their own names, for `long long` integers and doubles."""
    options = {"with_header": False, "casadi_int": "long long int", "main": False, "mex": False}
    generator = ca.CodeGenerator("model.c", options)
    for function in functions.values():
        generator.add(function)
    return generator.dump()


def instructions(functions: Mapping[str, Function]) -> int:
    """How many operations all functions consist of, which is what compiling and evaluating them costs."""
    return sum(f.n_instructions() if f.is_a("SXFunction") else f.n_nodes() for f in functions.values())
