"""Wrong models of library components: messages point at what the user wrote, not into the library."""

from __future__ import annotations

import pytest

import acausal
from acausal.errors import AcausalError

TEXT = """package Wrong
  import C = Mechanics.Rotational.Components;
  import S = Mechanics.Rotational.Sources;
  model TwoSpeeds
    S.Speed left(w_start = 10);
    C.IdealGear gear(ratio = 2);
    C.Fixed case;
  equation
    connect(left.flange, gear.flange_a);
    connect(gear.flange_b, case.flange);
  end TwoSpeeds;
  model LooseDamper
    S.Torque motor(tau_start = 5);
    C.Damper damper(d = 2);
  equation
    connect(motor.flange, damper.flange_a);
  end LooseDamper;
  model RigidLoop
    C.Inertia body(J = 1);
  equation
    connect(body.flange_a, body.flange_b);
  end RigidLoop;
  model NoSignal
    S.SpeedSignal source;
    C.Inertia body(J = 1);
  equation
    connect(source.flange, body.flange_a);
  end NoSignal;
  model NoValue
    S.Torque motor(tau_start = 5);
    C.Inertia body(J = 1);
    C.SpringDamper shaft;
  equation
    connect(motor.flange, body.flange_a);
    connect(body.flange_b, shaft.flange_a);
  end NoValue;
  model FixedTwice
    C.Inertia a(J = 1, w(start = 10, fixed = true));
    C.Inertia b(J = 1, w(start = 3, fixed = true));
    C.IdealGear gear(ratio = 2);
  equation
    connect(a.flange_b, gear.flange_a);
    connect(gear.flange_b, b.flange_a);
  end FixedTwice;
  model NoInertia
    S.Torque motor(tau_start = 5);
    parameter Real J = 0;
    C.Inertia body(J = 2*J);
  equation
    connect(motor.flange, body.flange_a);
  end NoInertia;
  model LooseOrifice
    Hydraulics.Sources.FlowSource pump(q_start = 1e-4);
    Hydraulics.Components.Orifice orifice(d = 1e-3);
  equation
    connect(pump.port, orifice.port_a);
  end LooseOrifice;
  model Jump
    S.SpeedSignal source(w = if time < 0.5 then 0 else 1);
    C.Inertia body(J = 1);
  equation
    connect(source.flange, body.flange_a);
  end Jump;
  model FixedAndDriven
    S.Speed source(w_start = 10);
    C.Inertia body(J = 1, w(fixed = true));
  equation
    connect(source.flange, body.flange_a);
  end FixedAndDriven;
  model LoopOfBooleans
    Boolean a, b;
  equation
    a = not b;
    b = a;
  end LoopOfBooleans;
  model IntegerOfTime
    Integer k;
    Real x;
  equation
    der(x) = 1;
    k = x;
  end IntegerOfTime;
  model SignalAgainstTank
    Signals.Sources.Constant level(k = 2e5);
    Hydraulics.Sources.PressureSignal source;
    Hydraulics.Sources.Tank tank;
  equation
    connect(level.y, source.p);
    connect(source.port, tank.port);
  end SignalAgainstTank;
  model FixedFlow
    Hydraulics.Sources.FlowSource pump(q_start = 1e-5);
    Hydraulics.Components.Pipe pipe(d = 6e-3, l = 1, m_flow(fixed = true));
    Hydraulics.Sources.Tank tank;
  equation
    connect(pump.port, pipe.port_a);
    connect(pipe.port_b, tank.port);
  end FixedFlow;
  model Pair
    S.Speed left(w_start = 1), right(w_start = 2);
    C.Inertia body(J = 1);
  equation
    connect(left.flange, body.flange_a);
    connect(right.flange, body.flange_b);
  end Pair;
  model Pairs
    Pair pair[2];
  end Pairs;
end Wrong;"""

EXPECTED = {
    # model: what the line of the first diagnostic holds, what its message says, what its hint says
    "TwoSpeeds": ("C.Fixed case", "`left` and `case` both prescribe the angle or speed", "`left` or `case`"),
    "LooseDamper": ("C.Damper damper", "`damper.flange_b` is not connected", "connect `damper.flange_b`"),
    "RigidLoop": ("connect(body.flange_a", "connections close a loop of `body`", "remove this connection"),
    "NoSignal": ("S.SpeedSignal source", "the input `source.w` has no value", "connect `source.w`"),
    "NoValue": ("C.SpringDamper shaft", "`shaft.c` and `shaft.d` have no value", "shaft.c = ..."),
    "FixedTwice": ("C.Inertia b", "the start value `b.w` = 3", "`b.w`, `a.w`"),
    "NoInertia": ("C.Inertia body(J = 2*J)", "`body.J * body.a = motor.tau`", "`J` is zero"),
    "LooseOrifice": ("Orifice orifice", "in the initial system", "connect `orifice.port_b`"),
    "Jump": ("w = if", "since it prescribes `body.w`", "something that gives way"),
    "FixedAndDriven": ("C.Inertia body", "Speed.mo:11 in source", "remove `fixed = true` from `body.w`"),
    "LoopOfBooleans": ("a = not b", "`a` depends on itself at one instant", "use `pre(a)`"),
    "IntegerOfTime": ("k = x", "with the continuous `x`", "make `k` a Real"),
    "SignalAgainstTank": ("Tank tank", "`source` and `tank` both prescribe the pressure", "remove `source`"),
    "FixedFlow": ("Pipe pipe", "in the initial system", "remove `fixed = true` from `pipe.m_flow`"),
}  # fmt: skip


@pytest.mark.parametrize("name", EXPECTED)
def test_the_line_is_the_users_own(name: str) -> None:
    line, says, hint = EXPECTED[name]
    with pytest.raises(AcausalError) as caught:
        acausal.loads(TEXT, f"Wrong.{name}").compile().simulate()
    first = caught.value.diagnostics[0]
    assert first.span is not None
    assert first.span.file == "<string>"
    assert line in TEXT.splitlines()[first.span.line - 1]
    assert says in first.message
    assert hint in first.hint


def test_what_is_zero_has_a_place_of_its_own() -> None:
    with pytest.raises(AcausalError) as caught:
        acausal.loads(TEXT, "Wrong.NoInertia").compile().simulate()
    zero = next(d for d in caught.value.diagnostics if d.names == ("J",))
    assert zero.span is not None
    assert "parameter Real J = 0" in TEXT.splitlines()[zero.span.line - 1]


def test_other_places_follow_likeliest_first() -> None:
    with pytest.raises(AcausalError) as caught:
        acausal.loads(TEXT, "Wrong.TwoSpeeds").compile()
    texts = [d.span.text for d in caught.value.diagnostics if d.span is not None]
    assert texts == [
        "case",
        "left(w_start = 10)",
        "connect(gear.flange_b, case.flange)",
        "connect(left.flange, gear.flange_a)",
    ]


def test_elements_of_an_array_are_told_once() -> None:
    with pytest.raises(AcausalError) as caught:
        acausal.loads(TEXT, "Wrong.Pairs").compile()
    first, *_, last = caught.value.diagnostics
    assert "inside `pair[1]` (<string>:" in first.message
    assert "inside `pair[2]` (<string>:" in last.message
    assert len(caught.value.diagnostics) == 5
    assert first.span == last.span


def test_a_loose_connector_is_the_first_name() -> None:
    with pytest.raises(AcausalError) as caught:
        acausal.loads(TEXT, "Wrong.LooseDamper").compile()
    assert caught.value.diagnostics[0].names[0] == "damper.flange_b.tau"
