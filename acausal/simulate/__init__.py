"""Running a compiled system: initial problem, integration with events, results."""
