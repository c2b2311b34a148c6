within TenSpeed.Valves;
model LinearSolenoid "Linear solenoid valve: outlet pressure proportional to current"
  extends Interfaces.PartialSolenoidValve(
    k_F = 30,
    m = 5e-3,
    c = 15e3,
    d = 15,
    F_preload = 1,
    redeclare replaceable model Stage = LinearStage);
  annotation(Documentation(info = "<html>
<p>Current pushes the spool open, outlet pressure on the feedback land pushes it shut: A_feedback (p_outlet - p_0) =
k_F i at the position where the spring has no force. k_F: chosen, a strong coil for its 5 W; with the feedback land 9.4 bar
per ampere. Mass,
stiffness, damping, preload and volume: nominal values of the study.</p>
</html>"));
end LinearSolenoid;
