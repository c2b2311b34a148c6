package Streams "inStream and actualStream: one, two and more ports, inside and outside connectors (15)"
  connector Port
    Real p;
    flow Real m;
    stream Real h;
    stream Real X[2];
  end Port;

  model Source
    parameter Boolean backflow = true;
    Port port(m(max = 0, min = -10, nominal = 0.1));
    Real inflow = inStream(port.h);
    Real Xin[2] = inStream(port.X);
  equation
    port.p = 1;
    port.h = 10;
    port.X = {0.2, 0.8};
  end Source;

  model Sink
    parameter Boolean backflow = true;
    Port port(m(min = if backflow then -100 else 0));
    Real h = actualStream(port.h);
  equation
    port.m = 2;
    port.h = time;
    port.X = {1, 0};
  end Sink;

  model Pipe
    Port a;
    Port b;
  equation
    a.h = inStream(b.h);
    b.h = inStream(a.h);
    a.X = inStream(b.X);
    b.X = inStream(a.X);
    a.m + b.m = 0;
    a.p - b.p = a.m;
  end Pipe;

  model Shell "Its own port is an outside connector"
    Port port;
    Pipe pipe;
    Source source;
  equation
    connect(pipe.a, source.port);
    connect(pipe.b, port);
  end Shell;

  model Junction "Two parts at one outside connector: their flows mix"
    Port port;
    Sink sink;
    Pipe pipe;
  equation
    connect(port, sink.port);
    connect(port, pipe.a);
  end Junction;

  model Test
    Shell shell;
    Sink sink;
    Sink oneWay(backflow = false);
    Junction junction;
    Pipe alone "Both ends closed";
  equation
    connect(shell.port, sink.port);
    connect(shell.port, oneWay.port);
    connect(shell.port, junction.port);
  end Test;
end Streams;
