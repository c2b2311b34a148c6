within Hydraulics.Components;
model StaticSpool "Spool that is always at its balance of forces"
  extends Interfaces.PartialSpool(s(stateSelect = StateSelect.default));
protected
  Mechanics.Units.Position free "Position without end stops";
  final parameter Real share(final unit = "1") = c_stop/(c + c_stop) "Of the stops in the stiffness at a stop";
equation
  // Balance of spring and applied force, then shortened at the stops
  free = (flange.f - F_preload)/c;
  s = smooth(0, noEvent(
    if free > s_max then free - share*(free - s_max)
    elseif free < s_min then free + share*(s_min - free)
    else free));
  // Elastic end stops
  stopForce = Mechanics.Functions.contactForce(s_min - s, 0, c_stop, 0)
    - Mechanics.Functions.contactForce(s - s_max, 0, c_stop, 0);
  annotation(Documentation(info = "<html>
<p>0 = f - (F_preload + c s) + stopForce, solved for s: the position at which <code>Spool</code> comes to rest. It has no
state and is explicit where f does not depend on s.</p>
</html>"));
end StaticSpool;
