// error: unsupported.external-object line 6 names t
class Table
  extends ExternalObject;
end Table;
model Test
  Table t;
end Test;
