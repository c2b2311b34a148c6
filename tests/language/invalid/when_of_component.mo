// error: assignment.component line 10 names part.y says belongs to the component
package P
  model Part
    Real y;
  end Part;
  model Test
    Part part;
  equation
    when time > 1 then
      part.y = 1;
    end when;
  end Test;
end P;
