// error: class.literal line 3 names start
model Test
  type Phase = enumeration(start, run, stop);
  parameter Phase p = Phase.run;
end Test;
