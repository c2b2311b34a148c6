// error: model.partial line 2 names Test
partial model Test
end Test;
