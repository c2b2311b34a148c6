"""The commands and their options. Nothing heavy is imported here, so that `--help` is quick."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Literal, TypeAlias

import typer

StageName: TypeAlias = Literal["ast", "instance", "flat", "causal", "code"]

EventsName: TypeAlias = Literal["locate", "step"]

TargetName: TypeAlias = Literal["c", "casadi"]

_Model = Annotated[
    str,
    typer.Argument(
        metavar="MODEL", help="A class by its dotted name on the library path, or FILE.mo (or .bmo)."
    ),
]
_Class = Annotated[
    str | None,
    typer.Option("--class", metavar="NAME", help="Which class of FILE.mo; the default is the last."),
]
_Parameters = Annotated[
    list[str] | None,
    typer.Option(
        "-p", "--parameter", metavar="NAME=VALUE", help="Modify the model; VALUE is Modelica. Repeatable."
    ),
]
_Path = Annotated[
    list[str] | None,
    typer.Option("--path", metavar="DIR", help="Search this folder for libraries first. Repeatable."),
]
_Json = Annotated[bool, typer.Option("--json", help="Print JSON, errors too.")]
_StopAfter = Annotated[StageName | None, typer.Option("--stop-after", help="Do not go on after this stage.")]
_Show = Annotated[
    StageName | None,
    typer.Option("--show", help="Print this stage, and stop there unless --stop-after says more."),
]
_Only = Annotated[
    list[str] | None,
    typer.Option("--only", metavar="NAME", help="Leave out what this variable does not need. Repeatable."),
]
_Seconds = typer.Option(metavar="SECONDS")

app = typer.Typer(
    add_completion=False,
    no_args_is_help=False,
    invoke_without_command=True,
    rich_markup_mode=None,
    pretty_exceptions_enable=False,
    context_settings={"help_option_names": ["-h", "--help"], "max_content_width": 100},
)


@app.callback()
def start(
    context: typer.Context,
    version: Annotated[bool, typer.Option("--version", help="Print the version.")] = False,
) -> None:
    """A Modelica compiler: check, compile, explain and simulate models."""
    from acausal import __version__

    if version:
        typer.echo(f"acausal {__version__}")
        raise typer.Exit
    if context.invoked_subcommand is None:
        typer.echo(context.get_help())
        raise typer.Exit(2)


@app.command(short_help="Look for mistakes in a model, or in all models of a package.")
def check(
    model: _Model,
    parameter: _Parameters = None,
    recursive: Annotated[
        bool, typer.Option("-r", "--recursive", help="Check all models of the package MODEL.")
    ] = False,
    examples: Annotated[
        bool, typer.Option("--examples", help="Of these, only those with an `experiment` annotation.")
    ] = False,
    timeout: Annotated[
        float | None, typer.Option(metavar="SECONDS", help="Most time for each (default 60).")
    ] = None,
    memory: Annotated[
        int | None, typer.Option(metavar="MB", help="Most memory for each (default 1024).")
    ] = None,
    jobs: Annotated[int | None, typer.Option(metavar="N", help="How many at once.")] = None,
    class_: _Class = None,
    path: _Path = None,
    json: _Json = False,
) -> None:
    """Look names up; check types, units and the balance of equations and unknowns.

    With --json: the list of all diagnostics, empty when there is nothing to say. With --recursive: a table
    of all models and blocks of a package that are not partial; they fail or pass one by one.
    """
    from acausal.cli.commands import Target, run_check

    target = Target(model, class_, tuple(path or ()), tuple(parameter or ()))
    if not (recursive or examples or any(setting is not None for setting in (timeout, memory, jobs))):
        run_check(target, as_json=json)
        return
    from acausal.cli.survey import Selection, run_survey

    selection = Selection(recursive, examples, timeout, memory, jobs)
    selection.verify()
    raise typer.Exit(run_survey(target, selection, as_json=json))


@app.command("compile", short_help="Say what a model becomes, or print a stage.")
def compile_(
    model: _Model,
    parameter: _Parameters = None,
    only: _Only = None,
    class_: _Class = None,
    path: _Path = None,
    stop_after: _StopAfter = None,
    show: _Show = None,
    json: _Json = False,
) -> None:
    """Compile, and say what the model has become: equations, aliases, index, states, blocks.

    With --show the text of a stage is printed instead; with --json it stands under the key `text`.
    """
    from acausal.cli.commands import Target, run_compile

    target = Target(model, class_, tuple(path or ()), tuple(parameter or ()), tuple(only or ()))
    run_compile(target, stop_after=stop_after, show=show, as_json=json)


@app.command(short_help="Say what happened to a model, and why.")
def explain(
    model: _Model,
    parameter: _Parameters = None,
    only: _Only = None,
    block: Annotated[
        int | None, typer.Option("--block", metavar="NUMBER", help="Explain this block only.")
    ] = None,
    latex: Annotated[bool, typer.Option("--latex", help="Its equations in LaTeX, too.")] = False,
    all_: Annotated[bool, typer.Option("--all", help="Do not cut long lists.")] = False,
    plot: Annotated[
        Path | None, typer.Option(metavar="FILE", help="Draw the incidence as PNG, SVG or PDF.")
    ] = None,
    html: Annotated[Path | None, typer.Option(metavar="FILE", help="Write one page with all of it.")] = None,
    initial: Annotated[
        bool, typer.Option("--initial", help="Solve the initial problem; say what starts where.")
    ] = False,
    class_: _Class = None,
    path: _Path = None,
    json: _Json = False,
) -> None:
    """Say which variables were eliminated, which equations differentiated, which states chosen over which.

    Then how the rest is solved: blocks in order, loops and their tearing, start values, zero crossings.
    """
    from acausal.cli.commands import Target
    from acausal.cli.explanation import Wish, run_explain

    target = Target(model, class_, tuple(path or ()), tuple(parameter or ()), tuple(only or ()))
    run_explain(target, Wish(block, latex, all_, plot, html, initial), as_json=json)


@app.command(short_help="Say which states hold the solver back.")
def profile(
    model: _Model,
    parameter: _Parameters = None,
    stop_time: Annotated[float | None, typer.Option(metavar="SECONDS", help="When to stop.")] = None,
    rtol: Annotated[float | None, typer.Option(metavar="R", help="Relative tolerance.")] = None,
    plot: Annotated[Path | None, typer.Option(metavar="FILE", help="Draw a PNG, SVG or PDF.")] = None,
    class_: _Class = None,
    path: _Path = None,
    json: _Json = False,
) -> None:
    """Run a model with variable steps, and say whose error set their size.

    With --json: a list of `state`, `influence` (share of all), `error_failures`, `convergence_failures`.
    """
    from acausal.cli.commands import Target
    from acausal.cli.profile import Profiling, run_profile

    target = Target(model, class_, tuple(path or ()), tuple(parameter or ()))
    run_profile(target, Profiling(stop_time, rtol, plot), as_json=json)


@app.command(short_help="Run a model; write and draw results.")
def simulate(
    model: _Model,
    parameter: _Parameters = None,
    only: _Only = None,
    stop_time: Annotated[float | None, typer.Option(metavar="SECONDS", help="When to stop.")] = None,
    solver: Annotated[
        str, typer.Option(metavar="NAME", help="How to integrate: auto, or a name from docs/solvers.md.")
    ] = "auto",
    step: Annotated[
        float | None, typer.Option(metavar="SECONDS", help="Length of fixed steps; default: --interval.")
    ] = None,
    events: Annotated[
        EventsName, typer.Option(help="Fixed steps: find crossings inside a step, or only at its end.")
    ] = "locate",
    rtol: Annotated[float | None, typer.Option(metavar="R", help="Relative tolerance.")] = None,
    atol: Annotated[
        float | None, typer.Option(metavar="A", help="Absolute one, times nominal values.")
    ] = None,
    max_step: Annotated[float | None, typer.Option(metavar="SECONDS", help="Longest step.")] = None,
    interval: Annotated[float | None, typer.Option(metavar="SECONDS", help="Between output points.")] = None,
    variable: Annotated[
        list[str] | None,
        typer.Option("-v", "--variable", metavar="NAME", help="Keep this variable. Repeatable."),
    ] = None,
    all_: Annotated[bool, typer.Option("--all", help="Keep every variable.")] = False,
    output: Annotated[
        Path | None,
        typer.Option("-o", "--output", metavar="FILE", help="Write .csv, .mat, .nc or .parquet."),
    ] = None,
    continue_: Annotated[
        Path | None,
        typer.Option("--continue", metavar="FILE", help="Go on where the run that wrote FILE ended."),
    ] = None,
    plot: Annotated[Path | None, typer.Option(metavar="FILE", help="Draw a PNG, SVG or PDF.")] = None,
    class_: _Class = None,
    path: _Path = None,
    json: _Json = False,
) -> None:
    """Compile and run. Stop time, tolerance and interval come from the model's `experiment` annotation.

    Without -v the variables of --only are kept, else the states and the variables of the top level.
    """
    from acausal.cli.commands import Target
    from acausal.cli.simulation import Run, run_simulate

    target = Target(model, class_, tuple(path or ()), tuple(parameter or ()), tuple(only or ()))
    settings = Run(
        stop_time,
        solver,
        rtol,
        atol,
        max_step,
        interval,
        tuple(variable or only or ()),
        all_,
        output,
        plot,
        step=step,
        events=events,
        after=continue_,
    )
    run_simulate(target, settings, as_json=json)


@app.command(short_help="Write a model as C or as CasADi functions.")
def export(
    model: _Model,
    to: Annotated[TargetName, typer.Option("--to", help="What to write.")] = "c",
    output: Annotated[
        Path | None, typer.Option("-o", "--output", metavar="PATH", help="Folder (c) or file (casadi).")
    ] = None,
    parameter: _Parameters = None,
    only: _Only = None,
    name: Annotated[
        str | None, typer.Option(metavar="NAME", help="What the C is called; default: the model's name.")
    ] = None,
    solver: Annotated[
        str, typer.Option(metavar="NAME", help="One with fixed steps, see docs/solvers.md.")
    ] = "heun",
    step: Annotated[
        float | None, typer.Option(metavar="SECONDS", help="Length of steps; default: --interval.")
    ] = None,
    stop_time: Annotated[float | None, typer.Option(metavar="SECONDS", help="When to stop.")] = None,
    interval: Annotated[float | None, typer.Option(metavar="SECONDS", help="Between output points.")] = None,
    events: Annotated[
        EventsName, typer.Option(help="Find crossings inside a step, or only at its end.")
    ] = "locate",
    tunable: Annotated[
        list[str] | None,
        typer.Option(metavar="NAME", help="Parameters, start(x), or all; default: the top level's."),
    ] = None,
    variable: Annotated[
        list[str] | None, typer.Option("-v", "--variable", metavar="NAME", help="An output. Repeatable.")
    ] = None,
    all_: Annotated[bool, typer.Option("--all", help="Every variable is an output.")] = False,
    class_: _Class = None,
    path: _Path = None,
    json: _Json = False,
) -> None:
    """Write a package of C99 with a program that runs it, or serialised CasADi functions.

    Settings of the run are defaults of the program. With --json: names, sizes and files.
    """
    from acausal.cli.commands import Target
    from acausal.cli.exporting import Wish, run_export

    target = Target(model, class_, tuple(path or ()), tuple(parameter or ()), tuple(only or ()))
    outputs = tuple(variable or only or ())
    wish = Wish(
        to, output, name, solver, step, stop_time, interval, events, tuple(tunable or ()), outputs, all_
    )
    run_export(target, wish, as_json=json)


@app.command(short_help="Read figures off a stored result.")
def metrics(
    result: Annotated[
        Path, typer.Argument(metavar="RESULT", help="A file that `acausal simulate -o` wrote.")
    ],
    kind: Annotated[
        str, typer.Option(metavar="KIND", help="What to measure: shift, converter, engagement.")
    ] = "shift",
    reference: Annotated[
        Path | None, typer.Option(metavar="FILE", help="Another sweep that a converter's is compared with.")
    ] = None,
    stop: Annotated[
        float | None, typer.Option(metavar="S", help="Where the piston has reached its stop, in m.")
    ] = None,
    start: Annotated[
        float | None, typer.Option("--from", metavar="T", help="Start of an engagement's window, in s.")
    ] = None,
    end: Annotated[float | None, typer.Option("--to", metavar="T", help="Its end, in s.")] = None,
    plot: Annotated[
        Path | None, typer.Option(metavar="FILE", help="Draw what was measured as PNG, SVG or PDF.")
    ] = None,
    json: _Json = False,
) -> None:
    """Measure gear shifts, a torque converter's sweep, or clutch pressures.

    shift: needs `gear`, `outputTorque`, and `slip_X` and `torque_X` of every friction element X.
    converter: needs `speedRatio`, `torqueRatio`, `capacityFactor`.
    engagement: needs `current` and `pressure`, or `current_X` and `pressure_X`; takes `position` too.
    """
    from acausal.cli.metrics import Options, run_metrics

    run_metrics(result, kind, Options(reference, stop, start, end, plot), as_json=json)


@app.command(short_help="Linearise a model: eigenvalues, modes, step limits.")
def eigen(
    model: _Model,
    parameter: _Parameters = None,
    at: Annotated[
        list[str] | None,
        typer.Option(
            "--at", metavar="T[,T...]", help="Seconds, `initial` (default), `steady` or `steady@T`."
        ),
    ] = None,
    result: Annotated[
        Path | None,
        typer.Option(metavar="FILE.csv", help="Take the instants from this stored result of MODEL."),
    ] = None,
    compare: Annotated[
        str | None, typer.Option(metavar="MODEL2", help="Pair the modes with those of another model.")
    ] = None,
    sweep: Annotated[
        str | None, typer.Option(metavar="NAME=A:B:N", help="Follow the roots over a parameter.")
    ] = None,
    variants: Annotated[
        Path | None, typer.Option(metavar="FILE.csv", help="A row of parameters for each variant.")
    ] = None,
    plot: Annotated[
        Path | None, typer.Option(metavar="FILE", help="Draw the complex plane: PNG, SVG, PDF or HTML.")
    ] = None,
    mode: Annotated[
        int | None, typer.Option("--mode", metavar="K", help="Draw the shape of mode K instead.")
    ] = None,
    animate_mode: Annotated[
        int | None, typer.Option("--animate-mode", metavar="K", help="Draw mode K moving: GIF or HTML.")
    ] = None,
    all_: Annotated[bool, typer.Option("--all", help="Do not cut long tables.")] = False,
    class_: _Class = None,
    path: _Path = None,
    json: _Json = False,
) -> None:
    """Take snapshots: the model near an instant, with everything discrete frozen as it is there.

    For each: eigenvalues with frequency, damping and participating states, and the longest stable steps. With
    --json: an object, or for several instants a list of them.
    """
    from acausal.cli.commands import Target
    from acausal.cli.eigen import Request, run_eigen

    target = Target(model, class_, tuple(path or ()), tuple(parameter or ()))
    instants = tuple(at or ("initial",))
    request = Request(instants, all_, result, compare, sweep, variants, plot, mode, animate_mode)
    run_eigen(target, request, as_json=json)
