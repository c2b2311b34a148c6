within Hydraulics.Functions;
function restPosition "Where a spool rests without pressure"
  input Mechanics.Units.Force F_preload "Force of the spring at position 0, pushes towards negative position";
  input Mechanics.Units.TranslationalSpringConstant c "Stiffness of the spring";
  input Mechanics.Units.TranslationalSpringConstant c_stop "Stiffness of the end stops";
  input Mechanics.Units.Position s_min "Position of the lower end stop";
  input Mechanics.Units.Position s_max "Position of the upper end stop";
  output Mechanics.Units.Position s "Position";
algorithm
  s := if F_preload + c*s_min > 0 then s_min - (F_preload + c*s_min)/(c + c_stop)
    elseif F_preload + c*s_max < 0 then s_max - (F_preload + c*s_max)/(c + c_stop)
    else -F_preload/max(c, 1e-9*c_stop);
  annotation(
    Inline = true,
    Documentation(info = "<html>
<p>0 = F_preload + c s - stopForce(s), solved for s.</p>
</html>"));
end restPosition;
