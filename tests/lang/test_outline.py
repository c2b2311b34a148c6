"""A tree read part by part from an outline is the tree the parser builds, spans included."""

from __future__ import annotations

import os
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from acausal.errors import AcausalError, LookupProblem, Source
from acausal.lang import ast, outline_reading, parser_modifications
from acausal.lang.lexer import decode as decode_text
from acausal.lang.outline import Outline, decode, encode, outline_of
from acausal.lang.outline_reading import read_outlined
from acausal.lang.parser import Marks, parse, parse_part, parse_with_marks
from acausal.lang.printer import print_definition
from tests.lang.generators import definitions
from tests.lang.trees import differences

# The fixture that isolates the tests takes MODELICAPATH away, so it is read when this file is collected.
MODELICAPATH = [Path(part) for part in os.environ.get("MODELICAPATH", "").split(os.pathsep) if part]

PACKAGE = """\
within A.B;
final package P "Has a bit of all"
  encapsulated partial model M
    Real x annotation(Placement(transformation(extent={{-100,-100},{100,100}})),
      Dialog(group="a long group"));
    replaceable model N = M(x = 1) constrainedby M
      annotation(choices(choice(redeclare model N = M "one", x = 2), choice(redeclare model N = O "two")));
    block Inner parameter Real p = 1; end Inner;
  equation
    x = 1 annotation(Line(points={{1,1},{2,2},{3,3},{4,4},{5,5},{6,6},{7,7},{8,8},{9,9},{10,10},
      {11,11},{12,12},{13,13}}));
    annotation(Documentation(info="<html>A text that is long enough to be an annotation of its own.</html>"),
      Icon);
  end M;
  type 'long name' = enumeration(a "first", b);
protected
  redeclare final inner outer replaceable record R = S[3](each final z = 1);
  impure function f = der(g, x, y);
  operator record Q end Q;
  expandable connector K end K;
  model extends E(y = 1) "again" end E;
  import A.{b, c};
end P;
"""


def outlined(source: Source) -> tuple[ast.StoredDefinition, Outline | None]:
    stored, marks = parse_with_marks(source)
    return stored, decode(encode(outline_of(stored, marks)), len(source.text))


def same(text: str) -> bool:
    source = Source("test.mo", text)
    stored, outline = outlined(source)
    if outline is None:  # a file with a `der` class at the top has none
        return any(isinstance(definition, ast.DerClass) for _, definition in stored.classes)
    read = read_outlined(source, outline)
    assert not differences(read, stored)
    return read == stored


def test_every_construct() -> None:
    assert same(PACKAGE)
    _, outline = outlined(Source("test.mo", PACKAGE))
    assert outline is not None
    assert len([mark for mark in outline.classes if mark is None]) == 4


@given(definitions)
def test_generated(tree: ast.StoredDefinition) -> None:
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(parser_modifications, "LONG_ANNOTATION", 0)
        assert same(print_definition(tree))


def test_equality_reads_and_leaves_plain_nodes() -> None:
    source = Source("test.mo", PACKAGE)
    stored, outline = outlined(source)
    assert outline is not None
    (_, read), (_, parsed) = read_outlined(source, outline).classes[0], stored.classes[0]
    assert type(read) is not ast.LongClass
    assert isinstance(read, ast.LongClass)
    assert parsed == read
    assert type(read) is ast.LongClass
    assert repr(read_outlined(source, outline)) == repr(stored)


