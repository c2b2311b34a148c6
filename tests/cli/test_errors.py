"""What is wrong with a model or with a command: exit status, diagnostics, never a traceback."""

from __future__ import annotations

import json
import os
import re
import shlex
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

from acausal.cli.guard import guarded
from acausal.errors import BalanceProblem, UsageProblem, fail
from tests.cli.calls import Call
from tests.docs.examples import ROOT

KEYS = ["severity", "code", "message", "file", "line", "column", "names", "hint"]

WRONG_COMMANDS = """
check
check Tank.mo --bogus
check Tank.mo Tank.mo
nonsense Tank.mo
compile Tank.mo --stop-after nowhere
compile Tank.mo --show nothing
compile Tank.mo --show code --stop-after flat
compile Tank.mo -p
compile Tank.mo -p hole
compile Tank.mo -p hole=
compile Tank.mo -p =1
compile Tank.mo -p hole=1 -p hole=2
compile Tank.mo -p 'ho le=1'
check Missing.mo
check folder/
check folder.mo
check Tank.txt
check 'a b'
check ''
check ../*
check Tank.mo --path missing
check TenSpeed --class Examples
simulate Tank.mo --solver nonsense
simulate Tank.mo --stop-time soon
simulate Tank.mo --stop-time -1
simulate Tank.mo --stop-time nan
simulate Tank.mo --rtol 0
simulate Tank.mo --interval -0.1
simulate Tank.mo --max-step 0
simulate Tank.mo -o missing/t.csv
simulate Tank.mo -o folder
simulate Tank.mo --plot t.jpg
simulate Tank.mo --plot missing/t.png
""".strip().splitlines()

WRONG_MODELS = """
check Binary.mo
check Empty.mo
check Json.mo
check Deep.mo
check NoSuchClass
check folder
check TenSpeed.Examples.NoSuchModel
check TenSpeed.Examples
check Tank.mo --class Tonk
compile Tank.mo -p nothing=1
compile Tank.mo -p hole.x=1
compile Tank.mo -p n=1.5
compile Tank.mo -p n=true
compile Tank.mo -p open=1
compile Tank.mo -p hole=size
compile Tank.mo -p 'hole=(1'
compile Tank.mo -p surface=2
compile Tank.mo -p h=2
simulate Tank.mo -v nothing
simulate Tank.mo -v h -v V
""".strip().splitlines()


@pytest.fixture(autouse=True)
def files(working_directory: Path) -> None:
    (working_directory / "folder").mkdir()
    (working_directory / "folder.mo").mkdir()
    (working_directory / "Tank.txt").write_text("model A end A;")
    (working_directory / "Binary.mo").write_bytes(bytes(range(256)) * 20)
    (working_directory / "Empty.mo").write_text("")
    (working_directory / "Json.mo").write_text('{"a": [1, 2, 3]}')
    (working_directory / "Deep.mo").write_text(f"model D Real x = {'(' * 5000}1{')' * 5000}; end D;")


@pytest.mark.parametrize("line", WRONG_COMMANDS)
def test_wrong_command(call: Call, line: str) -> None:
    _expect(call, line, 2)


@pytest.mark.parametrize("line", WRONG_MODELS)
def test_wrong_model(call: Call, line: str) -> None:
    _expect(call, line, 1)


def _expect(call: Call, line: str, status: int) -> None:
    done = call(*shlex.split(line))
    assert (done.status, done.out) == (status, "")
    assert "error: " in done.err
    assert "[internal]" not in done.err
    as_json = call(*shlex.split(line), "--json")
    if line != "compile Tank.mo -p":  # takes --json for the parameter
        assert as_json.status == status
        assert as_json.err == ""
        assert as_json.problems
        assert all(list(problem) == KEYS for problem in as_json.problems)
        assert all(problem["message"] for problem in as_json.problems)


def test_nothing_to_do_shows_help(call: Call) -> None:
    done = call()
    assert done.status == 2
    assert "simulate" in done.out


def test_error_shows_place_and_source(call: Call, working_directory: Path) -> None:
    (working_directory / "U.mo").write_text("model U\n  Real level = levle;\nend U;\n")
    done = call("check", "U.mo")
    assert done.err.startswith("U.mo:2:16: error: ")
    assert "    2 |   Real level = levle;\n      |                ^^^^^\n" in done.err


