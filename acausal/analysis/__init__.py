"""What a compiled model is like near one point: eigenvalues, modes, step limits."""
