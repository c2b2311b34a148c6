within Mechanics.Translational;
package Sensors "Ideal measurement of motion and force"
  annotation(Documentation(info = "<html>
<p>Sensors change nothing in the system they measure.</p>
</html>"));
end Sensors;
