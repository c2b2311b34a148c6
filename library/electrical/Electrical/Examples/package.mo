within Electrical;
package Examples "One model per component, each with its closed form"
  annotation(Documentation(info = "<html>
<p>Every model has an output <code>error</code>, the difference to a closed form.</p>
</html>"));
end Examples;
