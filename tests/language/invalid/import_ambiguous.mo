// error: import.ambiguous line 10 names c
package P
  constant Real c = 1;
end P;
package Q
  constant Real c = 2;
end Q;
model Test
  import P.*;
  import Q.*;
  Real x = c;
end Test;
