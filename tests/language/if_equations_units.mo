// Branches of an if-equation that determine different things: their equations need not have one unit.
model IfEquationsUnits
  Real u(unit = "V"), i(unit = "A"), p(unit = "W");
  parameter Real u0(unit = "V") = 12, i0(unit = "A") = 2, p0(unit = "W") = 20, r(unit = "Ohm") = 1;
  parameter Real gain(unit = "1") = -2 * u0 "A factor that carries a unit is suspect, not wrong";
equation
  p = u * i;
  u = u0 - r * i;
  if time > 2 then
    u = u0;
  elseif time > 1 then
    if time > 1.5 then
      i = i0;
    else
      p = p0;
    end if;
  else
    i = 0;
  end if;
end IfEquationsUnits;
