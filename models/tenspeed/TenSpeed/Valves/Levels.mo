within TenSpeed.Valves;
package Levels "The levels of every valve: choices of the replaceable parts of its one architecture"
  // Linear solenoid valve
  model LinearSolenoidL1 = LinearSolenoid "Everything: i, s, v, pressures of feedback and outlet";
  model LinearSolenoidL2 = LinearSolenoid(redeclare model Coil = ImpressedCoil) "Without the coil's current";
  model LinearSolenoidL3 = LinearSolenoid(
    redeclare model Coil = ImpressedCoil,
    redeclare model Stage = LinearStage(redeclare model SpoolModel = Hydraulics.Components.MasslessSpool))
    "Also without the spool's mass";
  model LinearSolenoidL4 = LinearSolenoid(
    redeclare model Coil = ImpressedCoil,
    redeclare model Stage = LinearStage(
      redeclare model SpoolModel = Hydraulics.Components.MasslessSpool,
      redeclare model Feedback = Hydraulics.Components.DirectFeedback))
    "Also without the feedback orifice: one volume of outlet and feedback";
  model LinearSolenoidL5 = LinearSolenoid(
    redeclare model Coil = ImpressedCoil,
    redeclare model Stage = LinearMap) "Map";
  // Shift solenoid valve
  model ShiftSolenoidL1 = ShiftSolenoid "Everything: i, s, v, pressure of the outlet";
  model ShiftSolenoidL2 = ShiftSolenoid(redeclare model Coil = ImpressedCoil) "Without the coil's current";
  model ShiftSolenoidL3 = ShiftSolenoid(
    redeclare model Coil = ImpressedCoil,
    redeclare model Stage = ShiftStage(redeclare model SpoolModel = Hydraulics.Components.MasslessSpool))
    "Also without the plunger's mass";
  model ShiftSolenoidL4 = ShiftSolenoid(
    redeclare model Coil = ImpressedCoil,
    redeclare model Stage = ShiftStage(
      redeclare model SpoolModel = Hydraulics.Components.StaticSpool,
      hasFlowForce = false)) "Displacement mapped from the current";
  model ShiftSolenoidL5 = ShiftSolenoid(
    redeclare model Coil = ImpressedCoil,
    redeclare model Stage = ShiftMap) "Map";
  annotation(Documentation(info = "<html>
<p>Only redeclarations, no equation.</p>
</html>"));
end Levels;
