"""Code generation: from a CausalSystem to compiled CasADi functions."""
