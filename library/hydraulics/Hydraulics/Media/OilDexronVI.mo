within Hydraulics.Media;
package OilDexronVI "Automatic transmission fluid like Dexron VI at 40 degC"
  extends PartialOil(data = DexronVI());
  annotation(Documentation(info = "<html>
<p>Data and their sources: record <code>DexronVI</code>.</p>
</html>"));
end OilDexronVI;
