within TenSpeed.Valves;
model LockupControl "Lock-up control valve: clutch pressure follows the pressure of its solenoid"
  extends Interfaces.PartialThreeWay;
  extends Interfaces.PartialRegulator;
  Hydraulics.Interfaces.Port command "Pressure of the lock-up solenoid";
  Hydraulics.Units.MassFlowRate m_command "Mass flow in from the solenoid";
  replaceable model Stage = LockupStage constrainedby Interfaces.PartialLockupStage "Level of the valve"
    annotation(choicesAllMatching = true);
  Stage stage(
    final fluid = fluid,
    final p_start = p_start,
    final m = m,
    final d = d) "Spool, or what stands for it";
equation
  connect(supply, stage.supply);
  connect(drain, stage.drain);
  connect(outlet, stage.outlet);
  connect(command, stage.command);
  s = stage.s;
  m_oil = stage.m_oil;
  m_command = Hydraulics.Media.density(command.p, fluid)*command.q;
  annotation(Documentation(info = "<html>
<p>d m_oil/dt = m_supply + m_command - m_drain - m_outlet.</p>
</html>"));
end LockupControl;
