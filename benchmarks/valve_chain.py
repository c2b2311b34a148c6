"""A stiff chain of relief valves with three states each as Modelica text; by hand: `c/valve_chain.h`."""

from __future__ import annotations

VALVES = 46
NAME = "ValveChain"

TEXT = """
model ValveChain "Relief valves in a row behind a supply whose pressure swings"
  parameter Integer n = {valves} "Valves";
  parameter Real K(unit = "Pa") = 1.2e9 "Bulk modulus";
  parameter Real V(unit = "m3") = 2e-5 "Volume in front of each valve";
  parameter Real A(unit = "m2") = 1e-4 "Area of each spool";
  parameter Real m(unit = "kg") = 0.02 "Mass of each spool";
  parameter Real c(unit = "N/m") = 8e3 "Stiffness of each spring";
  parameter Real d(unit = "N.s/m") = 12 "Damping of each spool";
  parameter Real F(unit = "N") = 2 "Preload of each spring";
  parameter Real C(unit = "m2.kg-0.5.m-0.5") = 2.5e-4 "Flow through an opening of 1 m at 1 Pa";
  parameter Real D(unit = "Pa") = 1e4 "Pressure difference below which the flow is laminar";
  parameter Real e(unit = "m") = 2e-5 "Rounding of the edge";
  parameter Real h_in(unit = "m") = 1e-3 "Opening of the inlet";
  parameter Real p_mean(unit = "Pa") = 20e5 "Supply";
  parameter Real p_swing(unit = "Pa") = 5e5 "Its amplitude";
  parameter Real w(unit = "rad/s") = 12.566370614359172 "Its angular frequency";
  Real p[n](each start = 0, each fixed = true, each nominal = 1e5) "Pressures";
  Real s[n](each start = 0, each fixed = true, each nominal = 1e-3) "Positions of the spools";
  Real v[n](each start = 0, each fixed = true, each nominal = 0.1) "Their velocities";
  Real q[n + 1] "Flows";
  Real dp[n + 1] "Pressure differences";
equation
  dp[1] = p_mean + p_swing*sin(w*time) - p[1];
  q[1] = C*h_in*dp[1]/sqrt(sqrt(dp[1]^2 + D^2));
  for i in 1:n loop
    dp[i + 1] = if i < n then p[i] - p[min(i + 1, n)] else p[i];
    q[i + 1] = C*(s[i] + sqrt(s[i]^2 + e^2))/2*dp[i + 1]/sqrt(sqrt(dp[i + 1]^2 + D^2));
    der(p[i]) = K/V*(q[i] + (if i > 1 then A*v[max(i - 1, 1)] else 0) - q[i + 1] - A*v[i]);
    der(s[i]) = v[i];
    der(v[i]) = (A*dp[i + 1] - c*s[i] - d*v[i] - F)/m;
  end for;
  annotation(experiment(StopTime = 5, Tolerance = 1e-6));
end ValveChain;
"""


def valve_chain(valves: int = VALVES) -> str:
    """The model of `valves` valves: three times as many states."""
    return TEXT.replace("{valves}", str(valves))
