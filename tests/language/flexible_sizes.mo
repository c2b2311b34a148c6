// Sizes declared `:` change with each assignment in a function; constants without a value are arguments.
model Test
  function positive
    input Integer x[:];
    output Integer found[:];
  algorithm
    for i in 1:size(x, 1) loop
      if x[i] > 0 then
        found := cat(1, found, x[i:i]);
      end if;
    end for;
  end positive;

  record Pair
    Real a;
    constant Integer n;
    constant Integer m = 4;
  end Pair;

  parameter Integer x[:] = positive({-2, 1, 0, -1, 2});
  Pair p = Pair(time, 3);
end Test;
