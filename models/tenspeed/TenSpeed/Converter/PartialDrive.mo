within TenSpeed.Converter;
partial model PartialDrive "What stands at one shaft"
  Shaft shaft "Shaft";
  annotation(Documentation(info = "<html>
<p>Base of the sources at a shaft: they differ in what they prescribe.</p>
</html>"));
end PartialDrive;
