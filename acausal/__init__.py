"""A Modelica compiler: text in, a causalised system that can be run and looked at out."""
