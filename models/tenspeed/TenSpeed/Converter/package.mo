within TenSpeed;
package Converter "Hydrodynamic torque converter with lock-up clutch, five levels"
  constant Mechanics.Units.Angle degree = Mechanics.Constants.pi/180 "One degree";
  annotation(Documentation(info = "<html>
<p>Level 1: four states, the speeds of impeller, turbine and stator and the flow. Level 2: the flow is steady. Level 3:
the speeds are steady, the flow is the only state. Level 4: both are steady. Level 5: a map of torque ratio and
capacity. A level is chosen by redeclaring <code>Torus</code>.</p>
<p>Laws: pump p, turbine t and stator s turn in one circuit of flow Q; exit radii R, flow area A, blade angles a at the
exits and b at the entries, shape factors S, loss factors C and f. They are written in <code>Functions</code>.</p>
</html>"));
end Converter;
