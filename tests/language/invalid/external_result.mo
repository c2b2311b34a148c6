// error: external.result line 8 names object
package T
  class Table
    extends ExternalObject;
    function constructor
      input String fileName;
      output Table made;
    external "C" object = ModelicaStandardTables_CombiTable1D_init3(fileName);
    end constructor;
    function destructor
      input Table object;
    external "C" ModelicaStandardTables_CombiTable1D_close(object);
    end destructor;
  end Table;
  function first
    input Table object;
    output Real u;
  external "C" u = ModelicaStandardTables_CombiTable1D_minimumAbscissa(object);
  end first;
  model Test
    parameter Table table = Table("NoName");
    parameter Real start = first(table);
  end Test;
end T;
