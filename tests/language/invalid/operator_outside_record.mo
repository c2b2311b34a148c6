// error: class.place line 3 names P.'+'
package P
  encapsulated operator '+'
    function sum
      input Real a;
      output Real b = a;
    algorithm
    end sum;
  end '+';
end P;
model Test
  Real x = P.'+'.sum(1);
end Test;
