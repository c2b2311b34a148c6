"""Benchmarks: how fast, compared with what, and how it grows."""
