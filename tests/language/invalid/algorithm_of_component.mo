// error: assignment.component line 9 names part.y
package P
  block Part
    Real y;
  end Part;
  model Test
    Part part;
  algorithm
    part.y := 1;
  end Test;
end P;
