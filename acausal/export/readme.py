"""The text that goes with an exported package."""

from __future__ import annotations

from acausal.export.names import comment
from acausal.export.plan import Plan


def readme(plan: Plan, name: str) -> str:
    """What the package is, how to build and run it, and how to call it from C."""
    system, options = plan.code.system, plan.options
    return f"""# {comment(system.flat.name)}

A model in C99, made by `acausal export`. It needs a C compiler and nothing else.

    make
    ./{name} -p table.csv -r results.csv -o rows.csv

or in one line: `cc -std=c99 -O2 -ffp-contract=off -I. -Iruntime *.c runtime/*.c -o {name} -lm`.

- {len(system.states)} states, {len(system.flat.inputs)} inputs, {len(plan.outputs.names)} outputs,
  {len(plan.tunables)} tunable parameters: `./{name} --list` names them, `{name}.h` gives their indices.
- `{options.solver}` with steps of {options.step:g} s from {options.start_time:g} to {options.stop_time:g} s;
  `--step`, `--solver`, `--start`, `--stop`, `--interval` and `--events` change that.
- `table.csv` has one variant in each row; its header names tunable parameters. A row that fails has its
  message in the results; the others are run all the same, and the program returns 1.

From C:

    static {name}_instance model;               /* all memory: there is no heap */
    ac_settings settings;
    {name}_create(&model);
    ac_defaults(&{name}_plan, &settings);
    ac_set(&model.run, index, value);           /* a tunable parameter, by {name}_TUNABLE_... */
    settings.row = row;                         /* takes the outputs at every output time */
    if (ac_start(&model.run, &settings) != 0 || ac_go(&model.run) < 0) puts(model.run.message);

`{name}.c` holds the model, `runtime/` what all models share, `main.c` and `csv.c` the program.
"""
