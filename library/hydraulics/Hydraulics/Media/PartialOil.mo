within Hydraulics.Media;
partial package PartialOil "What a component asks of its oil"
  constant Fluid data "Parameters of the oil";
  annotation(Documentation(info = "<html>
<p>Components have a <code>replaceable package Oil</code> of this kind, whose data are the default of their parameter
<code>fluid</code>: redeclare the package, or give the parameter. Density and bulk modulus follow from the data by
<code>Media.density</code> and <code>Media.bulkModulus</code>.</p>
</html>"));
end PartialOil;
