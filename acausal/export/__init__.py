"""A compiled model for other programs: a package of C99, and CasADi Functions with names and labels."""
