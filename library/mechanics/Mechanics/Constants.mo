within Mechanics;
package Constants "Numbers of mathematics"
  constant Real pi(final unit = "1") = 3.141592653589793 "Circumference of a circle over its diameter";
  annotation(Documentation(info = "<html>
<p>Rounded to double precision.</p>
</html>"));
end Constants;
