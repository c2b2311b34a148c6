within Hydraulics.Interfaces;
partial model PartialSpool "Spool with spring, preload and elastic end stops"
  parameter Mechanics.Units.Mass m "Mass of the spool and of what moves with it";
  parameter Mechanics.Units.TranslationalSpringConstant c "Stiffness of the spring";
  parameter Mechanics.Units.Force F_preload "Force of the spring at position 0, pushes towards negative position";
  parameter Units.Coefficient dampingRatio = 0.05
    "Damping of spool and spring alone, relative to critical; chosen: the study's nominal damping factor";
  parameter Mechanics.Units.TranslationalDampingConstant d = 2*dampingRatio*sqrt(c*m) "Damping";
  parameter Mechanics.Units.Position s_min = 0 "Position of the lower end stop";
  parameter Mechanics.Units.Position s_max "Position of the upper end stop";
  parameter Mechanics.Units.TranslationalSpringConstant c_stop = 1e6
    "Stiffness of the end stops; chosen: 1 kN/mm, a preloaded spool rests some hundredths of a millimetre deep";
  parameter Mechanics.Units.ContactDampingConstant b_stop = 1
    "Damping of the end stops relative to their elastic force; chosen: a spool that hits at 1 m/s rebounds at 0.6 m/s";
  parameter Mechanics.Units.Position s_start = 0 "Proposed initial position";
  Mechanics.Translational.Interfaces.Flange flange "Everything that acts on the spool";
  Mechanics.Units.Position s(start = s_start, nominal = 1e-3, stateSelect = StateSelect.prefer) "Position";
  Mechanics.Units.Force springForce "Force of the spring, positive pushes towards negative position";
  Mechanics.Units.Force stopForce "Force of both end stops, positive pushes towards positive position";
equation
  // One rigid spool
  s = flange.s;
  // Preloaded spring
  springForce = F_preload + c*s;
  annotation(Documentation(info = "<html>
<p>springForce = F_preload + c s. The extending model gives the law of motion and the force of the stops.</p>
</html>"));
end PartialSpool;
