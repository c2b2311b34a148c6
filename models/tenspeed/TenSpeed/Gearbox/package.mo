within TenSpeed;
package Gearbox "Gearbox with elastic gearsets, clutches and their cylinders, at four levels of fidelity"
  annotation(Documentation(info = "<html>
<p>One architecture, <code>Architecture</code>; a level is a choice of its replaceable gearsets and output gear:</p>
<ol>
<li>helical gearsets with individual planets, helical output gear: 103 states,</li>
<li>gearsets with elasticity and play at the sun, helical output gear: 39 states,</li>
<li>as 2 with an ideal output gear: 37 states,</li>
<li>rigid gearsets, ideal output gear: 29 states.</li>
</ol>
</html>"));
end Gearbox;
