"""No traceback reaches a person: every way a command can end becomes diagnostics and an exit status."""

from __future__ import annotations

import os
import sys
import traceback
from collections.abc import Callable, Sequence
from io import TextIOWrapper

import typer

from acausal.cli.output import print_diagnostics, print_json
from acausal.errors import AcausalError, Diagnostic, UsageProblem

WELL, WRONG_MODEL, WRONG_COMMAND, INTERRUPTED, NO_READER = 0, 1, 2, 130, 141


def guarded(run: Callable[[], object], *, as_json: bool) -> int:
    """The exit status of `run`; with ACAUSAL_DEBUG=1 the tracebacks of internal errors are shown as well."""
    _prepare_streams()
    try:
        return _status(run, as_json)
    except KeyboardInterrupt:
        return INTERRUPTED
    except BrokenPipeError:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return NO_READER


def _prepare_streams() -> None:
    """Nothing that a model holds may fail to print; a stream that is closed (`>&-`) prints nowhere."""
    for name in ("stdout", "stderr"):
        stream = getattr(sys, name)
        if stream is None:
            setattr(sys, name, open(os.devnull, "w", encoding="utf-8"))  # noqa: SIM115
        elif isinstance(stream, TextIOWrapper):
            stream.reconfigure(errors="backslashreplace")


def _status(run: Callable[[], object], as_json: bool) -> int:
    status, problems = WELL, ()
    try:
        returned = run()
        status = returned if isinstance(returned, int) else WELL
    except AcausalError as error:
        status = WRONG_COMMAND if isinstance(error, UsageProblem) else WRONG_MODEL
        problems = error.diagnostics
    except typer.TyperException as error:
        status, problems = WRONG_COMMAND, (_usage(error),)
    except BrokenPipeError:
        raise
    except Exception as error:
        if os.environ.get("ACAUSAL_DEBUG") == "1":
            traceback.print_exc()
        status, problems = WRONG_MODEL, (_internal(error),)
    if problems:
        report(problems, as_json=as_json)
    sys.stdout.flush()
    return status


def report(problems: Sequence[Diagnostic], *, as_json: bool) -> None:
    """Errors as a JSON list on standard output, or as text on standard error."""
    if as_json:
        print_json([problem.to_json() for problem in problems])
    else:
        print_diagnostics(problems)


def _usage(error: typer.TyperException) -> Diagnostic:
    command = getattr(getattr(error, "ctx", None), "command_path", "acausal")
    return Diagnostic("usage.command-line", error.format_message(), hint=f"see `{command} --help`")


def _internal(error: Exception) -> Diagnostic:
    what = f"{type(error).__name__}: {error}" if str(error) else type(error).__name__
    return Diagnostic(
        "internal",
        f"internal error, {what.splitlines()[0]}",
        hint="this is a fault of acausal, not of the model: "
        "please report it with the model and the traceback that ACAUSAL_DEBUG=1 shows",
    )
