// error: connect.two-sources line 25 says both feed
package Sources
  connector RealOutput = output Real;
  expandable connector Bus
  end Bus;
  block Sensor
    RealOutput y;
  equation
    y = time;
  end Sensor;
  model Part
    Bus bus;
    Sensor sensor;
  equation
    connect(sensor.y, bus.speed);
  end Part;
  model Test
    Bus bus;
    Part a;
    Part b;
    Sensor s;
  equation
    connect(s.y, bus.temperature);
    connect(a.bus, bus);
    connect(b.bus, bus);
  end Test;
end Sources;
