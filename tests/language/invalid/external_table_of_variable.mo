// error: structural.not-constant line 13 names x
class Table
  extends ExternalObject;
  function constructor
    input Real data[:, 2];
    output Table object;
  external "C" object = ModelicaStandardTables_CombiTable1D_init3(
    "NoName", "NoName", data, size(data, 1), 2, {2}, 1, 1, 1, false, ",", 0);
  end constructor;
end Table;
model Test
  Real x = time;
  Table t = Table([0, x; 1, 2]);
end Test;
