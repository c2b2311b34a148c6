within TenSpeed;
package Failures "What happens to the gearbox when something fails: the shift sweep with one thing wrong"
  annotation(Documentation(info = "<html>
<p>Each model extends <code>FailingBench</code>, which is the bench of the shift sweep with places for failures; another
level is chosen by redeclaring its gearbox. All of them run to their end.</p>
</html>"));
end Failures;
