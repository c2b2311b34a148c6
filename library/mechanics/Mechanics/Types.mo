within Mechanics;
package Types "Choices"
  type StickLaw = enumeration(
    elastic "Spring and damper up to the capacity",
    rigid "Both sides turn as one up to the capacity",
    karnopp "Rigid within a dead zone of slip",
    smooth "Torque rises with tanh of the slip, never sticks") "How plates stick";
  annotation(Documentation(info = "<html>
<p>See <code>Rotational.Components.FrictionClutch</code>.</p>
</html>"));
end Types;
