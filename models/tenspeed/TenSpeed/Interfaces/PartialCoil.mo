within TenSpeed.Interfaces;
partial model PartialCoil "Coil of a solenoid valve with what drives it"
  parameter Electrical.Units.Resistance R_nom = 5 "Nominal resistance, for which the command is meant";
  parameter Electrical.Units.Resistance R = R_nom "Resistance";
  parameter Electrical.Units.Inductance L = 0.01 "Inductance; nominal value of the study";
  parameter Mechanics.Units.Ratio backEmf = 1 "Factor on the induced voltage; nominal value of the study";
  parameter Electrical.Units.ForceConstant k_F "Force per current";
  parameter Electrical.Units.Current i_sat = 1e3 "Current at which iron saturates; default: practically linear";
  Signals.Interfaces.RealInput i_cmd(unit = "A") "Command";
  Electrical.Units.Current i "Current in the coil";
  Mechanics.Translational.Interfaces.Flange flange "Plunger";
  annotation(Documentation(info = "<html>
<p>What every level of a coil has in common.</p>
</html>"));
end PartialCoil;
