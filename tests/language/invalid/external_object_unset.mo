// error: external.object line 6 names t says not constructed
class Table
  extends ExternalObject;
end Table;
model Test
  Table t;
end Test;
