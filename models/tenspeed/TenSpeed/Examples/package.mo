within TenSpeed;
package Examples "Models to run"
  annotation(Documentation(info = "<html>
<p>The kinematics in a fixed gear, and the main-regulator circuit with two supplies, the regulation circuit with another oil.</p>
</html>"));
end Examples;
