// error: model.not-a-model line 2 names Test
package Test
end Test;
