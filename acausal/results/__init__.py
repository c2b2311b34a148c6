"""Files of results: written row by row while a run goes on, and read back."""
