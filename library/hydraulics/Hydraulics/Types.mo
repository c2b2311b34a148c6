within Hydraulics;
package Types "Enumerations"
  type Direction = enumeration(
    Positive "Growing position",
    Negative "Falling position") "Direction along the axis of a spool";
  annotation(Documentation(info = "<html>
<p>Choices of the library's components.</p>
</html>"));
end Types;
