within TenSpeed.Examples;
model RegulationCircuitMineralOil "Regulation circuit with another oil in every part"
  extends Interfaces.RegulationCircuit(redeclare package Oil = Hydraulics.Media.OilMineralVG32);
  Real error(unit = "1") "Mass that does not balance over mass that has flowed in";
protected
  Mechanics.Units.Mass delivered(start = 0, fixed = true) "Mass that has flowed in";
  Mechanics.Units.Mass returned(start = 0, fixed = true) "Mass that has flowed out";
  parameter Mechanics.Units.Mass m_0(fixed = false) "Mass at the start";
initial equation
  m_0 = m_oil;
equation
  der(delivered) = inflow;
  der(returned) = outflow;
  error = (m_oil - m_0 - delivered + returned)/(1e-3 + delivered);
  assert(abs(error) < 1e-5, "mass must be conserved");
  annotation(
    experiment(StopTime = 2.5, Tolerance = 1e-8, Interval = 1e-3),
    Documentation(info = "<html>
<p>One redeclaration at the top: valves, lines and loads take their data from it. The mineral oil has less air and more
viscosity: the line follows more stiffly and ends within 1 % of the pressure that it has with the transmission's oil.</p>
</html>"));
end RegulationCircuitMineralOil;
