model Test "Nobody declares the inner one: it is the model's own"
  outer Integer k;
  Real x = k;
end Test;
