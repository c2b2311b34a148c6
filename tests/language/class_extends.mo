package Extending "redeclare model extends: the inherited class is extended under its name (7.3.1)"
  package Base
    replaceable record State
      Real p;
    end State;
    replaceable partial function density
      input State state;
      output Real d;
    end density;
    replaceable model Properties
      parameter Real k = 1;
      State state;
      Real d = density(state);
    end Properties;
  end Base;

  package Middle
    extends Base;
    redeclare replaceable record extends State
      Real T;
    end State;
    redeclare replaceable function extends density
    algorithm
      d := state.p / state.T;
    end density;
    redeclare replaceable model extends Properties(k = 2)
    equation
      state.p = k;
    end Properties;
  end Middle;

  package Upper
    extends Middle;
    redeclare model extends Properties "Stands on that of Middle"
      Real h;
    equation
      state.T = time;
      h = 3 * d;
    end Properties;
  end Upper;

  model User
    replaceable package Medium = Base;
    Medium.Properties medium;
  end User;

  model Test
    Upper.Properties first;
    User second(redeclare package Medium = Upper, medium(k = 5));
  end Test;
end Extending;
