within Hydraulics.Components;
model Junction "Lines meet, nothing is stored"
  extends Interfaces.PartialNode(V_0 = 0);
equation
  // One pressure everywhere
  for i in 1:n loop
    port[i].p = p;
  end for;
  // Conservation of mass without storage
  sum(port.q) = 0;
  m = 0;
  annotation(Documentation(info = "<html>
<p>The flows sum to zero. Stands for a <code>Volume</code> where its pressure settles at once.</p>
</html>"));
end Junction;
