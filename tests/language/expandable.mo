package Buses "Expandable connectors: what connections add, through several levels (9.1.3)"
  connector RealInput = input Real;
  connector RealOutput = output Real;

  connector Pin
    Real v;
    flow Real i;
  end Pin;

  expandable connector CylinderBus
    Real spark;
    Real unused "Never present";
  end CylinderBus;

  expandable connector EngineBus
    Real speed(unit = "rad/s") "Declared, made present by a connection";
    Real levels[:] "Of unknown size";
    Real never;
  end EngineBus;

  block Sensor
    parameter Real k = 1;
    RealOutput y;
  equation
    y = k * time;
  end Sensor;

  block Actuator
    RealInput u;
    Real x = 2 * u;
  end Actuator;

  model Ground
    Pin p;
  equation
    p.v = 0;
  end Ground;

  model Load
    Pin p;
  equation
    p.i = time;
  end Load;

  model Cylinder
    CylinderBus bus;
    Actuator plug;
    Sensor pressure(k = 5);
  equation
    connect(plug.u, bus.spark);
    connect(pressure.y, bus.pressure);
  end Cylinder;

  model Engine
    EngineBus bus;
    Sensor speed;
    Cylinder cylinder[2];
    Ground ground;
  equation
    connect(speed.y, bus.speed);
    for i in 1:2 loop
      connect(cylinder[i].bus, bus.cylinder[i]);
    end for;
    connect(ground.p, bus.ground);
  end Engine;

  model Control
    EngineBus bus;
    Actuator actuator;
    Sensor sparks[2](k = {3, 4});
    Sensor level;
    Load load;
    Real read = bus.speed;
  equation
    connect(bus.speed, actuator.u);
    connect(sparks[1].y, bus.cylinder[1].spark);
    connect(sparks[2].y, bus.cylinder[2].spark);
    connect(level.y, bus.levels[3]);
    connect(sparks.y, bus.sparks);
    connect(bus.ground, load.p);
  end Control;

  model Test
    Engine engine;
    Control control;
    EngineBus bus;
    Sensor own;
  equation
    connect(engine.bus, bus);
    connect(bus, control.bus);
    connect(own.y, bus.own);
  end Test;
end Buses;
