// error: unsupported.initial-terminate line 6
model Test
  Boolean b = time > 1;
equation
  when {initial(), b} then
    if b then terminate("over"); end if;
  end when;
end Test;
