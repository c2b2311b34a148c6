within Hydraulics.Components;
model SpoolChamber "Oil in front of a spool: its pressure pushes the spool, the spool's motion displaces it"
  extends Interfaces.PartialSpoolChamber;
equation
  // Displacement by the spool
  V = V_0 + orientation*A*flange.s;
  V_flow = orientation*A*der(flange.s);
  annotation(Documentation(info = "<html>
<p>d(rho V)/dt = rho q with V = V_0 &plusmn; A s; the spool receives &plusmn; A (p - p_behind). The work A p ds
taken from the oil is the work given to the spool.</p>
</html>"));
end SpoolChamber;
