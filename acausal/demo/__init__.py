"""`make run`: two systems of a ten-speed transmission, compiled, simulated, plotted and checked."""
