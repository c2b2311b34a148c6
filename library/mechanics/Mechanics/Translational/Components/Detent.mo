within Mechanics.Translational.Components;
model Detent "Ball on a spring that snaps into the notches of a rod"
  extends Interfaces.PartialOneFlange;
  parameter Units.Length pitch(min = 1e-9) = 5e-3 "Distance of the notches; chosen: of a valve spool";
  parameter Units.Length depth(min = 0) = 1e-3 "Depth of the notches; chosen: a fifth of the pitch";
  parameter Units.TranslationalSpringConstant c = 5e3 "Stiffness of the spring; chosen: doubles the force over a notch";
  parameter Units.Force F_0 = 5 "Force of the spring in a notch; chosen: of a valve spool";
  parameter Units.Position s_0 = 0 "Position of a notch";
  Units.Position s(start = 0) "Position of the rod";
  Units.Length h "Height of the ball above the notch";
  Units.Ratio slope "Slope of the profile under the ball";
  Units.Force f "Force on the rod";
  Units.Energy storedEnergy "Energy of the spring beyond that in a notch";
protected
  Real angle(unit = "rad") "Position on the profile";
equation
  s = flange.s;
  // Profile: a cosine
  angle = 2*Constants.pi*(s - s_0)/pitch;
  h = depth/2*(1 - cos(angle));
  slope = Constants.pi*depth/pitch*sin(angle);
  // The ball pushes the rod down the slope
  f = -(F_0 + c*h)*slope;
  flange.f = -f;
  // Energy
  storedEnergy = F_0*h + c*h^2/2;
  annotation(Documentation(info = "<html>
<p>h = depth/2 (1 - cos(2 pi (s - s_0)/pitch)) is the height of the ball above a notch, f = -(F_0 + c h) dh/ds its force
along the rod: that of the energy F_0 h + c h<sup>2</sup>/2, without friction. Add a damper for the losses.</p>
</html>"));
end Detent;