def test_only_what_is_looked_at_is_parsed(monkeypatch: pytest.MonkeyPatch) -> None:
    lengths: list[int] = []

    def counting(
        source: Source, start: int, end: int, stored: Marks, protected: bool | None
    ) -> ast.Element | ast.Annotation:
        lengths.append(end - start - sum(node.span.end - node.span.start for node in stored))
        return parse_part(source, start, end, stored, protected)

    monkeypatch.setattr(outline_reading, "parse_part", counting)
    text = "package P " + " ".join(f"model M{i} Real x = {i}; end M{i};" for i in range(100)) + " end P;"
    source = Source("test.mo", text)
    _, outline = outlined(source)
    assert outline is not None
    ((_, package),) = read_outlined(source, outline).classes
    assert not lengths
    assert isinstance(package, ast.LongClass)
    models = [element for element in package.body.elements if isinstance(element, ast.LongClass)]
    assert [model.name for model in models] == [f"M{i}" for i in range(100)]
    assert [model.kind for model in models] == ["model"] * 100
    assert len(lengths) == 1
    assert isinstance(models[50].body.elements[0], ast.ComponentClause)
    assert len(lengths) == 2
    assert sum(lengths) < 0.1 * len(text)


# --------------------------------------------------------------------------- wrong outlines

SMALL = "package P model A Real x; end A; model B = A(x = 1); end P;"


@given(st.data())
def test_changed_bytes_are_refused_or_harmless(data: st.DataObject) -> None:
    """Whatever the bytes say: no outline, a tree, or an error that says what to do."""
    source = Source("test.mo", SMALL)
    stored, marks = parse_with_marks(source)
    body = bytearray(encode(outline_of(stored, marks)))
    for _ in range(data.draw(st.integers(1, 3))):
        place = data.draw(st.integers(0, len(body) - 1))
        body[place] = data.draw(st.sampled_from(b'0123456789[]{},"ABPmodel'))
    outline = decode(bytes(body), len(SMALL))
    if outline is None:
        return
    try:
        codes = ("library.cache",) if print_definition(read_outlined(source, outline)) else ()
    except LookupProblem as error:
        codes = error.codes
    assert codes == ("library.cache",)


@pytest.mark.parametrize(
    "data",
    [
        b"",
        b"null",
        b"[null,[0],[]]",
        b"[null,[0],[[0,59]]]",
        b'[null,[0],[[0,59,0,"P","package",0]]]',
        b'[null,[0],[[0,60,0,"P","package",0,0]]]',
        b'[null,[0],[[0,-1,0,"P","package",0,0]]]',
        b'[null,[0],[[0,59,0,"P","package",0,0],[5,59]]]',
        b'[null,[0],[[0,59,7,"P","package",0,0]]]',
        b'[null,[0],[[0,59,0,"P","nonsense",0,0]]]',
        b'[null,[0],[[0,59,0,"P","package",99999,0]]]',
        b'[null,[0],[[0,59,0,"P","package",0,9]]]',
        b'[null,[0],[[0,59,0,7,"package",0,0]]]',
        b'[[1],[0],[[0,59,0,"P","package",0,0]]]',
        b'[null,[0],[[0,1e400,0,"P","package",0,0]]]',
        b"[" * 100_000,
        b'{"__reduce__": 1}',
        b"\x80\x04\x95",
    ],
)
def test_what_is_no_outline_is_refused(data: bytes) -> None:
    assert len(SMALL) == 59
    assert decode(data, len(SMALL)) is None


def test_a_forged_outline_falls_back_on_the_text() -> None:
    source = Source("test.mo", SMALL)
    outline = decode(b'[null,[0],[[0,58,0,"P","package",0,0],[10,4]]]', len(SMALL))
    assert outline is not None
    assert read_outlined(source, outline) == parse(source)
    outline = decode(b'[null,[0],[[0,58,0,"Q","package",0,0]]]', len(SMALL))
    assert outline is not None
    with pytest.raises(AcausalError) as raised:
        print_definition(read_outlined(source, outline))
    assert raised.value.codes == ("library.cache",)


@pytest.mark.msl
@pytest.mark.slow
@pytest.mark.skipif(not MODELICAPATH, reason="MODELICAPATH does not name the Modelica Standard Library")
def test_library() -> None:
    files = sorted(path for root in MODELICAPATH for path in root.rglob("*.mo"))
    assert files, f"no .mo file under {MODELICAPATH}"
    for path in files:
        source = decode_text(path.read_bytes(), str(path))
        stored, outline = outlined(source)
        assert outline is not None, path
        assert not differences(read_outlined(source, outline), stored), path
