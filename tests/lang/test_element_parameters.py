"""`-p 'a[2].J=9'`: one element of an array, by its index."""

from __future__ import annotations

import pytest

from acausal.errors import AcausalError, Source
from acausal.lang.library import Library
from acausal.lang.parser import parse
from acausal.pipeline import compile_model

TEXT = """
model Wheel
  parameter Real J = 1;
  parameter Real v[2] = {1, 2};
end Wheel;

model Test
  Wheel a[3](J = {1, 2, 3});
  parameter Real m[2, 2] = [1, 2; 3, 4];
  parameter Real s = 1;
end Test;
"""


def values(**parameters: str) -> dict[str, object]:
    library = Library()
    for _, definition in parse(Source("test.mo", TEXT)).classes:
        library.add(definition)
    flat = compile_model(library, "Test", parameters, stop_after="flat").flat
    assert flat is not None
    return {v.name: v.binding.value for v in flat.variables if v.binding is not None}


@pytest.mark.parametrize("name", ["a[2].J", "a[3].v[1]", "m[2,1]"])
def test_only_the_element_changes(name: str) -> None:
    before, after = values(), values(**{name: "9"})
    assert after == {**before, name: 9}
    assert before[name] != 9


@pytest.mark.parametrize(
    ("name", "code"),
    [
        ("a[4].J", "type.index-out-of-range"),
        ("s[1]", "modification.unknown-attribute"),
        ("a[1]b", "usage.parameter-name"),
        ("a[x].J", "usage.parameter-name"),
    ],
)
def test_what_is_no_element(name: str, code: str) -> None:
    with pytest.raises(AcausalError) as caught:
        values(**{name: "1"})
    assert caught.value.codes == (code,)
