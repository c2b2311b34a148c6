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
  // Main regulator valve
  model MainRegulatorL1 = MainRegulator "Everything: s, v, pressures of line, feedback and pilot";
  model MainRegulatorL2 = MainRegulator(
    redeclare model Stage = MainStage(redeclare model Chamber = Hydraulics.Components.DecoupledChamber))
    "The spool displaces no oil";
  model MainRegulatorL3 = MainRegulator(
    redeclare model Stage = MainStage(
      redeclare model Chamber = Hydraulics.Components.DecoupledChamber,
      redeclare model SpoolModel = Hydraulics.Components.MasslessSpool)) "Also without the spool's mass";
  model MainRegulatorL4 = MainRegulator(
    redeclare model Stage = MainStage(
      redeclare model Chamber = Hydraulics.Components.DecoupledChamber,
      redeclare model SpoolModel = Hydraulics.Components.MasslessSpool,
      hasFlowForce = false)) "Also without flow forces";
  model MainRegulatorL5 = MainRegulator(redeclare model Stage = MainMap) "Map";
  // Lubrication regulator valve
  model LubricationRegulatorL1 = LubricationRegulator "Everything: s, v, pressures of line and feedback";
  model LubricationRegulatorL2 = LubricationRegulator(
    redeclare model Stage = LubricationStage(
      redeclare model Feedback = Hydraulics.Components.OrificeFeedback(
        redeclare model Chamber = Hydraulics.Components.DecoupledChamber))) "The spool displaces no oil";
  model LubricationRegulatorL3 = LubricationRegulator(
    redeclare model Stage = LubricationStage(
      redeclare model SpoolModel = Hydraulics.Components.MasslessSpool,
      redeclare model Feedback = Hydraulics.Components.OrificeFeedback(
        redeclare model Chamber = Hydraulics.Components.DecoupledChamber))) "Also without the spool's mass";
  model LubricationRegulatorL4 = LubricationRegulator(
    redeclare model Stage = LubricationStage(
      redeclare model SpoolModel = Hydraulics.Components.MasslessSpool,
      redeclare model Feedback = Hydraulics.Components.DirectFeedback(
        redeclare model Chamber = Hydraulics.Components.DecoupledChamber))) "Also without feedback orifices";
  model LubricationRegulatorL5 = LubricationRegulator(redeclare model Stage = LubricationMap) "Map";
  // Converter regulator valve
  model ConverterRegulatorL1 = ConverterRegulator "Everything: s, v, pressures of line and feedback";
  model ConverterRegulatorL2 = ConverterRegulator(
    redeclare model Stage = ConverterStage(
      redeclare model Feedback = Hydraulics.Components.OrificeFeedback(
        redeclare model Chamber = Hydraulics.Components.DecoupledChamber))) "The spool displaces no oil";
  model ConverterRegulatorL3 = ConverterRegulator(
    redeclare model Stage = ConverterStage(
      redeclare model SpoolModel = Hydraulics.Components.MasslessSpool,
      redeclare model Feedback = Hydraulics.Components.OrificeFeedback(
        redeclare model Chamber = Hydraulics.Components.DecoupledChamber))) "Also without the spool's mass";
  model ConverterRegulatorL4 = ConverterRegulator(
    redeclare model Stage = ConverterStage(
      redeclare model SpoolModel = Hydraulics.Components.MasslessSpool,
      redeclare model Feedback = Hydraulics.Components.DirectFeedback(
        redeclare model Chamber = Hydraulics.Components.DecoupledChamber))) "Also without feedback orifices";
  model ConverterRegulatorL5 = ConverterRegulator(redeclare model Stage = ConverterMap) "Map";
  // Line-pressure accumulator valve
  model LineAccumulatorL1 = LineAccumulator "Everything: s, v, pressure of the chamber";
  model LineAccumulatorL2 = LineAccumulator(
    redeclare model Stage = AccumulatorStage(redeclare model Chamber = Hydraulics.Components.DecoupledChamber))
    "The piston displaces no oil";
  model LineAccumulatorL3 = LineAccumulator(
    redeclare model Stage = AccumulatorStage(
      redeclare model Chamber = Hydraulics.Components.DecoupledChamber,
      redeclare model SpoolModel = Hydraulics.Components.MasslessSpool)) "Also without the piston's mass";
  model LineAccumulatorL4 = LineAccumulator(redeclare model Stage = AccumulatorVolume) "Volume only";
  // Lock-up control valve
  model LockupControlL1 = LockupControl "Everything: s, v, pressures of outlet, feedback and command";
  model LockupControlL2 = LockupControl(
    redeclare model Stage = LockupStage(
      redeclare model Feedback = Hydraulics.Components.OrificeFeedback(
        redeclare model Chamber = Hydraulics.Components.DecoupledChamber))) "The spool displaces no oil";
  model LockupControlL3 = LockupControl(
    redeclare model Stage = LockupStage(
      redeclare model SpoolModel = Hydraulics.Components.MasslessSpool,
      redeclare model Feedback = Hydraulics.Components.OrificeFeedback(
        redeclare model Chamber = Hydraulics.Components.DecoupledChamber))) "Also without the spool's mass";
  model LockupControlL4 = LockupControl(
    redeclare model Stage = LockupStage(
      redeclare model SpoolModel = Hydraulics.Components.MasslessSpool,
      redeclare model Feedback = Hydraulics.Components.DirectFeedback(
        redeclare model Chamber = Hydraulics.Components.DecoupledChamber))) "Also without feedback orifices";
  model LockupControlL5 = LockupControl(redeclare model Stage = LockupMap) "Map";
  // Switch valve
  model SwitchValveL1 = SwitchValve "Everything: s, v, pressure of the outlet";
  model SwitchValveL2 = SwitchValve(
    redeclare model Stage = SwitchStage(redeclare model Chamber = Hydraulics.Components.DecoupledChamber))
    "The spool displaces no oil";
  model SwitchValveL3 = SwitchValve(
    redeclare model Stage = SwitchStage(
      redeclare model Chamber = Hydraulics.Components.DecoupledChamber,
      redeclare model SpoolModel = Hydraulics.Components.MasslessSpool)) "Also without the spool's mass";
  model SwitchValveL4 = SwitchValve(
    redeclare model Stage = SwitchStage(
      redeclare model Chamber = Hydraulics.Components.DecoupledChamber,
      redeclare model SpoolModel = Hydraulics.Components.StaticSpool,
      hasFlowForce = false)) "Displacement mapped from the pressures";
  model SwitchValveL5 = SwitchValve(redeclare model Stage = SwitchMap) "Map";
  // Cut valve
  model CutValveL1 = CutValve "Everything: s, v, pressure of the outlet";
  model CutValveL2 = CutValve(
    redeclare model Stage = SwitchStage(redeclare model Chamber = Hydraulics.Components.DecoupledChamber))
    "The spool displaces no oil";
  model CutValveL3 = CutValve(
    redeclare model Stage = SwitchStage(
      redeclare model Chamber = Hydraulics.Components.DecoupledChamber,
      redeclare model SpoolModel = Hydraulics.Components.MasslessSpool)) "Also without the spool's mass";
  model CutValveL4 = CutValve(
    redeclare model Stage = SwitchStage(
      redeclare model Chamber = Hydraulics.Components.DecoupledChamber,
      redeclare model SpoolModel = Hydraulics.Components.StaticSpool,
      hasFlowForce = false),
    cut(each hasFlowForce = false)) "Displacement mapped from the pressures";
  model CutValveL5 = CutValve(redeclare model Stage = SwitchMap) "Map";
  // Two-way-clutch valve
  model TwoWayClutchValveL1 = TwoWayClutchValve "Everything: s, v, four chambers, two detents";
  model TwoWayClutchValveL2 = TwoWayClutchValve(
    redeclare model Stage = TwoWayClutchStage(redeclare model Chamber = Hydraulics.Components.DecoupledChamber))
    "The spool displaces no oil";
  model TwoWayClutchValveL3 = TwoWayClutchValve(redeclare model Stage = TwoWayClutchHysteresis)
    "First order, detents as hysteresis";
  model TwoWayClutchValveL4 = TwoWayClutchValve(redeclare model Stage = TwoWayClutchForce)
    "Mass and one net force, no detents";
  model TwoWayClutchValveL5 = TwoWayClutchValve(redeclare model Stage = TwoWayClutchMap) "Map";
  annotation(Documentation(info = "<html>
<p>Only redeclarations, no equation.</p>
</html>"));
end Levels;
