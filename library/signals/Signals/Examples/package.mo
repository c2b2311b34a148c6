within Signals;
package Examples "Models to run, each a test of a block"
  annotation(Documentation(info = "<html>
<p>Variable <code>error</code> is the difference to the closed form.</p>
</html>"));
end Examples;
