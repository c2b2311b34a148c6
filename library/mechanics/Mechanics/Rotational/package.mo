within Mechanics;
package Rotational "Rotation about fixed axes"
  annotation(Documentation(info = "<html>
<p>Shafts, gears and what couples them. Flange: angle <code>phi</code>, torque <code>tau</code>.</p>
</html>"));
end Rotational;
