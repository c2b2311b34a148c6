// error: call.instance-name line 4 names getInstanceName
function f
  input Real u;
  output String s = getInstanceName();
end f;
model Test
  parameter String s = f(1);
end Test;
