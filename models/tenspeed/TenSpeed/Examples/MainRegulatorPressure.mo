within TenSpeed.Examples;
model MainRegulatorPressure "Main-regulator circuit at a constant line pressure: four states"
  extends Interfaces.MainRegulatorCircuit;
  Hydraulics.Sources.PressureSource supply(p_start = 10e5) "Line pressure; chosen: near what the valve regulates";
equation
  // Supply
  connect(supply.port, line.port[1]);
  annotation(
    experiment(StopTime = 1, Tolerance = 1e-6),
    Documentation(info = "<html>
<p>The line pressure is prescribed; index reduction removes its state and the source delivers what the valve
takes.</p>
</html>"));
end MainRegulatorPressure;
