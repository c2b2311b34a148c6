within Hydraulics;
package Media "Oil with entrained air at constant temperature"
  annotation(Documentation(info = "<html>
<p>The parameters of an oil are a record; <code>density</code> and <code>bulkModulus</code> are the two consistent
functions of pressure that follow from it.</p>
</html>"));
end Media;
