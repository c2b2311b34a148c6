"""Laws of connection networks: flows sum to zero at every node, potentials are equal, energy is conserved.

Random trees of rotating bodies are joined rigidly, by springs with dampers and by gears, and driven by
torques. What must hold at every instant of the simulated motion:

    sum of tau over all flanges of a node = 0,
    power of the sources = d(kinetic + elastic energy)/dt + power lost in the dampers.
"""

from __future__ import annotations

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray

import acausal

Vector = NDArray[np.float64]


@st.composite
def networks(draw: st.DrawFn) -> tuple[int, list[tuple[str, int, int]], list[tuple[int, float]]]:
    """Bodies 0..n-1, couplings (kind, body, later body) that form a tree, and torques on some bodies."""
    bodies = draw(st.integers(2, 6))
    kinds = st.sampled_from(["spring", "gear", "rigid"])
    couplings = [(draw(kinds), draw(st.integers(0, k - 1)), k) for k in range(1, bodies)]
    torques = draw(
        st.lists(st.tuples(st.integers(0, bodies - 1), st.integers(-9, 9)), min_size=1, max_size=3)
    )
    return bodies, couplings, [(body, float(torque)) for body, torque in torques]


def text_of(bodies: int, couplings: list[tuple[str, int, int]], torques: list[tuple[int, float]]) -> str:
    """The network as a model; body k is called `b[k + 1]`."""
    lines = [
        "model Network",
        f"  Mechanics.Rotational.Components.Inertia b[{bodies}](J = {{0.1*k for k in 1:{bodies}}});",
    ]
    equations: list[str] = []
    for i, (kind, a, b) in enumerate(couplings):
        if kind == "rigid":
            equations.append(f"connect(b[{a + 1}].flange_b, b[{b + 1}].flange_a);")
            continue
        component = (
            "SpringDamper c{}(c = 30, d = 0.2)" if kind == "spring" else "IdealGear c{}(ratio = -1.5)"
        ).format(i)
        lines.append(f"  Mechanics.Rotational.Components.{component};")
        equations.append(f"connect(b[{a + 1}].flange_b, c{i}.flange_a);")
        equations.append(f"connect(c{i}.flange_b, b[{b + 1}].flange_a);")
    for i, (body, torque) in enumerate(torques):
        lines.append(f"  Mechanics.Rotational.Sources.Torque t{i}(tau_start = {torque});")
        equations.append(f"connect(t{i}.flange, b[{body + 1}].flange_b);")
    return "\n".join([*lines, "equation", *[f"  {e}" for e in equations], "end Network;"])


def bodies_moved_rigidly(couplings: list[tuple[str, int, int]]) -> int:
    """Constraints between bodies: each takes one degree of freedom."""
    return sum(kind != "spring" for kind, _, _ in couplings)


@settings(max_examples=25)
@given(networks())
def test_power_balance_and_degrees_of_freedom(
    network: tuple[int, list[tuple[str, int, int]], list[tuple[int, float]]],
) -> None:
    bodies, couplings, torques = network
    compiled = acausal.loads(text_of(*network)).compile()
    assert len(compiled.states) == 2 * (bodies - bodies_moved_rigidly(couplings))
    run = compiled.simulate(stop_time=0.4, rtol=1e-8, interval=0.02)

    supplied = sum(
        (torque * run.values(f"b[{body + 1}].w") for body, torque in torques), np.zeros(len(run.time))
    )
    stored = np.zeros(len(run.time))
    for k in range(bodies):
        stored = stored + 0.1 * (k + 1) * run.values(f"b[{k + 1}].w") * run.values(f"b[{k + 1}].a")
    lost = np.zeros(len(run.time))
    for i, (kind, _, _) in enumerate(couplings):
        if kind == "spring":
            stored = stored + run.values(f"c{i}.tau_c") * run.values(f"c{i}.w_rel")
            lost = lost + run.values(f"c{i}.lossPower")
    scale = 1.0 + float(np.max(np.abs(supplied)))
    assert np.allclose(supplied, stored + lost, rtol=0, atol=1e-7 * scale)


@settings(max_examples=25)
@given(networks())
def test_flows_sum_to_zero_and_potentials_agree_at_every_node(
    network: tuple[int, list[tuple[str, int, int]], list[tuple[int, float]]],
) -> None:
    bodies, couplings, torques = network
    run = acausal.loads(text_of(*network)).compile().simulate(stop_time=0.1, interval=0.05)
    nodes: dict[str, set[str]] = {f"b[{k + 1}].flange_{side}": set() for k in range(bodies) for side in "ab"}
    joined = _joined(couplings, torques)
    for a, b in joined:
        group = {a, b} | nodes.get(a, set()) | nodes.get(b, set())
        for member in sorted(group):
            nodes[member] = group
    for members in nodes.values():
        flanges = sorted(members)
        if not flanges:
            continue
        total = sum((run.values(f"{flange}.tau") for flange in flanges), np.zeros(len(run.time)))
        assert np.allclose(total, 0, atol=1e-9)
        for flange in flanges[1:]:
            assert np.array_equal(run.values(f"{flange}.phi"), run.values(f"{flanges[0]}.phi"))


def _joined(couplings: list[tuple[str, int, int]], torques: list[tuple[int, float]]) -> list[tuple[str, str]]:
    pairs: list[tuple[str, str]] = []
    for i, (kind, a, b) in enumerate(couplings):
        if kind == "rigid":
            pairs.append((f"b[{a + 1}].flange_b", f"b[{b + 1}].flange_a"))
        else:
            pairs.append((f"b[{a + 1}].flange_b", f"c{i}.flange_a"))
            pairs.append((f"c{i}.flange_b", f"b[{b + 1}].flange_a"))
    pairs += [(f"t{i}.flange", f"b[{body + 1}].flange_b") for i, (body, _) in enumerate(torques)]
    return pairs
