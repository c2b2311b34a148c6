// error: class.component line 3 names g
package Earth
  parameter Real g = 9.81;
end Earth;
model Test
  Real x = Earth.g;
end Test;
