// Partial derivatives of functions, also of higher order and of inherited or conditional bodies (12.7.2).
package T
  function gibbs
    input Real p;
    input Real T;
    output Real g;
  protected
    Real q = p ^ 2;
  algorithm
    g := if T > 300 then q * sin(T) else q * T ^ 3;
  end gibbs;
  function gibbs_T = der(gibbs, T);
  function gibbs_pT = der(gibbs, p, T);
  function gibbs_TT = der(gibbs_T, T);
  model Test
    Real a = gibbs_T(2, 3);
    Real b = gibbs_pT(time, 3);
    Real c = gibbs_TT(2, T = time);
    Real d[2] = gibbs_T({2, 3}, time);
  end Test;
end T;
