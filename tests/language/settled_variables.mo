// A variable that no later statement assigns is named where it is read: its value stands in one equation only.
model SettledVariables
  Integer count(start = 0, fixed = true) "Settled by the first statement";
  discrete Real last[3](each start = 0, each fixed = true) "Settled by the second";
  discrete Real mean(start = 0, fixed = true) "Assigned twice: settled by the last";
  Real u = time;
algorithm
  when sample(0, 0.1) then
    count := pre(count) + 1;
  end when;
  when change(count) then
    last[1] := last[2];
    last[2] := last[3];
    last[3] := u;
    mean := count;
  end when;
  when count >= 3 then
    mean := (last[1] + last[2] + last[3])/mean;
  end when;
end SettledVariables;
