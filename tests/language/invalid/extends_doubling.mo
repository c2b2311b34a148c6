// error: extends.too-large line 11 names T.D4 says more than 20000
package T
  model A Real x; equation x = 1; end A;
  model B extends A; extends A; extends A; extends A; extends A; extends A; extends A; extends A; end B;
  model C extends B; extends B; extends B; extends B; extends B; extends B; extends B; extends B; end C;
  model D extends C; extends C; extends C; extends C; extends C; extends C; extends C; extends C; end D;
  model D1 extends D; extends D; end D1;
  model D2 extends D1; extends D1; end D2;
  model D3 extends D2; extends D2; end D3;
  model D4
    extends D3; extends D3; extends D3; extends D3; extends D3; extends D3; extends D3; extends D3;
  end D4;
  model Test extends D4; end Test;
end T;
