// error: expandable.not-present line 16 names bus.speed[1]
package Sizeless
  connector RealOutput = output Real;
  expandable connector Bus
    Real speed[:];
  end Bus;
  block Sensor
    RealOutput y;
  equation
    y = time;
  end Sensor;
  model Test
    Bus bus;
    Sensor sensor;
    // the first element is not there
    Real y = sum(bus.speed);
  equation
    connect(sensor.y, bus.speed[2]);
  end Test;
end Sizeless;
