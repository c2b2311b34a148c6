// error: external.failed line 14 says strictly
class Table
  extends ExternalObject;
  function constructor
    input Real data[:, 2];
    output Table object;
  external "C" object = ModelicaStandardTables_CombiTable1D_init3(
    "NoName", "NoName", data, size(data, 1), 2, {2}, 1, 1, 1, false, ",", 0);
  end constructor;
end Table;
function value input Table t; input Real u; output Real y;
external "C" y = ModelicaStandardTables_CombiTable1D_getValue(t, 1, u); end value;
model Test
  parameter Table t = Table([0, 1; 0, 2]);
  Real y = value(t, time);
end Test;
