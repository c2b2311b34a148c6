within Mechanics;
package Units "Physical quantities of mechanics, all in SI units"
  type Time = Real(final quantity = "Time", final unit = "s") "Time";
  type Angle = Real(final quantity = "Angle", final unit = "rad", displayUnit = "deg") "Angle";
  type AngularVelocity = Real(final quantity = "AngularVelocity", final unit = "rad/s") "Angular velocity";
  type AngularAcceleration = Real(final quantity = "AngularAcceleration", final unit = "rad/s2")
    "Angular acceleration";
  type Torque = Real(final quantity = "Torque", final unit = "N.m") "Torque";
  type AngularMomentum = Real(final quantity = "AngularMomentum", final unit = "N.m.s") "Angular momentum";
  type TorqueRate = Real(final quantity = "TorqueRate", final unit = "N.m/s") "Torque over time";
  type Inertia = Real(final quantity = "MomentOfInertia", final unit = "kg.m2", min = 0) "Moment of inertia";
  type RotationalSpringConstant = Real(final quantity = "RotationalSpringConstant", final unit = "N.m/rad", min = 0)
    "Torsional stiffness";
  type TorsionalModulus = Real(final quantity = "TorsionalModulus", final unit = "N/rad", min = 0)
    "Torsional stiffness over a length";
  type RotationalDampingConstant = Real(
    final quantity = "RotationalDampingConstant",
    final unit = "N.m.s/rad",
    min = 0) "Torsional damping";
  type Length = Real(final quantity = "Length", final unit = "m", displayUnit = "mm") "Length";
  type Position = Real(final quantity = "Length", final unit = "m", displayUnit = "mm") "Position";
  type Velocity = Real(final quantity = "Velocity", final unit = "m/s") "Velocity";
  type Acceleration = Real(final quantity = "Acceleration", final unit = "m/s2") "Acceleration";
  type Force = Real(final quantity = "Force", final unit = "N") "Force";
  type Mass = Real(final quantity = "Mass", final unit = "kg", min = 0) "Mass";
  type TranslationalSpringConstant = Real(
    final quantity = "TranslationalSpringConstant",
    final unit = "N/m",
    displayUnit = "N/mm",
    min = 0) "Stiffness";
  type TranslationalDampingConstant = Real(
    final quantity = "TranslationalDampingConstant",
    final unit = "N.s/m",
    min = 0) "Damping";
  type ContactDampingConstant = Real(final quantity = "ContactDampingConstant", final unit = "s/m", min = 0)
    "Damping of an elastic contact, relative to its elastic force";
  type Density = Real(final quantity = "Density", final unit = "kg/m3", min = 0) "Density";
  type Energy = Real(final quantity = "Energy", final unit = "J") "Energy";
  type RotationalTime = Real(final quantity = "Time", final unit = "s/rad", min = 0)
    "Inverse of an angular velocity";
  type DragConstant = Real(final quantity = "DragConstant", final unit = "N.m.s2/rad2", min = 0)
    "Torque over speed squared";
  type Area = Real(final quantity = "Area", final unit = "m2") "Area";
  type Power = Real(final quantity = "Power", final unit = "W") "Power";
  type Ratio = Real(final quantity = "Ratio", final unit = "1") "Dimensionless ratio";
  annotation(Documentation(info = "<html>
<p>Quantity and unit are final; every variable of the library carries one of these types.</p>
</html>"));
end Units;
