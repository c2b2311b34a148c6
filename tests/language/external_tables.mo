// External objects: tables, their functions, and what is known of them when the model is compiled.
package P
  type Smoothness = enumeration(Linear, Akima, Constant, FritschButland, Steffen, Modified);
  type Extrapolation = enumeration(Hold, LastTwoPoints, Periodic, None);
  class Table
    extends ExternalObject;
    function constructor
      input String tableName;
      input String fileName;
      input Real table[:, :];
      input Integer columns[:];
      input Smoothness smoothness;
      input Extrapolation extrapolation = Extrapolation.LastTwoPoints;
      output Table object;
    external "C" object = ModelicaStandardTables_CombiTable1D_init3(
        fileName, tableName, table, size(table, 1), size(table, 2), columns, size(columns, 1), smoothness,
        extrapolation, false, ",", 0);
    end constructor;
    function destructor
      input Table object;
    external "C" ModelicaStandardTables_CombiTable1D_close(object);
    end destructor;
  end Table;
  function value
    input Table object;
    input Integer column;
    input Real u;
    output Real y;
  external "C" y = ModelicaStandardTables_CombiTable1D_getValue(object, column, u);
  end value;
  function slope
    input Table object;
    input Integer column;
    input Real u;
    input Real der_u;
    output Real y;
  external "C" y = ModelicaStandardTables_CombiTable1D_getDerValue(object, column, u, der_u);
  end slope;
  function first
    input Table object;
    output Real u;
  external "C" u = ModelicaStandardTables_CombiTable1D_minimumAbscissa(object);
  end first;
  model Lookup
    parameter Real data[:, :] = [0, 1; 1, 3; 2, 4];
    parameter Extrapolation outside = Extrapolation.LastTwoPoints;
    parameter Table table = Table("NoName", "NoName", data, {2}, Smoothness.Linear, outside);
    input Real u;
    output Real y = value(table, 1, u);
  end Lookup;
  model Test
    Lookup a(u = time);
    Lookup b(u = 2 * a.y, data = [5, 0; 6, 1], outside = Extrapolation.None);
    Real s = slope(a.table, 1, time, 1);
    parameter Real start = first(b.table);
    parameter Real middle = value(a.table, 1, 1.5);
  end Test;
end P;
