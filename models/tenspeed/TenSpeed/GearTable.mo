within TenSpeed;
package GearTable "Which elements are engaged in which gear, and the ratio that results"
  constant Boolean engaged[11, 7] = {
    {false, false, false, true, true, false, true},
    {false, true, false, true, true, false, false},
    {false, false, true, true, true, false, false},
    {false, true, true, true, false, false, false},
    {true, false, true, true, false, false, false},
    {true, true, true, false, false, false, false},
    {true, false, true, false, true, false, false},
    {true, true, false, false, true, false, false},
    {true, false, false, false, true, true, false},
    {true, true, false, false, false, true, false},
    {false, false, true, false, true, false, true}}
    "Rows: gears 1 to 10, reverse. Columns: C1, C2, C3, B1, B2, B3, F1";
  constant Mechanics.Units.Ratio ratio[11] =
    {5.246, 3.271, 2.185, 1.597, 1.304, 1.000, 0.782, 0.653, 0.581, 0.517, -3.974}
    "Speed of body 1 over speed of body 8; rows as above";
  annotation(Documentation(info = "<html>
<p>Each step between adjacent gears exchanges exactly one element.</p>
</html>"));
end GearTable;
