// error: lookup.not-a-function line 17 names u.'+'.add
package T
  encapsulated operator record R
    Real x;
    encapsulated operator '+'
      function add
        import T.R;
        input R a;
        input R b;
        output R c(x = a.x + b.x);
      algorithm
      end add;
    end '+';
  end R;
  model Test
    R u(x = 1);
    R v = u.'+'.add(u, u);
  end Test;
end T;