def test_long_lines_are_not_wrapped(
    call: Call, working_directory: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("COLUMNS", "40")
    name = "x" * 150
    (working_directory / "L.mo").write_text(f"model L Real {name} = y; end L;")
    done = call("check", "L.mo")
    assert done.err.splitlines()[0].startswith("L.mo:1:")
    assert name in call("compile", "L.mo", "--show", "ast").out


def test_control_characters_do_not_reach_the_terminal(call: Call, working_directory: Path) -> None:
    (working_directory / "C.mo").write_text('model C Real x = y "\x1b[31mred"; end C;')
    assert "\x1b" not in call("check", "C.mo").err


def _raise(error: BaseException) -> Callable[[], object]:
    def run() -> object:
        raise error

    return run


@pytest.mark.parametrize(
    ("error", "status"),
    [
        (fail(BalanceProblem, "a.b", "wrong"), 1),
        (fail(UsageProblem, "a.b", "wrong"), 2),
        (ValueError("oh\nno"), 1),
        (RecursionError(), 1),
        (MemoryError(), 1),
        (KeyboardInterrupt(), 130),
    ],
)
def test_every_end_has_a_status(
    error: BaseException, status: int, capsys: pytest.CaptureFixture[str]
) -> None:
    assert guarded(_raise(error), as_json=False) == status
    assert "Traceback" not in capsys.readouterr().err


def test_internal_errors_ask_to_be_reported(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    assert guarded(_raise(ValueError("oh no")), as_json=True) == 1
    (problem,) = json.loads(capsys.readouterr().out)
    assert (problem["code"], problem["message"]) == ("internal", "internal error, ValueError: oh no")
    assert "report" in problem["hint"]
    monkeypatch.setenv("ACAUSAL_DEBUG", "1")
    guarded(_raise(ValueError("oh no")), as_json=True)
    assert "Traceback" in capsys.readouterr().err


def _python(*words: str) -> list[str]:
    return [sys.executable, *words]


ENVIRONMENT = os.environ | {"PYTHONPATH": str(ROOT)}


def test_nobody_reads() -> None:
    """`acausal ... | head -1` ends quietly."""
    command = _python("-m", "acausal", "compile", "TenSpeed.Examples.MainRegulatorFlow", "--show", "flat")
    with subprocess.Popen(
        command, env=ENVIRONMENT, stdout=subprocess.PIPE, stderr=subprocess.PIPE
    ) as process:
        assert process.stdout is not None
        assert process.stderr is not None
        process.stdout.close()
        assert process.stderr.read() == b""
        assert process.wait(timeout=60) in (1, 141)


@pytest.mark.parametrize(
    ("words", "forbidden"),
    [
        (["--help"], "acausal.lang acausal.symbolic casadi matplotlib numpy xarray sympy sksundae"),
        (["check", "Tank.mo"], "acausal.simulate casadi matplotlib numpy xarray sympy sksundae rich.table"),
        (["compile", "Tank.mo", "--json"], "matplotlib xarray sympy sksundae"),
        (["explain", "Tank.mo"], "acausal.simulate casadi matplotlib xarray sympy sksundae"),
    ],
)
def test_only_what_is_needed_is_imported(words: list[str], forbidden: str) -> None:
    code = f"import sys; from acausal.cli import main; main({words!r}); print(*sys.modules, file=sys.stderr)"
    done = subprocess.run(_python("-c", code), env=ENVIRONMENT, capture_output=True, text=True, check=True)
    assert not set(forbidden.split()) & set(done.stderr.split())


def test_a_terminal_gets_colours_and_the_same_text(
    call: Call, working_directory: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (working_directory / "U.mo").write_text("model U\n  Real level = levle;\nend U;\n")
    plain = call("check", "U.mo").err
    monkeypatch.setattr(sys.stderr, "isatty", lambda: True, raising=False)
    monkeypatch.setenv("TERM", "xterm")
    monkeypatch.delenv("NO_COLOR", raising=False)
    coloured = call("check", "U.mo").err
    assert "\x1b[1;31merror\x1b[0m" in coloured
    assert re.sub(r"\x1b\[[0-9;]*m", "", coloured) == plain
