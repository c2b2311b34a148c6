within Electrical.Examples;
model CurrentMakesForce "A current source feeds a coil whose plunger leans on a spring"
  Signals.Sources.SmoothSteps command(times = {0.1}, values = {0, 1}, duration = 0.5) "Current";
  Sources.SignalCurrent source "Source";
  Components.ForceConverter converter(k_F = 20) "Coil and plunger";
  Components.Ground ground "Ground";
  Mechanics.Translational.Components.SpringDamper spring(c = 1e4, d = 100) "Spring";
  Mechanics.Translational.Components.Fixed wall "Wall";
  output Mechanics.Units.Power error "Difference of electric and mechanical power";
equation
  connect(command.y, source.i);
  connect(source.p, converter.p);
  connect(converter.n, source.n);
  connect(source.n, ground.p);
  connect(converter.flange, spring.flange_a);
  connect(spring.flange_b, wall.flange);
  // Without saturation the converter conserves energy
  error = converter.v*converter.i + converter.flange.f*der(converter.flange.s);
  annotation(
    experiment(StopTime = 1, Tolerance = 1e-8),
    Documentation(info = "<html>
<p>v i = f ds/dt.</p>
</html>"));
end CurrentMakesForce;
