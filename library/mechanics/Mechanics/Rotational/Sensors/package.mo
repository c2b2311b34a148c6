within Mechanics.Rotational;
package Sensors "Ideal measurement of motion and torque"
  annotation(Documentation(info = "<html>
<p>Sensors change nothing in the system they measure.</p>
</html>"));
end Sensors;
