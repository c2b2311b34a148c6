within TenSpeed.Gearbox;
block EnergyAccount "Integrals of the powers into and out of something, and what is missing in their balance"
  input Mechanics.Units.Power P_in "Power put in";
  input Mechanics.Units.Power P_out "Power given out";
  input Mechanics.Units.Power P_loss "Power lost";
  input Mechanics.Units.Energy E_stored "Energy stored";
  Mechanics.Units.Energy E_in(start = 0, fixed = true, nominal = 1e4) "Put in";
  Mechanics.Units.Energy E_out(start = 0, fixed = true, nominal = 1e4) "Given out";
  Mechanics.Units.Energy E_loss(start = 0, fixed = true, nominal = 1e4) "Lost";
  Mechanics.Units.Energy E_moved(start = 0, fixed = true, nominal = 1e4) "Put in or given back, as a measure of the rest";
  parameter Mechanics.Units.Energy E_0(fixed = false) "Stored at the start";
  output Mechanics.Units.Energy missing "Put in less given out, lost and stored";
  output Mechanics.Units.Ratio error "What is missing, relative to all that was moved, and at least 1 J";
initial equation
  E_0 = E_stored;
equation
  // Integrals
  der(E_in) = P_in;
  der(E_out) = P_out;
  der(E_loss) = P_loss;
  der(E_moved) = noEvent(abs(P_in));
  // Balance
  missing = E_in - E_out - E_loss - (E_stored - E_0);
  error = missing/(1 + E_moved);
  annotation(Documentation(info = "<html>
<p>E_in = E_out + E_loss + (E_stored - E_0). Four integrals: use it in models that extend a bench, whose own states it
does not change.</p>
</html>"));
end EnergyAccount;
