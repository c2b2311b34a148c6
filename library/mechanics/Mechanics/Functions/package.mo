within Mechanics;
package Functions "Small functions that every compiler can inline and differentiate"
  annotation(Documentation(info = "<html>
<p>Ramps that may be prescribed as motions or pressures, and the law of elastic contact.</p>
</html>"));
end Functions;
