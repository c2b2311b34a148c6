within TenSpeed.Converter;
partial model PartialDynamicStator "Circuit whose stator has an inertia and a one-way clutch"
  extends PartialCircuit;
  Boolean held(start = true, fixed = true) "Whether the one-way clutch holds the stator";
  Mechanics.Units.AngularAcceleration a_s "Acceleration of the stator";
protected
  constant Mechanics.Units.Torque unitTorque = 1 "Makes a torque of a number";
  constant Mechanics.Units.AngularAcceleration unitAcceleration = 1 "Makes an acceleration of a number";
  constant Mechanics.Units.Ratio small = 1e-6 "What counts as zero";
  Mechanics.Units.Ratio path "Torque of a held stator, or acceleration of a free one, counted backward";
  Mechanics.Units.Ratio holding "Negative where a held stator is released";
  Mechanics.Units.AngularVelocity running "Negative where a free stator is caught";
equation
  // One-way clutch: holds until its torque would turn negative, and again when the stator would turn backward
  a_s = der(w_s);
  a_s = if held then 0 else -path*unitAcceleration;
  tau_s = if held then path*unitTorque else 0;
  holding = if pre(held) then path + small else 1;
  running = if pre(held) then 1 else w_s;
  held = if pre(held) then not holding < 0 else running < 0;
  when {held, not held} then
    reinit(w_s, 0);
  end when;
  annotation(Documentation(info = "<html>
<p>A held stator has w_s = 0 and takes whatever torque holds it; a free one takes none. Release and catch are events;
torque and speed are continuous there.</p>
</html>"));
end PartialDynamicStator;
