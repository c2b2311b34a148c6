"""A compiled system as CasADi Functions of one signature, for use outside: `(t, x, z, u, p, m, d) -> ...`.

`t` time, `x` states, `z` tearing variables of implicit blocks, `u` inputs (and delayed values), `p`
parameters and constants, `m` modes (0 or 1), `d` frozen values: the vectors of `codegen.functions`, in an
order that suits CasADi's integrators. Where a Function solves blocks itself, `z` is where it begins; else it
is their solution.
"""

from __future__ import annotations

from collections.abc import Mapping

import casadi as ca
from casadi import SX, Function

from acausal.codegen.casadi_expressions import FORWARD
from acausal.codegen.functions import Code, nominals_of, state_leaves
from acausal.codegen.implicit import implicit_form
from acausal.codegen.program import Program
from acausal.codegen.scope import column, split
from acausal.codegen.starts import open_starts, start_leaf
from acausal.codegen.stitch import Goal, Stitching
from acausal.symbolic.expressions.expr import sym

SIGNATURE = ("t", "x", "z", "u", "p", "m", "d")


def named_functions(code: Code, outputs: Function) -> dict[str, Function]:
    """`ode`, `dae`, `jac`, `events`, `update`, `outputs`, `initial`, `parameters`.

    `outputs` gives the chosen variables from the inputs of `Code.outputs`. Raises `UnsupportedProblem` for
    what has no numeric code.
    """
    return {
        "ode": _ordered("ode", code.ode, {"xdot": "xdot", "z_out": "z_out"}),
        "dae": _dae(code),
        "jac": _ordered("jacobian", code.jac, {"J": "J"}),
        "events": _events(code),
        "update": _update(code),
        "outputs": _ordered("outputs", outputs, {"y": "y"}),
        "initial": _initial(code),
        "parameters": code.parameters,
    }


def _symbols(code: Code) -> dict[str, SX]:
    """One symbol for each group, by name."""
    return {name: SX.sym(name, *code.ode.size_in(i)) for i, name in enumerate(code.ode.name_in())}


def _ordered(name: str, function: Function, results: Mapping[str, str]) -> Function:
    """The Function over the signature; `results` says which of its outputs are kept, and as what."""
    return _reordered(name, function, {given: given for given in SIGNATURE}, results)


def _reordered(
    name: str, function: Function, taken: Mapping[str, str], results: Mapping[str, str]
) -> Function:
    """A Function with inputs and outputs in another order and with other names."""
    sources = [function.name_in().index(given) for given in taken]
    targets = [function.name_out().index(result) for result in results]
    names = list(taken.values()), list(results.values())
    if function.is_a("SXFunction"):
        symbols = function.sx_in()
        values = function.call(symbols, True, False)
        return Function(name, [symbols[i] for i in sources], [values[i] for i in targets], *names, FORWARD)
    inputs = function.mx_in()
    graphs = function.call(inputs, True, False)
    return Function(name, [inputs[i] for i in sources], [graphs[i] for i in targets], *names, FORWARD)


def _dae(code: Code) -> Function:
    """`-> (ode, alg)`: derivatives, and residuals that are zero at a solution, both explicit in x and z."""
    form = implicit_form(code)
    symbols = _symbols(code)
    both = form.call([symbols[given] for given in form.name_in()], True, False)[0]
    size, values = len(code.system.states), split(both)
    inputs = [symbols[given] for given in SIGNATURE]
    outputs = [column(values[:size]), column(values[size:])]
    return Function("dae", inputs, outputs, list(SIGNATURE), ["ode", "alg"], FORWARD)


def _truth(code: Code, root: SX) -> SX:
    """What every relation says by its root."""
    values = [
        {"gt": root[i] > 0, "ge": root[i] >= 0, "lt": root[i] < 0, "le": root[i] <= 0}[relation.op]
        for i, relation in enumerate(code.relations)
    ]
    return ca.vertcat(*values) if values else root


def _events(code: Code) -> Function:
    """`-> (root, holds)`: left minus right side of every relation, and what it says."""
    symbols = _symbols(code)
    given = [symbols[name] for name in code.events.name_in()]
    root = code.events.call(given, True, False)[0]
    inputs = [symbols[name] for name in SIGNATURE]
    return Function("events", inputs, [root, _truth(code, root)], list(SIGNATURE), ["root", "holds"], FORWARD)


def _update(code: Code) -> Function:
    """`-> (m_new, d_new, d_next, x_new)`: one pass over an event, with the values before it fixed.

    `m_new` is what the relations say, `d_new` the frozen values with new discrete variables; with these,
    `d_next` has what holds now as what held before, and `x_new` are the states after resets.
    """
    symbols = _symbols(code)
    names = code.discrete.update.name_in()
    part = code.system.discrete
    d, x = symbols["d"], symbols["x"]
    known, kept = len(part.unknowns), len(part.unknowns) + len(part.memory)
    given = [symbols[name] for name in names]
    root = code.events.call(given, True, False)[0]
    held = split(d)  # a slice of one entry beyond its end would have no rows
    new = column([*split(code.discrete.update.call(given, True, False)[0]), *held[known:]])
    then = [new if name == "d" else symbols[name] for name in names]
    memory = code.discrete.memory.call(then, True, False)[0]
    actions = code.discrete.actions.call(then, True, False)[0]
    after = [x[i] for i in range(x.shape[0])]
    for i, reset in enumerate(part.resets):
        position = code.system.states.index(reset.state)
        after[position] = ca.if_else(actions[i], actions[len(part.resets) + i], after[position])
    outputs = [
        _truth(code, root),
        new,
        column([*split(new)[:known], *split(memory), *held[kept:]]),
        ca.vertcat(*after) if after else x,
    ]
    inputs = [symbols[name] for name in SIGNATURE]
    results = ["m_new", "d_new", "d_next", "x_new"]
    return Function("update", inputs, outputs, list(SIGNATURE), results, FORWARD)


def _initial(code: Code) -> Function:
    """`(t, u, p, m, d, s, guess) -> (x0, z0, p0, found)`: the start from start values `s`, with these modes.

    `guess` is where blocks of the initial problem begin and `found` their solution; `z0` are the tearing
    variables of the running system. `p0` holds the parameters that the start determines, too.
    """
    system = code.system
    nominals = nominals_of(system)
    parameters = tuple(sym(name) for name in system.parameters)
    known = tuple(leaf for leaf in code.dynamic.guesses if leaf in code.initial.slots)
    goals = [
        Goal("x0", state_leaves(system)),
        Goal("z0", known),
        Goal("p0", parameters),
    ]
    starts = tuple(start_leaf(value.name) for value in system.initial.values)
    groups = tuple((name, leaves) for name, leaves in code.initial.groups if name != "s")
    program = Program((*groups, ("s", starts)), open_starts(system).blocks, "start")
    solved = Stitching(program, nominals).closed("initial", goals)
    taken = {name: name for name in ("t", "u", "p", "m", "d", "s")} | {"z": "guess"}
    results = {"x0": "x0", "z0": "z0", "p0": "p0", "z_out": "found"}
    return _reordered("initial", solved, taken, results)
