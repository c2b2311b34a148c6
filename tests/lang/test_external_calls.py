"""External functions in models: tables over time at their events, random numbers, functions run as a unit."""

from __future__ import annotations

from collections.abc import Mapping

import pytest

from acausal.errors import AcausalError, Source
from acausal.lang.base_modelica import print_flat
from acausal.lang.flat import FlatModel
from acausal.lang.library import Library
from acausal.lang.parser import parse
from acausal.pipeline import compile_model
from acausal.symbolic.expressions.evaluate import evaluate
from acausal.symbolic.expressions.expr import Constant, Expr, postorder

TIMED = """
package P
  class Table
    extends ExternalObject;
    function constructor
      input Real data[:, :];
      input Real start;
      input Integer smoothness;
      input Integer extrapolation;
      input Real shift;
      input Integer events;
      output Table object;
    external "C" object = ModelicaStandardTables_CombiTimeTable_init3(
      "NoName", "NoName", data, size(data, 1), 2, start, {2}, 1, smoothness, extrapolation, shift, events,
      false, ",", 0);
    end constructor;
  end Table;
  function value
    input Table t; input Real time_; input Real next; input Real previous; output Real y;
  external "C" y = ModelicaStandardTables_CombiTimeTable_getValue(t, 1, time_, next, previous);
  end value;
  function slope
    input Table t; input Real time_; input Real next; input Real previous; input Real dt; output Real y;
  external "C" y = ModelicaStandardTables_CombiTimeTable_getDerValue(t, 1, time_, next, previous, dt);
  end slope;
  function following
    input Table t; input Real time_; output Real next;
  external "C" next = ModelicaStandardTables_CombiTimeTable_nextTimeEvent(t, time_);
  end following;
  model Test
    parameter Table t = Table([0, 0; 1, 0; 1, 1; 2, 4; 4, 16], {start}, {smoothness}, {outside}, {shift}, 1);
    input Real now;
    input Real next;
    Real y = value(t, now, next, next);
    Real s = slope(t, now, next, next, 2);
    Real e = following(t, now);
  end Test;
end P;
"""


def flat_of(text: str, name: str = "P.Test") -> FlatModel:
    library = Library()
    for _, definition in parse(Source("test.mo", text)).classes:
        library.add(definition)
    flat = compile_model(library, name, stop_after="flat").flat
    assert flat is not None
    return flat


def right_sides(flat: FlatModel) -> dict[str, Expr]:
    return {equation.left.name: equation.right for equation in flat.equations}


def timed(start: float = 0, smoothness: int = 1, outside: int = 2, shift: float = 0) -> FlatModel:
    values = {"start": start, "smoothness": smoothness, "outside": outside, "shift": shift}
    text = TIMED
    for name, value in values.items():
        text = text.replace(f"{{{name}}}", str(value))
    return flat_of(text)


def at(flat: FlatModel, name: str, **values: float) -> Constant:
    known: Mapping[str, float] = values
    return evaluate(right_sides(flat)[name], known.get)


def test_left_limit_before_the_event_and_right_limit_after_it() -> None:
    flat = timed()
    assert at(flat, "y", now=1.0, next=1.0) == pytest.approx(0.0)
    assert at(flat, "y", now=1.0, next=2.0) == pytest.approx(1.0)
    assert at(flat, "y", now=1.0 - 1e-15, next=2.0) == pytest.approx(1.0)
    assert at(flat, "y", now=1.5, next=2.0) == pytest.approx(2.5)


def test_a_step_beyond_the_event_stays_on_its_line() -> None:
    assert at(timed(), "y", now=2.1, next=2.0) == pytest.approx(4.3)


def test_slope_of_a_line_and_by_the_chain_rule() -> None:
    assert at(timed(), "s", now=1.5, next=2.0) == pytest.approx(2 * 3.0)
    assert at(timed(), "s", now=2.0, next=2.0) == pytest.approx(2 * 3.0)
    assert at(timed(), "s", now=2.0, next=4.0) == pytest.approx(2 * 6.0)


def test_zero_before_start_and_shifted() -> None:
    flat = timed(start=1.0, shift=1.0)
    assert at(flat, "y", now=0.5, next=1.0) == 0.0
    assert at(flat, "y", now=2.5, next=3.0) == pytest.approx(2.5)
    assert at(flat, "e", now=0.0) == 1.0
    assert at(flat, "e", now=1.5) == 2.0


