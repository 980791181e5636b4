"""Arithmetic with 32 digits over numpy arrays: a number is the unevaluated sum of two doubles."""
