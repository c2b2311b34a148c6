within TenSpeed;
package Interfaces "Partial base classes"
  annotation(Documentation(info = "<html>
<p>Circuits that are completed by connecting a source.</p>
</html>"));
end Interfaces;
