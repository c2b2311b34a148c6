within TenSpeed.Valves;
model ShiftSolenoid "Shift solenoid valve: fills its outlet with current, drains it without"
  extends Interfaces.PartialSolenoidValve(
    k_F = 8,
    m = 20e-3,
    c = 500,
    d = 2.25,
    F_preload = 2,
    V_outlet = 20e-6,
    redeclare replaceable model Stage = ShiftStage);
  annotation(Documentation(info = "<html>
<p>The plunger leaves its seat at 0.25 A and is at its stop from 0.44 A on. k_F: chosen, lifts the plunger with twice the
force of the spring at 1 A. V_outlet: chosen, a drilling to the spool that it moves. The others: nominal values of the
study.</p>
</html>"));
end ShiftSolenoid;
