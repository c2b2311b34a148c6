// A function of the library that stops with an error is an assertion where it is reached.
package P
  function error
    input String text;
  external "C" ModelicaError(text);
  end error;
  function root
    input Real u;
    output Real y;
  algorithm
    if u < 0 then
      error("no root of " + String(u));
    end if;
    y := sqrt(abs(u));
  end root;
  model Test
    Real x = root(1 - time);
    parameter Real p = root(4);
  end Test;
end P;
