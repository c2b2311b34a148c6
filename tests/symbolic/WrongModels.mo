package WrongModels "Models that an engineer gets wrong, each in one way; test_wrong_models.py says what is to be said"
  connector Pin "Electrical"
    Real v;
    flow Real i;
  end Pin;
  partial model TwoPin "Current through two pins"
    Pin p, n;
    Real v, i;
  equation
    v = p.v - n.v;
    0 = p.i + n.i;
    i = p.i;
  end TwoPin;
  model Resistor
    extends TwoPin;
    parameter Real R = 1;
  equation
    v = R * i;
  end Resistor;
  model Capacitor
    extends TwoPin;
    parameter Real C = 1;
  equation
    C * der(v) = i;
  end Capacitor;
  model Voltage
    extends TwoPin;
    parameter Real V = 1;
  equation
    v = V;
  end Voltage;
  model Current
    extends TwoPin;
    parameter Real I = 1;
  equation
    i = I;
  end Current;
  model Ground
    Pin p;
  equation
    p.v = 0;
  end Ground;
  connector Flange "Rotational"
    Real phi;
    flow Real tau;
  end Flange;
  model Inertia
    Flange a, b;
    parameter Real J = 1;
    Real phi, w;
  equation
    phi = a.phi;
    phi = b.phi;
    w = der(phi);
    J * der(w) = a.tau + b.tau;
  end Inertia;
  model Speed "Prescribes the speed"
    Flange f;
    Real phi, w;
  equation
    phi = f.phi;
    w = der(phi);
  end Speed;
  model ConstantSpeed
    extends Speed;
    parameter Real w0 = 1;
  equation
    w = w0;
  end ConstantSpeed;
  model Torque
    Flange f;
    parameter Real tau = 1;
  equation
    f.tau = -tau;
  end Torque;
  model Gear
    Flange a, b;
    parameter Real i = 2;
  equation
    a.phi = i * b.phi;
    0 = i * a.tau + b.tau;
  end Gear;
  connector Port "Hydraulic"
    Real p;
    flow Real q;
  end Port;
  model Pressure
    Port a;
    parameter Real P = 1e5;
  equation
    a.p = P;
  end Pressure;
  model Flow
    Port a;
    parameter Real Q = 1e-3;
  equation
    a.q = -Q;
  end Flow;
  model Pipe
    Port a, b;
    parameter Real R = 1e9;
  equation
    a.p - b.p = R * a.q;
    a.q + b.q = 0;
  end Pipe;
  model NoGround
    Voltage s; Resistor r;
  equation
    connect(s.p, r.p); connect(s.n, r.n);
  end NoGround;
  model TwoVoltages
    Voltage s(V = 1), t(V = 2); Ground g;
  equation
    connect(s.p, t.p); connect(s.n, t.n); connect(s.n, g.p);
  end TwoVoltages;
  model TwoCurrents
    Current s(I = 1), t(I = 2); Ground g;
  equation
    connect(s.n, t.p); connect(s.p, g.p); connect(t.n, g.p);
  end TwoCurrents;
  model FloatingIsland
    Current s; Capacitor c; Ground g; Resistor r;
  equation
    connect(s.p, c.p); connect(s.n, c.n); connect(r.p, g.p); connect(r.n, g.p);
  end FloatingIsland;
  model TwoSpeeds
    ConstantSpeed s, t(w0 = 2); Inertia j;
  equation
    connect(s.f, j.a); connect(j.b, t.f);
  end TwoSpeeds;
  model TwoPressures
    Pressure s, t(P = 2e5);
  equation
    connect(s.a, t.a);
  end TwoPressures;
  model TwoFlows
    Flow s, t;
  equation
    connect(s.a, t.a);
  end TwoFlows;
  model OpenPipe
    Pipe pipe; Flow s;
  equation
    connect(s.a, pipe.a);
  end OpenPipe;
  model OpenTorque
    Torque t;
  end OpenTorque;
  model ForgottenEquation
    Voltage s; Ground g; Real power, eff;
  equation
    connect(s.n, g.p); power = s.v * s.i;
  end ForgottenEquation;
  model ExtraEquation
    Voltage s; Resistor r; Ground g;
  equation
    connect(s.p, r.p); connect(s.n, r.n); connect(s.n, g.p); r.i = 3;
  end ExtraEquation;
  model EquationWithoutUnknown
    parameter Real p = 3; Real x;
  equation
    der(x) = -x; p = 4;
  end EquationWithoutUnknown;
  model SameTwice
    Real a, b;
  equation
    a = 2 * b; 2 * a - 4 * b = 1;
  end SameTwice;
  model SingularByValue
    parameter Real a = 2; Real x, y;
  equation
    x + a * y = 1; 2 * x + 4 * y = 3;
  end SingularByValue;
  model NothingSaid
    Real x;
  equation
    x = x;
  end NothingSaid;
  model ZeroResistance
    Resistor r(R = 0); Voltage s; Ground g;
  equation
    connect(s.p, r.p); connect(s.n, r.n); connect(s.n, g.p);
  end ZeroResistance;
  model NoRoot
    Real x;
  equation
    x^2 + 1 = 0;
  end NoRoot;
  model DrivenByInput
    Inertia j; DrivenSpeed s; input Real u;
  equation
    connect(s.f, j.a); s.w = u;
  end DrivenByInput;
  model DrivenByJump
    Inertia j; DrivenSpeed s;
  equation
    connect(s.f, j.a); s.w = if time > 0.5 then 1 else 0;
  end DrivenByJump;
  model DrivenBySign
    Inertia j; DrivenAngle s;
  equation
    connect(s.f, j.a); s.phi = sign(sin(time));
  end DrivenBySign;
  model DrivenByStairs
    Real x, v;
  equation
    x = floor(10 * time); v = der(x);
  end DrivenByStairs;
  model GearLoop
    Gear g, h; Inertia j, k;
  equation
    connect(j.b, g.a); connect(g.b, k.a); connect(j.b, h.a); connect(h.b, k.a);
  end GearLoop;
  model TwoStarts
    Capacitor c(v(start = 1, fixed = true)), d(v(start = 2, fixed = true)); Ground g;
  equation
    connect(c.p, d.p); connect(c.n, d.n); connect(c.n, g.p);
  end TwoStarts;
  model StartsThroughGear
    Gear g; Inertia j(phi(start = 1, fixed = true)), k(phi(start = 1, fixed = true));
  equation
    connect(j.b, g.a); connect(g.b, k.a);
  end StartsThroughGear;
  model StartOffTheCircle
    Real x(start = 2, fixed = true), y(start = 0), u, v, f;
  equation
    der(x) = u; der(y) = v; der(u) = -f * x; der(v) = -f * y - 9.81; x^2 + y^2 = 1;
  end StartOffTheCircle;
  model TwoInitialEquations
    Real x;
  equation
    der(x) = -x;
  initial equation
    x = 1; x = 2;
  end TwoInitialEquations;
  model StartOfAConstant
    Real x(start = 1, fixed = true);
  equation
    x = 3;
  end StartOfAConstant;
  model CyclicParameters
    parameter Real a = b + 1; parameter Real b = 2 * a; Real x;
  equation
    der(x) = a;
  end CyclicParameters;
  model ParameterWithoutValue
    parameter Real p; Real x;
  equation
    der(x) = p;
  end ParameterWithoutValue;
  model RootOfNegative
    Real x(start = 1, fixed = true), y;
  equation
    der(x) = -2; y = sqrt(x);
  end RootOfNegative;
  model AlwaysAState
    Real x(stateSelect = StateSelect.always), y;
  equation
    x = 2 * y; y = time;
  end AlwaysAState;
  model NeverAState
    Real x(stateSelect = StateSelect.never), y(stateSelect = StateSelect.never), z;
  equation
    der(x) = 1; z = 2 * y; der(z) = der(y) + x;
  end NeverAState;
  model TwoValues
    Real a, b, c;
  equation
    a = 1; b = 2; a = c; c = b;
  end TwoValues;
  model ForgottenInput
    DrivenSpeed s; Inertia j;
  equation
    connect(s.f, j.a);
  end ForgottenInput;
  model DrivenSpeed "Takes the speed from outside"
    Flange f; Real phi; input Real w;
  equation
    phi = f.phi; w = der(phi);
  end DrivenSpeed;
  model DrivenAngle "Takes the angle from outside"
    Flange f; input Real phi;
  equation
    phi = f.phi;
  end DrivenAngle;
end WrongModels;
