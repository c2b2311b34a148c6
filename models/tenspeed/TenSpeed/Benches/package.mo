within TenSpeed;
package Benches "Test benches"
  annotation(Documentation(info = "<html>
<p>Complete models: a part of the transmission with sources for everything around it.</p>
</html>"));
end Benches;
