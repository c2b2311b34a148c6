within Hydraulics.Interfaces;
partial model PartialSource "Boundary with one port"
  Port port "Port";
  annotation(Documentation(info = "<html>
<p>Base of sources and reservoirs.</p>
</html>"));
end PartialSource;
