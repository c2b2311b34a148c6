within Hydraulics.Components;
model GasAccumulator "Accumulator with a gas behind a bladder"
  extends Interfaces.PartialVolume;
  parameter Units.Volume V_0 "Volume of the gas before filling";
  parameter Units.AbsolutePressure p_0 "Pressure of the gas before filling";
  parameter Units.Volume V_dead(min = 1e-12) = 0.02*V_0 "Oil in an empty accumulator; chosen: the shell's fitting";
  parameter Units.Coefficient n = 1.4 "Polytropic exponent: 1 slow, 1.4 fast filling with nitrogen";
  Interfaces.Port port "Port";
  Units.Volume V_gas "Volume of the gas";
protected
  Units.AbsolutePressure p_gas "Pressure of the gas: that of the oil, or p_0 where the bladder rests on its seat";
equation
  // Polytropic gas
  p_gas = smooth(0, noEvent(max(p, p_0)));
  V_gas = V_0*(p_0/p_gas)^(1/n);
  // Oil fills the rest
  V = V_dead + V_0 - V_gas;
  V_flow = noEvent(if p > p_0 then V_gas/(n*p_gas)*der(p) else 0);
  // Flow through the port
  port.p = p;
  m_flow = rho*port.q;
  annotation(Documentation(info = "<html>
<p>p V_gas<sup>n</sup> = p_0 V_0<sup>n</sup> for p &gt; p_0; below, the bladder rests on its seat and only V_dead holds
oil. One state, the pressure.</p>
</html>"));
end GasAccumulator;
