// error: lookup.unknown-class line 3 names Reall
model Test
  Reall x;
end Test;
