within TenSpeed;
package Examples "Models to run"
  annotation(Documentation(info = "<html>
<p>The kinematics in a fixed gear, and the main-regulator circuit with two supplies.</p>
</html>"));
end Examples;
