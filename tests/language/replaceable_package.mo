// A redeclared package brings its constants and functions; two variants do not mix.
package Medium
  constant Real rho = 1000;
  replaceable function density
    input Real p;
    output Real d;
  algorithm
    d := rho;
  end density;
end Medium;
package Oil
  extends Medium(rho = 850);
  redeclare function density
    input Real p;
    output Real d;
  algorithm
    d := rho * (1 + p);
  end density;
end Oil;
model Tank
  replaceable package M = Medium constrainedby Medium;
  Real d = M.density(time);
  Real r = M.rho;
end Tank;
model Test
  Tank water;
  Tank oil(redeclare package M = Oil);
  Tank heavy(redeclare package M = Medium(rho = 2000));
end Test;
