within Hydraulics;
package Sensors "What a signal needs to know of a line"
  annotation(Documentation(info = "<html>
<p>Sensors are ideal: no flow into them, no pressure lost, no delay.</p>
</html>"));
end Sensors;
