within Signals;
package Sources "Signals as functions of time"
  annotation(Documentation(info = "<html>
<p>Sources have no state and make no event.</p>
</html>"));
end Sources;
