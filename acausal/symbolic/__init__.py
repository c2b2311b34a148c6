"""The symbolic core: from FlatModel to CausalSystem."""
