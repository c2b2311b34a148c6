within Hydraulics;
package Functions "Laws of flow that every compiler can inline and differentiate"
  annotation(Documentation(info = "<html>
<p>All are smooth for every argument: no branch, no event.</p>
</html>"));
end Functions;
