"""Base Modelica is read: what we write comes back as the same flat model, others' texts are understood."""

from __future__ import annotations

from pathlib import Path

import pytest

from acausal.api import Model, loads
from acausal.errors import AcausalError, Source
from acausal.lang.base_modelica import print_flat
from acausal.lang.base_reading import as_modelica_text, decoded, is_base_modelica
from acausal.lang.flat import FlatModel, Variability
from acausal.lang.library import Library, library_directories
from acausal.pipeline import compile_model
from acausal.survey import survey_classes
from acausal.symbolic.expressions import expr as ex
from tests.language.models import FOLDER

NOT_READ = {
    "function_units": "an inlined function leaves no trace of the unit that it declared for its result",
    "functions_at_events": "a function that runs as a unit has no text in Base Modelica yet",
}
FLATS = sorted(path for path in FOLDER.glob("*.flat") if path.stem not in NOT_READ)

HIERARCHICAL = """\
//! base 0.1.0
package 'Wheel'
  type 'Mode' = enumeration(free, held);
  @3 record 'Point'
    Real 'x';
    Real[2] 'v';
  end 'Point';
  constant Real 'g' = 9.81;
  pure constant function 'twice'
    input Real 'u';
    output Real 'y';
  algorithm
    'y' := 2 * 'u';
  end 'twice';
  @4 model 'Wheel' "A part with a record, an array and a function" @5
    'Point' 'body.p';
    parameter Real 'body.m'(unit = "kg", min = 0) = 2 "Mass";
    @6 parameter 'Mode' 'mode' = 'Mode'.held;
    Real 'a' annotation(Protected = true);
    discrete Real 'n'(start = 0, fixed = true);
  equation
    @7 'body.p'.'x' = 'twice'(time);
    for i in 1:2 loop
      'body.p'.'v'[i] = i * 'body.m' @8;
    end for;
    'a' = if 'mode' == 'Mode'.held then 'g' else time;
    when 'body.p'.'x' > 1 then
      'n' = pre('n') + 1;
    end when;
  initial equation
    'n' = pre('n');
  annotation(experiment(StopTime = 2));
  end 'Wheel';
end 'Wheel';
"""


def flat_of(model: Model, **parameters: float) -> FlatModel:
    flat = model.run(parameters, "flat").flat
    assert flat is not None
    return flat


def names(flat: FlatModel) -> list[str]:
    return [variable.name for variable in flat.variables]


def test_there_are_flat_texts() -> None:
    assert len(FLATS) > 40


@pytest.mark.parametrize("path", FLATS, ids=lambda path: path.stem)
def test_what_we_write_is_read_as_the_same_model(path: Path) -> None:
    """Apart from what the front end settles: `edge(b)` is `b and not pre(b)`, functions are inlined, ..."""
    text = path.read_text()
    once = print_flat(flat_of(loads(text)))
    again = print_flat(flat_of(loads(once)))
    assert again == once
    if not any(words in text for words in ("edge(", "assert(true", "  function '")):
        assert once == text


@pytest.mark.parametrize("package", ["Hydraulics", "TenSpeed"])
def test_models_of_libraries_come_back(package: str) -> None:
    library = Library(library_directories())
    for name in survey_classes(library.find(package), examples_only=True):
        assert isinstance(name, str)
        flat = compile_model(library, name, stop_after="flat").flat
        assert flat is not None
        back = flat_of(loads(print_flat(flat)))
        assert (back.name, names(back)) == (flat.name, names(flat))
        assert back.equation_count == flat.equation_count
        assert [(e.left, e.right) for e in back.equations] == [(e.left, e.right) for e in flat.equations]
        assert [v.protected for v in back.variables] == [v.protected for v in flat.variables]
        assert back.experiment == flat.experiment


def test_records_arrays_functions_and_decorations() -> None:
    flat = flat_of(loads(HIERARCHICAL))
    assert (flat.name, flat.equation_count, len(flat.unknowns)) == ("Wheel", 5, 5)
    assert names(flat)[:3] == ["body.p.x", "body.p.v[1]", "body.p.v[2]"]
    assert flat.by_name["mode"].type.name == "Mode"
    assert flat.by_name["a"].protected
    assert flat.by_name["n"].variability is Variability.DISCRETE
    assert not flat.by_name["body.m"].top_level
    assert flat.experiment.stop_time == 2


def test_parameters_go_by_the_names_of_the_model() -> None:
    model = loads(HIERARCHICAL)
    flat = flat_of(model, **{"body.m": 7})
    assert flat.by_name["body.m"].binding == ex.const(7)
    with pytest.raises(AcausalError) as raised:
        flat_of(model, **{"body.k": 7})
    assert "body.k" in str(raised.value)


def test_positions_are_those_of_the_file() -> None:
    source = Source("a.bmo", HIERARCHICAL)
    plain = as_modelica_text(source).text
    assert len(plain) == len(HIERARCHICAL)
    assert "@" not in plain
    assert "pure          function 'twice'" in plain
    with pytest.raises(AcausalError) as raised:
        loads(HIERARCHICAL.replace("'n' = pre('n') + 1", "'n' = 'nothing'")).run({}, "flat")
    span = raised.value.diagnostics[0].span
    assert span is not None
    assert span.text == "'nothing'"


@pytest.mark.parametrize(
    "line",
    [
        "parameter equation guess('a') = 1;",
        "initial equation prioritize('a', 3);",
        'partition "clocked"',
    ],
)
def test_what_is_not_supported_is_refused(line: str) -> None:
    with pytest.raises(AcausalError) as raised:
        loads(f"//! base 0.1.0\npackage 'M' model 'M' Real 'a'; {line} end 'M'; end 'M';")
    assert raised.value.codes == ("unsupported.base-modelica",)


def test_strings_and_comments_are_left_alone() -> None:
    text = """//! base 0.1.0\n/* @1 */ "@2 partition" 'guess (@3' // guess(x)\n"""
    assert as_modelica_text(Source("a.bmo", text)).text == text


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("//! base 0.1.0\n", True),
        ("//! base 3.5r0\n", True),
        ("//! base\n", False),
        ("model M end M;", False),
    ],
)
def test_the_header_tells(text: str, expected: bool) -> None:
    assert is_base_modelica(Source("a", text)) is expected


@pytest.mark.parametrize(
    ("name", "expected"),
    [
        ("'a.b[2].c'", "a.b[2].c"),
        ("'a.b'[3].'c'", "a.b[3].c"),
        (r"'\'foo bar\'.x'", "'foo bar'.x"),
        ("_R1", "_R1"),
        (r"'a\\'", "a\\"),
    ],
)
def test_names_are_decoded(name: str, expected: str) -> None:
    assert decoded(name) == expected
