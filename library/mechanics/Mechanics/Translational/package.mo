within Mechanics;
package Translational "Translation along fixed axes"
  annotation(Documentation(info = "<html>
<p>Masses and what couples them. Flange: position <code>s</code>, force <code>f</code>.</p>
</html>"));
end Translational;
