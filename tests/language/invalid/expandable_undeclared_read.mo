// error: lookup.unknown-name line 15 names bus.speed
package Reading
  connector RealOutput = output Real;
  expandable connector Bus
  end Bus;
  block Sensor
    RealOutput y;
  equation
    y = time;
  end Sensor;
  model Test
    Bus bus;
    Sensor sensor;
    // only connections may name what is not declared
    Real y = bus.speed;
  equation
    connect(sensor.y, bus.speed);
  end Test;
end Reading;
