within TenSpeed.Benches;
model GearboxL4Energy "Shift sweep of the gearbox at level 4 with its energy balance"
  extends GearboxL4;
  Gearbox.EnergyAccount account(
    P_in = inputPower,
    P_out = outputPower,
    P_loss = gearbox.lossPower,
    E_stored = gearbox.storedEnergy) "Energies";
  annotation(
    experiment(StopTime = 50, Tolerance = 1e-6, Interval = 1e-3),
    Documentation(info = "<html>
<p>The integrals are states of this model, not of the bench that it extends.</p>
</html>"));
end GearboxL4Energy;
