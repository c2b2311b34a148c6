within TenSpeed.Interfaces;
partial model PartialMainStage "Level of the main regulator"
  extends PartialRegulatorStage;
  Hydraulics.Interfaces.Port line "Line, whose pressure the valve regulates";
  Hydraulics.Interfaces.Port pilot "Pilot pressure";
  Hydraulics.Interfaces.Port converter "Outlet that opens first, to the torque converter";
  Hydraulics.Interfaces.Port lubrication "Outlet that opens second, to lubrication";
  Hydraulics.Interfaces.Port suction "Outlet that opens last, back to the pump's inlet";
  annotation(Documentation(info = "<html>
<p>Ports of every level.</p>
</html>"));
end PartialMainStage;
