within Mechanics.Translational;
package Sources "Prescribed forces and motions, algebraic functions of time"
  annotation(Documentation(info = "<html>
<p>No source adds a state. Each rises smoothly from a first to a last value; by default both are equal and the
source is constant.</p>
</html>"));
end Sources;
