"""What many runs, or the figures of one run, say about a model."""
