"""Expressions: one hash-consed scalar expression for flattening, index reduction, code and printing."""
