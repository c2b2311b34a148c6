// Texts: String() of every type with its options, joining and comparing, at compile time and at run time.
package P
  type Mode = enumeration(off, slow, fast);
  function label
    input String name;
    input Integer n = 1;
    output String text = name + "[" + String(n) + "]";
  end label;
  model Test
    parameter Real r = 1234.56789;
    parameter Integer i = 42;
    parameter Mode mode = Mode.slow;
    parameter String name = "tank";
    constant String plain = String(1.5) + String(7) + String(true) + String(Mode.fast);
    constant String digits = String(3.14159265, significantDigits = 3);
    constant String wide = "<" + String(7, minimumLength = 4) + "|" + String(7, 4, false) + ">";
    constant String formatted = String(3.14159265, format = "8.3f") + String(12, format = "04d");
    constant String large = String(1.0e10) + " " + String(-0.00001);
    parameter String shown = label(name, i);
    Real x = if name == "tank" and name < "tanker" then time else 0;
  equation
    assert(x < 10, name + ": x is " + String(x) + " in mode " + String(mode) + " at r = " + String(r, 2));
  end Test;
end P;
