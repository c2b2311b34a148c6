"""Clutches in a row, as friction with a path parameter: they lock and break loose in one loop."""

from __future__ import annotations

from math import cos

import numpy as np
import pytest

import acausal

ROW = """model Row "Masses in a row with clutches between, which engage and release out of step"
  constant Integer n = 5;
  parameter Real J = 0.1, full = 10;
  Real w[n + 1](start = cat(1, {10}, zeros(n)), each fixed = true), a[n + 1], drive = 8*sin(8*time);
  Real tau[n], sa[n], rel[n], fn[n], since[n];
  Integer mode[n](each start = 2, each fixed = true) "1, -1: slips, 0: stuck, 2: free";
  Boolean free[n], locked[n], up[n](each start = false), down[n](each start = false);
equation
  der(w) = a;
  J*a[1] = drive - tau[1];
  for i in 2:n loop
    J*a[i] = tau[i - 1] - tau[i];
  end for;
  J*a[n + 1] = tau[n];
  for i in 1:n loop
    since[i] = time - 0.05*i - (if time < 0.05*i + 0.7 then 0 elseif time < 0.05*i + 1.4 then 0.7
      elseif time < 0.05*i + 2.1 then 1.4 else 2.1);
    fn[i] = full*(if since[i] < 0 then 0 elseif since[i] < 0.05 then since[i]/0.05
      elseif since[i] < 0.35 then 1 elseif since[i] < 0.4 then (0.4 - since[i])/0.05 else 0);
    rel[i] = w[i] - w[i + 1];
    free[i] = fn[i] <= 0;
    up[i] = pre(mode[i]) == 0 and sa[i] > fn[i] or initial() and rel[i] > 0;
    down[i] = pre(mode[i]) == 0 and sa[i] < -fn[i] or initial() and rel[i] < 0;
    locked[i] = not free[i] and not (pre(mode[i]) == 1 or up[i] or pre(mode[i]) == -1 or down[i]);
    a[i] - a[i + 1] = if locked[i] then 0 elseif free[i] then sa[i]
      elseif up[i] or pre(mode[i]) == 1 and not down[i] then sa[i] - fn[i] else sa[i] + fn[i];
    tau[i] = if locked[i] then sa[i] elseif free[i] then 0
      elseif up[i] or pre(mode[i]) == 1 and not down[i] then fn[i] else -fn[i];
    mode[i] = if free[i] then 2 elseif (pre(mode[i]) >= 1 or up[i]) and rel[i] > 0 then 1
      elseif (pre(mode[i]) == -1 or pre(mode[i]) == 2 or down[i]) and rel[i] < 0 then -1 else 0;
  end for;
  annotation(experiment(StopTime = 3));
end Row;"""


@pytest.mark.parametrize(
    ("count", "solver", "close"),
    [(5, "rodas", 2e-5), (5, "cvode", 2e-5), (10, "rodas", 2e-5), (10, "heun", 5e-4)],
)
def test_momentum_through_all_events(count: int, solver: str, close: float) -> None:
    """`sum(J*w)` is what the drive brought, while every clutch locks and is free.

    `close`: Heun's own error in the drive's integral at steps of 6 ms.
    """
    result = (
        acausal.loads(ROW.replace("n = 5", f"n = {count}"))
        .compile()
        .simulate(solver=solver, compiled=False, rtol=1e-7)
    )
    w = np.array([result.values(f"w[{i}]") for i in range(1, count + 2)])
    brought = 1.0 + (1 - np.array([cos(8 * t) for t in result.time.tolist()]))
    np.testing.assert_allclose(0.1 * w.sum(axis=0), brought, atol=close)
    assert 100 < result.statistics.events < 200
    for i in range(1, count + 1):
        mode, slip = result.values(f"mode[{i}]"), w[i - 1] - w[i]
        assert set(mode.tolist()) >= {0.0, 2.0}
        assert np.abs(slip[mode == 0]).max() < close
        assert np.abs(result.values(f"tau[{i}]")[mode == 2]).max() < 1e-12
