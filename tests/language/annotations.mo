// The experiment is kept; other annotations stay in the syntax tree.
model Test "a model with an annotation"
  Real x = time "the time" annotation(Dialog(group = "none"));
  annotation(experiment(StopTime = 2.5, Tolerance = 1e-8), Documentation(info = "text"));
end Test;
