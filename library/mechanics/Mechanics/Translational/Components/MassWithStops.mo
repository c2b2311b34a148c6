within Mechanics.Translational.Components;
model MassWithStops "Rigid body between rigid end stops, with restitution"
  extends Interfaces.PartialTwoFlanges;
  parameter Units.Mass m "Mass";
  parameter Units.Position s_min "Position of the lower stop";
  parameter Units.Position s_max "Position of the upper stop";
  parameter Units.Ratio e(min = 0, max = 1) = 0 "Coefficient of restitution; 0: it stays where it hits";
  parameter Units.Velocity v_rest(min = 0) = 1e-3 "Speed of rebound below which it comes to rest; chosen: below any stroke's";
  Units.Position s(start = 0) "Position";
  Units.Velocity v(start = 0, stateSelect = StateSelect.always) "Velocity";
  Units.Acceleration a "Acceleration";
  Units.Force f "Sum of the forces at the flanges";
  Units.Force stopForce "Force of the stop on which it rests, positive pushes forward";
  Integer at(start = 0, fixed = true) "1 rests at the upper stop, -1 at the lower one, 0 moves";
  Boolean pulled "A force pulls the resting body away from its stop";
equation
  assert(s_min < s_max, "the lower stop must lie below the upper one");
  // One body: both ends move together
  flange_a.s = s;
  flange_b.s = s;
  // Motion
  v = der(s);
  a = der(v);
  // Newton's law, or rest
  f = flange_a.f + flange_b.f;
  a = if at == 0 then f/m else 0;
  stopForce = m*a - f;
  // Impact: v' = -e v; what would rebound too slowly stays, until a force pulls it away
  pulled = pre(at) == 1 and f < 0 or pre(at) == -1 and f > 0;
  when s >= s_max then
    at = if e*pre(v) <= v_rest then 1 else 0;
    reinit(v, if e*pre(v) <= v_rest then 0 else -e*pre(v));
  elsewhen s <= s_min then
    at = if -e*pre(v) <= v_rest then -1 else 0;
    reinit(v, if -e*pre(v) <= v_rest then 0 else -e*pre(v));
  elsewhen pulled then
    at = 0;
  end when;
  annotation(Documentation(info = "<html>
<p>Newton's law of impact, v' = -e v, at s_min and s_max. A rebound slower than v_rest is none: the body rests, and the
stop takes the force, until the force at the flanges pulls it away. So there are finitely many impacts.</p>
</html>"));
end MassWithStops;
