within TenSpeed.Interfaces;
partial model PartialSolenoidValve "Solenoid valve: a coil moves a hydraulic stage"
  extends PartialThreeWay;
  // Coil
  parameter Electrical.Units.Resistance R_nom = 5 "Nominal resistance, for which the command is meant";
  parameter Electrical.Units.Resistance R = R_nom "Resistance";
  parameter Electrical.Units.Inductance L = 0.01 "Inductance; nominal value of the study";
  parameter Mechanics.Units.Ratio backEmf = 1 "Factor on the induced voltage; nominal value of the study";
  parameter Electrical.Units.ForceConstant k_F "Force per current";
  // Spool
  parameter Mechanics.Units.Mass m "Mass of plunger and spool";
  parameter Mechanics.Units.TranslationalSpringConstant c "Stiffness of the spring";
  parameter Mechanics.Units.TranslationalDampingConstant d "Damping";
  parameter Mechanics.Units.Force F_preload "Force of the spring at position 0";
  parameter Hydraulics.Units.Volume V_outlet = 100e-6 "Volume of the outlet; nominal value of the study";
  Signals.Interfaces.RealInput i_cmd(unit = "A") "Command";
  Electrical.Units.Current i "Current in the coil";
  // Levels
  replaceable model Coil = Valves.DrivenCoil constrainedby PartialCoil "Level of the coil"
    annotation(choicesAllMatching = true);
  replaceable model Stage = Valves.LinearStage constrainedby PartialSolenoidStage "Level of the hydraulic part"
    annotation(choicesAllMatching = true);
  Coil coil(
    final R_nom = R_nom,
    final R = R,
    final L = L,
    final backEmf = backEmf,
    final k_F = k_F) "Coil";
  Stage stage(
    final fluid = fluid,
    final p_start = p_start,
    final m = m,
    final c = c,
    final d = d,
    final F_preload = F_preload,
    final k_F = k_F,
    final V_outlet = V_outlet) "Hydraulic part";
equation
  // Command
  connect(i_cmd, coil.i_cmd);
  i = coil.i;
  stage.i = i;
  connect(coil.flange, stage.flange);
  // Oil
  connect(supply, stage.supply);
  connect(drain, stage.drain);
  connect(outlet, stage.outlet);
  s = stage.s;
  m_oil = stage.m_oil;
  annotation(Documentation(info = "<html>
<p>The levels of coil and stage are chosen by redeclaration, see <code>Valves.Levels</code>.</p>
</html>"));
end PartialSolenoidValve;
