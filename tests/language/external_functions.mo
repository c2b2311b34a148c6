// External functions of the table: strings, random numbers, matrices, at compile time and at events.
package P
  type Compare = enumeration(Less, Equal, Greater);
  function length
    input String text;
    output Integer n;
  external "C" n = ModelicaStrings_length(text);
  end length;
  function compare
    input String a;
    input String b;
    input Boolean caseSensitive = true;
    output Compare result;
  external "C" result = ModelicaStrings_compare(a, b, caseSensitive);
  end compare;
  function scanReal
    input String text;
    input Integer start = 1;
    output Integer next;
    output Real number;
  external "C" ModelicaStrings_scanReal(text, start, false, next, number);
  end scanReal;
  function random
    input Integer state[2];
    output Real r;
    output Integer new[2];
  external "C" ModelicaRandom_xorshift64star(state, new, r);
  end random;
  function solve
    input Real A[:, size(A, 1)];
    input Real b[size(A, 1)];
    output Real x[size(A, 1)] = b;
    output Integer info;
  protected
    Real work[size(A, 1), size(A, 1)] = A;
    Integer pivots[size(A, 1)];
    Integer n = size(A, 1);
  external "FORTRAN 77" dgesv(n, 1, work, n, pivots, x, n, info);
  end solve;
  model Test
    parameter String name = "abc";
    parameter Integer n = length(name);
    parameter Boolean same = compare(name, "ABC", false) == Compare.Equal;
    parameter Real x[2] = solve([2, 1; 1, 3], {3, 5});
    parameter Real r = random({1, 0});
    Real v[n];
    Real read;
    Integer next;
  equation
    v = fill(time, n);
    (next, read) = scanReal("  2.5;");
  end Test;
end P;
