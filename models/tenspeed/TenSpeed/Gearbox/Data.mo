within TenSpeed.Gearbox;
package Data "Numbers of teeth of the four gearsets, and what the torque bench measured on them"
  constant GearsetData P1 = GearsetData(
    Z_s = 42,
    Z_p = 44,
    Z_r = 130,
    c_lumped = 8326,
    d_lumped = 0.5362,
    b_lumped = 0.003441) "Gearset P1";
  constant GearsetData P2 = GearsetData(
    Z_s = 43,
    Z_p = 19,
    Z_r = 81,
    c_lumped = 8727,
    d_lumped = 0.5621,
    b_lumped = 0.003361) "Gearset P2";
  constant GearsetData P3 = GearsetData(
    Z_s = 37,
    Z_p = 33,
    Z_r = 103,
    c_lumped = 6462,
    d_lumped = 0.4162,
    b_lumped = 0.003906) "Gearset P3";
  constant GearsetData P4 = GearsetData(
    Z_s = 48,
    Z_p = 14,
    Z_r = 76,
    c_lumped = 1.088e+04,
    d_lumped = 0.7004,
    b_lumped = 0.003011) "Gearset P4";
  annotation(Documentation(info = "<html>
<p>Lumped stiffness, damping and play are those that <code>Benches.GearsetTorque</code> measures at the sun of the
helical gearset with these values, carrier and ring held: for N planets in parallel, each with two meshes and a bearing
in series, c = N R_s<sup>2</sup> / (2 / (c_mesh cos(alpha_t)<sup>2</sup>) + 4 / c_bearing), likewise d, and
b = 2 (b_mesh + b_bearing) / R_s.</p>
</html>"));
end Data;