def test_next_event_is_beyond_the_rounding_of_time() -> None:
    flat = timed()
    assert at(flat, "e", now=1.0) == 2.0
    assert at(flat, "e", now=1.0 - 1e-15) == 2.0
    assert at(flat, "e", now=0.99) == 1.0


def test_periodic_constant_segments() -> None:
    flat = timed(smoothness=3, outside=3)
    assert at(flat, "y", now=5.5, next=6.0) == 1.0
    assert at(flat, "y", now=6.0, next=6.0) == 1.0
    assert at(flat, "y", now=6.0, next=8.0) == 4.0
    assert at(flat, "e", now=5.5) == pytest.approx(6.0)
    assert at(timed(start=1.7, outside=3), "e", now=0.0) == 1.7


@pytest.mark.parametrize(("smoothness", "outside"), [(1, 2), (3, 3), (1, 1)])
def test_tables_go_into_base_modelica_and_back(smoothness: int, outside: int) -> None:
    flat = timed(smoothness=smoothness, outside=outside)
    text = print_flat(flat)
    again = flat_of(text, "'P.Test'.'P.Test'")
    for now in (-0.5, 0.5, 1.0, 1.7, 3.9, 4.0, 9.3):
        for name in ("y", "e"):
            values = {"now": now, "next": 20.0}
            read = evaluate(right_sides(again)[name], values.get)
            assert read == pytest.approx(at(flat, name, now=now, next=20.0))


LOOP = """
package P
  function steps
    input Real u; input Real table[:]; output Integer next; output Real below;
  algorithm
    next := 1;
    while next < size(table, 1) and u >= table[next] loop
      next := next + 1;
    end while;
    below := table[max(next - 1, 1)];
  end steps;
  model Test
    discrete Integer k;
    discrete Real level;
    input Real u;
  equation
    when sample(0, 1) then
      (k, level) = steps(u, {0, 0.25, 0.5});
    end when;
  end Test;
end P;
"""


def test_a_function_is_run_as_a_unit() -> None:
    (when,) = flat_of(LOOP).whens
    rights = {e.left.name: e.right for e in when.branches[0].equations}
    for u, k, level in ((-1.0, 1, 0.0), (0.0, 2, 0.0), (0.3, 3, 0.25), (9.0, 3, 0.25)):
        assert evaluate(rights["k"], {"u": u}.get) == k
        assert evaluate(rights["level"], {"u": u}.get) == level


RANDOM = """
package P
  function uniform
    input Integer state[2]; output Real r; output Integer new[2];
  external "C" ModelicaRandom_xorshift64star(state, new, r);
  end uniform;
  impure function impureRandom
    input Integer id; output Real r;
  external "C" r = ModelicaRandom_impureRandom_xorshift1024star(id);
  end impureRandom;
  model Test
    discrete Integer s[2](start = {1, 0}, each fixed = true);
    discrete Real r;
    discrete Real a;
    discrete Real b;
  equation
    when sample(0, 1) then
      (r, s) = uniform(pre(s));
      a = impureRandom(1);
      b = impureRandom(1);
    end when;
  end Test;
end P;
"""


def test_random_numbers_at_events() -> None:
    (when,) = flat_of(RANDOM).whens
    rights = {e.left.name: e.right for e in when.branches[0].equations}
    word = (2**25 + 1) * 2685821657736338717 % 2**64

    def draw(name: str, time: float = 0.0) -> Constant:
        leaves: dict[Expr, Constant] = {
            n: {"s[1]": 1, "s[2]": 0}[n.args[0].name] for n in postorder([rights[name]]) if n.op == "pre"
        }
        return evaluate(rights[name], {"time": time}.get, leaves)

    assert draw("s[1]") == word % 2**32 - (2**32 if word % 2**32 >= 2**31 else 0)
    assert draw("a") != draw("b")
    assert draw("a", 1.0) != draw("a", 2.0)
    assert draw("a", 1.0) == draw("a", 1.0)


def test_external_objects_are_no_variables() -> None:
    assert all(variable.name != "t" for variable in timed().variables)


def test_a_function_outside_the_table_is_never_called() -> None:
    text = """package P
      function f input String c; output Integer r; external "C" r = system(c); end f;
      model Test parameter Integer r = f("touch /tmp/never"); Real x[r] = fill(1.0, r); end Test; end P;"""
    with pytest.raises(AcausalError) as problem:
        flat_of(text)
    assert problem.value.codes == ("unsupported.external-function",)
