package Mechanics "One-dimensional rotation and translation"
  annotation(
    version = "0.1.0",
    uses(Signals(version = "0.1.0")),
    Documentation(info = "<html>
<p>Rotational and translational components with two connectors: <code>Rotational.Interfaces.Flange</code>
(angle <code>phi</code>, torque <code>tau</code>) and <code>Translational.Interfaces.Flange</code> (position
<code>s</code>, force <code>f</code>). Variable names and signs are those of the Modelica Standard Library, so
flanges of both libraries can be connected.</p>
<p>Forces and torques count positive into a component. No component fixes an initial value: <code>start</code>
is a proposal that a source, a constraint or the user may override.</p>
</html>"));
end Mechanics;
