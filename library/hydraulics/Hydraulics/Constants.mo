within Hydraulics;
package Constants "Mathematical constants and reference conditions"
  constant Real pi(final unit = "1") = 3.141592653589793 "Ratio of circumference to diameter";
  constant Units.AbsolutePressure p_atmosphere = 101325 "Standard atmosphere";
  annotation(Documentation(info = "<html>
<p>The standard atmosphere is exactly 101325 Pa by definition.</p>
</html>"));
end Constants;
