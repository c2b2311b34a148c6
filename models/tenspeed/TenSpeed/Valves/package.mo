within TenSpeed;
package Valves "Valves of the hydraulic network, each one architecture at several levels of fidelity"
  annotation(Documentation(info = "<html>
<p>Every valve is one model with replaceable parts; <code>Levels</code> names the choices. Level 1 is the finest. Each
stands alone on a bench in <code>TenSpeed.Benches</code>.</p>
</html>"));
end Valves;
