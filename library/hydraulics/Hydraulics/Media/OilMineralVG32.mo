within Hydraulics.Media;
package OilMineralVG32 "Mineral hydraulic oil of viscosity grade 32 at 40 degC"
  extends PartialOil(data = MineralVG32());
  annotation(Documentation(info = "<html>
<p>Data and their sources: record <code>MineralVG32</code>.</p>
</html>"));
end OilMineralVG32;
